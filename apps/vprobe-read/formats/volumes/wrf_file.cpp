// After the "WRF Users' Guide", chapter 5, and its "List of Fields".
#include "wrf_file.h"

#include "cf_values.h"
#include "vprobe-read/base/is_one_of.h"

#include <charconv>
#include <chrono>

namespace vp::reader::volumes
{

namespace
{

constexpr std::string_view kStaggered = "_stag";
constexpr double kWrfGravity = 9.81; // the model's own
constexpr std::size_t kMaxWrfTimes = 1 << 20;

// Days and minutes of "2005-08-28_12:00:00", in minutes.
std::optional<double> minutesOf(std::string_view text)
{
	constexpr std::string_view pattern = "0000-00-00_00:00:00";
	if (text.size() != pattern.size())
		return std::nullopt;
	std::array<int, 6> parts = {};
	std::size_t part = 0;
	for (std::size_t at = 0; at < pattern.size(); ++at)
	{
		const bool is_digit = text[at] >= '0' && text[at] <= '9';
		if (is_digit != (pattern[at] == '0'))
			return std::nullopt;
		if (!is_digit)
			++part;
		else
			parts[part] = 10 * parts[part] + (text[at] - '0');
	}
	const std::chrono::year_month_day date(std::chrono::year(parts[0]),
	                                       std::chrono::month(static_cast<unsigned>(parts[1])),
	                                       std::chrono::day(static_cast<unsigned>(parts[2])));
	if (!date.ok())
		return std::nullopt;
	const auto days = std::chrono::sys_days(date).time_since_epoch().count();
	return 1440.0 * static_cast<double>(days) + 60.0 * parts[3] + parts[4] + parts[5] / 60.0;
}

// All of PH or PHB at a step, with as many layers of sides as there are layers of cells, and one more.
std::vector<double> geopotential(const hdf5::NetcdfFile& file, const char* name, const CfVolumes& volumes,
                                 std::size_t step)
{
	const int variable = file.variable(name);
	const auto sides = variable < 0 ? decltype(file.dimensions(0))() : file.dimensions(variable);
	const bool fits = sides.size() == 4 && isOneOf(sides[0].first, {"Time"}) &&
	                  sides[1].first == volumes.axes[2].name + std::string(kStaggered) &&
	                  sides[2].first == volumes.axes[1].name && sides[3].first == volumes.axes[0].name &&
	                  sides[1].second == volumes.axes[2].length + 1 && sides[0].second > 0;
	if (!fits)
		return {};
	CfSlab slab = CfSlab::of(file, variable);
	slab.fix(0, std::min(step, sides[0].second - 1));
	return cfNumbers(file, variable, slab);
}

} // namespace

bool isWrf(const hdf5::NetcdfFile& file)
{
	return file.length("west_east") > 0 && file.length("south_north") > 0 && file.length("bottom_top") > 0;
}

bool isStaggered(const std::string& dimension)
{
	return dimension.ends_with(kStaggered);
}

std::string withoutStaggering(const std::string& dimension)
{
	return isStaggered(dimension) ? dimension.substr(0, dimension.size() - kStaggered.size()) : dimension;
}

WrfPlaces wrfPlaces(const hdf5::NetcdfFile& file)
{
	for (const auto& [x, y] : {std::pair{"XLONG", "XLAT"}, {"XLONG_M", "XLAT_M"}})
		if (const WrfPlaces places{file.variable(x), file.variable(y)}; places.x >= 0 && places.y >= 0)
			return places;
	return {};
}

WrfTimes wrfTimes(const hdf5::NetcdfFile& file)
{
	const int variable = file.variable("Times");
	const auto sides = variable < 0 ? decltype(file.dimensions(0))() : file.dimensions(variable);
	nc_type type = NC_NAT;
	if (sides.size() != 2 || sides[0].second > kMaxWrfTimes || sides[1].second != 19 ||
	    nc_inq_vartype(file.id(), variable, &type) != NC_NOERR || type != NC_CHAR)
		return {};
	std::string text(sides[0].second * sides[1].second, '\0');
	hdf5::NetcdfFile::check(nc_get_var_text(file.id(), variable, text.data()));
	WrfTimes times;
	for (std::size_t at = 0; at < text.size(); at += 19)
	{
		const std::optional<double> minutes = minutesOf(std::string_view(text).substr(at, 19));
		if (!minutes)
			return {};
		times.minutes.push_back(*minutes);
	}
	if (times.minutes.empty())
		return times;
	for (std::size_t i = times.minutes.size(); i-- > 0;)
		times.minutes[i] -= times.minutes[0];
	times.first = text.substr(0, 19);
	times.first[10] = ' ';
	return times;
}

std::optional<std::vector<double>> wrfHeights(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step)
{
	if (!isWrf(file))
		return std::nullopt;
	std::vector<double> sides = geopotential(file, "PH", volumes, step);
	const std::vector<double> base = geopotential(file, "PHB", volumes, step);
	if (sides.empty() || sides.size() != base.size())
		return std::nullopt;
	for (std::size_t i = 0; i < sides.size(); ++i)
		sides[i] = (sides[i] + base[i]) / kWrfGravity;
	const std::size_t layer = volumes.axes[0].length * volumes.axes[1].length;
	std::vector<double> middles(sides.size() - layer);
	for (std::size_t i = 0; i < middles.size(); ++i)
		middles[i] = 0.5 * (sides[i] + sides[i + layer]);
	return middles;
}

} // namespace vp::reader::volumes
