#pragma once

#include <array>
#include <vector>

struct BoxFace
{
	std::array<int, 4> corners;
	std::array<int, 2> cells = {-1, -1};
};

// Each face of the box's cells once, those inside first. Its corners turn right about the way into its first cell.
std::vector<BoxFace> facesOfBox();
