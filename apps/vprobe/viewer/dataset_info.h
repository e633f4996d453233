#pragma once

#include "grid/memory.h"
#include "session/session.h"

#include <string>
#include <utility>
#include <vector>

namespace vp::app
{

// What a window tells of the data that it shows. A copy: the session itself belongs to the thread that cuts.
struct DatasetInfo
{
	struct Array
	{
		std::string word; // as --array takes it: point:NAME, cell:NAME
		std::string name;
		grid::Association association = grid::Association::point;
		int components = 1;
	};
	static bool isVector(const Array& array) { return array.components == 3; }

	std::vector<std::string> inputs;
	std::string kind; // of the grid, as info tells it
	std::size_t cells = 0;
	std::size_t points = 0;
	std::size_t blocks = 0;
	Box bounds;
	std::vector<Vec3> extent; // close around the data: what a camera is to hold
	std::vector<Array> arrays;
	std::vector<double> times; // ascending; empty where the input knows none
	std::vector<std::string> patches;
	grid::Memory memory; // of the blocks, when they had been loaded
	std::string device;
	std::string classifier;  // gpu or cpu
	bool structured = false; // has subscripts i, j, k
};

DatasetInfo factsOf(const session::Session& session, const std::vector<std::string>& inputs);

} // namespace vp::app
