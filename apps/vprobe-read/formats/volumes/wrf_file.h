#pragma once

#include "cf_volumes.h"

#include <optional>
#include <vector>

namespace vp::reader::volumes
{

// The weather model WRF says these things in its own way, and not by the CF conventions.

bool isWrf(const hdf5::NetcdfFile& file);

// Between the middles of cells along this dimension lie their sides: "west_east_stag".
bool isStaggered(const std::string& dimension);
std::string withoutStaggering(const std::string& dimension);

// The variables with the longitudes and latitudes of the dimensions, by WRF's names; -1 where there are none.
struct WrfPlaces
{
	int x = -1, y = -1;
};
WrfPlaces wrfPlaces(const hdf5::NetcdfFile& file);

// Minutes since the first of its times, which are written as texts ("2005-08-28_12:00:00"). Nothing where it has none,
// or others.
struct WrfTimes
{
	std::vector<double> minutes;
	std::string first; // "2005-08-28 12:00:00"
};
WrfTimes wrfTimes(const hdf5::NetcdfFile& file);

// The heights in meters of the middles of cells at a step, x fastest: (PH + PHB) / 9.81. Nothing where it has none.
std::optional<std::vector<double>> wrfHeights(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step);

} // namespace vp::reader::volumes
