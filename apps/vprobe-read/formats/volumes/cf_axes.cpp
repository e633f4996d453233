#include "cf_axes.h"

#include "cf_values.h"
#include "vprobe-read/base/is_one_of.h"

#include <cctype>

namespace vp::reader::volumes
{

namespace
{

std::string lowered(std::string text)
{
	for (char& c : text)
		c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
	return text;
}

bool isEast(std::string_view units)
{
	return isOneOf(units, {"degrees_east", "degree_east", "degree_e", "degrees_e", "degreee", "degreese"});
}

bool isNorth(std::string_view units)
{
	return isOneOf(units, {"degrees_north", "degree_north", "degree_n", "degrees_n", "degreen", "degreesn"});
}

// Pressures, and numbers of levels.
bool isOfHeight(std::string_view units)
{
	return isOneOf(units, {"pa", "hpa", "kpa", "mbar", "mb", "millibar", "millibars", "bar", "bars", "dbar", "decibar",
	                       "decibars", "pascal", "pascals", "atm", "atmosphere", "level", "layer", "sigma_level"});
}

bool isNameOfHeight(std::string_view standard)
{
	return isOneOf(standard, {"height", "altitude", "depth", "air_pressure", "model_level_number",
	                          "height_above_geopotential_datum", "height_above_reference_ellipsoid",
	                          "height_above_mean_sea_level", "geopotential_height", "depth_below_geoid",
	                          "depth_below_sea_floor", "sea_water_pressure"}) ||
	       ((standard.starts_with("atmosphere_") || standard.starts_with("ocean_")) &&
	        standard.ends_with("_coordinate"));
}

} // namespace

CfRole cfRoleOf(const hdf5::NetcdfFile& file, int variable)
{
	const std::string axis = lowered(file.text(variable, "axis"));
	if (axis.size() == 1 && std::string_view("xyzt").find(axis[0]) != std::string_view::npos)
		return axis == "x" ? CfRole::x : axis == "y" ? CfRole::y : axis == "z" ? CfRole::z : CfRole::time;
	const std::string units = lowered(file.text(variable, "units"));
	const std::string standard = lowered(file.text(variable, "standard_name"));
	if (isEast(units) || isOneOf(standard, {"longitude", "grid_longitude", "projection_x_coordinate"}))
		return CfRole::x;
	if (isNorth(units) || isOneOf(standard, {"latitude", "grid_latitude", "projection_y_coordinate"}))
		return CfRole::y;
	if (units.find(" since ") != std::string::npos || standard == "time")
		return CfRole::time;
	if (isNameOfHeight(standard) || isOneOf(lowered(file.text(variable, "positive")), {"up", "down"}) ||
	    isOfHeight(units))
		return CfRole::z;
	return CfRole::none;
}

CfRole cfRoleOfName(const std::string& given)
{
	const std::string name = lowered(given);
	if (isOneOf(name, {"x", "lon", "longitude"}))
		return CfRole::x;
	if (isOneOf(name, {"y", "lat", "latitude"}))
		return CfRole::y;
	if (isOneOf(name, {"z", "lev", "level", "depth", "height", "altitude"}))
		return CfRole::z;
	return isOneOf(name, {"t", "time", "times"}) ? CfRole::time : CfRole::none;
}

bool isLongitude(const hdf5::NetcdfFile& file, int variable)
{
	return isEast(lowered(file.text(variable, "units"))) ||
	       isOneOf(lowered(file.text(variable, "standard_name")), {"longitude", "grid_longitude"});
}

CfDimension cfDimension(const hdf5::NetcdfFile& file, const std::string& name, std::size_t length)
{
	CfDimension dimension{name, length};
	const int variable = file.variable(name.c_str());
	if (variable >= 0 && file.dimensions(variable).size() == 1 && file.dimensions(variable)[0].first == name &&
	    cfTypeOf(file, variable) != 0)
	{
		dimension.coordinate = variable;
		dimension.role = cfRoleOf(file, variable);
	}
	return dimension;
}

} // namespace vp::reader::volumes
