#pragma once

#include "cf_volumes.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// Heights that differ from column to column.
struct CfHeights
{
	std::vector<double> places; // for each point, x fastest
	std::string units;
};

// Heights by the formula that the axis z names (CF conventions, appendix D: ocean_sigma_coordinate,
// ocean_s_coordinate, _g1 and _g2, atmosphere_hybrid_height_coordinate), and those of WRF. Nothing where the file has
// none. Throws a Refusal where terms do not fit.
std::optional<CfHeights> cfHeights(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step);

// Whether the axis z has a formula that is not known; then its numbers are shown.
std::string unknownFormula(const hdf5::NetcdfFile& file, const CfVolumes& volumes);

} // namespace vp::reader::volumes
