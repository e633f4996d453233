#pragma once

#include "cf_axes.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// A variable over three axes of space.
struct CfVolume
{
	int variable = -1;
	std::string name;
	std::array<std::size_t, 3> sides{}; // which of its dimensions run along x, y and z
	std::optional<std::size_t> time;    // which one is time
	// The axis along which its values lie on the sides of cells, one more than there are cells.
	std::optional<std::size_t> staggered;
};

// The variables of a file that share the axes of the first with most dimensions. Others would be a second grid in the
// same place.
struct CfVolumes
{
	std::array<CfDimension, 3> axes; // x, y, z
	std::optional<CfDimension> time;
	std::vector<CfVolume> all;
	std::vector<std::string> notes; // about those left out
	// Variables with the longitudes and latitudes, or the x and y, of two of the axes; -1 where there are none.
	int x_places = -1, y_places = -1;
};

// Throws a Refusal where there are none.
CfVolumes cfVolumes(const hdf5::NetcdfFile& file);

} // namespace vp::reader::volumes
