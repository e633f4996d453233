#include "tiff_layout.h"

#include "base/real_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/json_text.h"
#include "vprobe-read/text/length_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::volumes
{

namespace
{

constexpr std::uint64_t kMaxPlanes = 1 << 24;

// The value behind "key=" on a line of its own; empty where there is none.
std::string valueOfLine(std::string_view text, std::string_view key)
{
	for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1))
		if (at > 0 && text[at - 1] == '\n' && at + key.size() < text.size() && text[at + key.size()] == '=')
		{
			const std::string_view value = text.substr(at + key.size() + 1);
			return std::string(value.substr(0, value.find_first_of("\r\n")));
		}
	return {};
}

double finiteOr(const std::string& text, double otherwise)
{
	const double value = parseReal(text).value_or(otherwise);
	return std::isfinite(value) ? value : otherwise;
}

std::uint32_t imagejCount(std::string_view text, std::string_view key)
{
	const std::string word = valueOfLine(text, key);
	const double value = finiteOr(word, word.empty() ? 1.0 : 0.0);
	if (value < 1.0 || value > 1e9 || value != std::floor(value))
		throw damaged(fmt::format("its description says {}={}", key, word));
	return static_cast<std::uint32_t>(value);
}

void placeImagej(TiffLayout& layout, const TiffFacts& facts)
{
	const std::string_view text = facts.description;
	for (std::size_t axis = 0; axis < 2; ++axis)
		if (facts.resolution[axis] > 0.0)
			layout.spacing[axis] = 1.0 / facts.resolution[axis];
	// ImageJ takes the sign of no spacing.
	if (const double z = std::abs(finiteOr(valueOfLine(text, "spacing"), 1.0)); z > 0.0)
		layout.spacing[2] = z;
	std::array<std::string, 3> units = {valueOfLine(text, "unit"), valueOfLine(text, "yunit"),
	                                    valueOfLine(text, "zunit")};
	if (units[0].empty())
		units[0] = facts.resolution_unit;
	for (std::size_t axis = 1; axis < 3; ++axis)
		if (units[axis].empty())
			units[axis] = units[0];
	const text::OneLengthUnit one = text::oneLengthUnit(units);
	layout.length_units = one.sign;
	if (one.differ)
		layout.notes.push_back(text::unitsDiffer(units));
	constexpr std::array origins = {"xorigin", "yorigin", "zorigin"}; // in pixels
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		layout.spacing[axis] *= one.factors[axis];
		layout.origin[axis] = 0.0 - finiteOr(valueOfLine(text, origins[axis]), 0.0) * layout.spacing[axis];
	}
}

// "cf=0" with two coefficients is a straight line: so ImageJ writes signed values. Other functions are named.
void calibrate(TiffLayout& layout, std::string_view text)
{
	const std::string function = valueOfLine(text, "cf");
	if (function.empty())
		return;
	const auto intercept = parseReal(valueOfLine(text, "c0"));
	const auto slope = parseReal(valueOfLine(text, "c1"));
	if (function == "0" && intercept && slope && std::isfinite(*intercept) && std::isfinite(*slope) && *slope != 0.0)
	{
		layout.intercept = *intercept;
		layout.slope = *slope;
		layout.value_units = valueOfLine(text, "vunit");
		if (layout.value_units == "Gray Value")
			layout.value_units.clear();
	}
	else
		layout.notes.push_back(
		    fmt::format("its values are not calibrated: ImageJ's function {} is not applied", function));
}

void imagejTimes(TiffLayout& layout, std::string_view text)
{
	double step = finiteOr(valueOfLine(text, "finterval"), 0.0);
	if (step <= 0.0)
		if (const double rate = finiteOr(valueOfLine(text, "fps"), 0.0); rate > 0.0)
			step = 1.0 / rate;
	for (std::uint32_t t = 0; layout.times > 1 && t < layout.times; ++t)
		layout.time_values.push_back(t * (step > 0.0 ? step : 1.0));
	if (step > 0.0)
	{
		layout.time_units = valueOfLine(text, "tunit");
		if (layout.time_units.empty() || layout.time_units == "sec")
			layout.time_units = std::string(1, 's'); // gcc 12 warns wrongly of an assigned text of one character
	}
}

TiffLayout imagejLayout(const TiffFacts& facts)
{
	const std::string_view text = facts.description;
	TiffLayout layout;
	layout.channels = imagejCount(text, "channels");
	layout.times = imagejCount(text, "frames");
	const std::uint64_t images = std::max<std::uint64_t>(imagejCount(text, "images"), facts.pages);
	layout.slices = valueOfLine(text, "slices").empty()
	                    ? static_cast<std::uint32_t>(
	                          std::max<std::uint64_t>(images / (std::uint64_t(layout.channels) * layout.times), 1))
	                    : imagejCount(text, "slices");
	std::string order = valueOfLine(text, "order"); // "zct", mostly not there
	std::transform(order.begin(), order.end(), order.begin(), [](unsigned char c) { return std::toupper(c); });
	if (std::string sorted = order; (std::sort(sorted.begin(), sorted.end()), sorted == "CTZ"))
		layout.order = order;
	placeImagej(layout, facts);
	calibrate(layout, text);
	imagejTimes(layout, text);
	layout.runs = {{0, 0, 0, layout.planes()}};
	return layout;
}

// As tifffile writes it: {"shape": [2, 6, 4, 5], "axes": "TZYX"}. The last axes are those within a page.
TiffLayout shapedLayout(const TiffFacts& facts)
{
	TiffLayout layout;
	layout.slices = static_cast<std::uint32_t>(facts.pages);
	const auto about = text::parseJson(facts.description);
	const auto shape = about.is_object() ? about.find("shape") : about.end();
	if (!about.is_object() || shape == about.end() || !shape->is_array())
		return layout;
	std::vector<std::uint64_t> lengths;
	for (const auto& length : *shape)
		if (length.is_number_unsigned() && length.get<std::uint64_t>() > 0)
			lengths.push_back(length.get<std::uint64_t>());
	const std::string axes =
	    about.contains("axes") && about["axes"].is_string() ? about["axes"].get<std::string>() : "";
	// Which of them run from page to page. One page alone may stand for all (tifffile's truncate).
	const bool has_samples = facts.samples > 1;
	std::size_t leading = 0;
	std::uint64_t pages = 1;
	while (leading + (has_samples ? 3 : 2) < lengths.size() && pages < kMaxPlanes)
		pages *= lengths[leading++];
	// Several arrays of one shape, which were written one after the other, are shown as times.
	const std::uint64_t arrays = pages > 1 && facts.pages % pages == 0 ? facts.pages / pages : 1;
	if (pages * arrays != facts.pages && facts.pages != 1)
		return layout;
	layout.order.clear();
	layout.channels = layout.slices = layout.times = 1;
	bool is_clear = true;
	for (std::size_t i = leading; i-- > 0;)
	{
		const auto length = static_cast<std::uint32_t>(std::min(lengths[i], kMaxPlanes));
		const char named = axes.size() == lengths.size() ? axes[i] : 'Q';
		const bool is_last = i + 1 == leading;
		const char axis = named == 'C' || named == 'T' || named == 'Z' ? named : is_last ? 'Z' : 'T';
		is_clear = is_clear && (named == axis || is_last || length == 1);
		(axis == 'C' ? layout.channels : axis == 'T' ? layout.times : layout.slices) *= length;
		if (layout.order.find(axis) == layout.order.npos)
			layout.order += axis;
	}
	for (const char axis : {'C', 'Z', 'T'})
		if (layout.order.find(axis) == layout.order.npos)
			layout.order += axis;
	if (arrays > 1 && layout.times == 1)
	{
		layout.order.erase(layout.order.find('T'), 1) += 'T';
		layout.times = static_cast<std::uint32_t>(arrays);
		layout.notes.push_back(fmt::format("its {} arrays of one shape are shown as times", arrays));
	}
	if (!is_clear)
		layout.notes.push_back("its pages have more than one axis without a name; all but the last are shown as times");
	return layout;
}

} // namespace

std::uint64_t TiffLayout::planes() const
{
	std::uint64_t all = 0;
	if (__builtin_mul_overflow(std::uint64_t(channels) * slices, std::uint64_t(times), &all) || all > kMaxPlanes)
		throw damaged("its description asks for more pages than there can be");
	return all;
}

std::uint64_t TiffLayout::planeOf(std::uint32_t channel, std::uint32_t slice, std::uint32_t time) const
{
	std::uint64_t plane = 0;
	for (std::size_t i = order.size(); i-- > 0;)
	{
		const auto [size, index] = order[i] == 'C'   ? std::pair(channels, channel)
		                           : order[i] == 'Z' ? std::pair(slices, slice)
		                                             : std::pair(times, time);
		plane = plane * size + index;
	}
	return plane;
}

TiffLayout tiffLayout(const TiffFacts& facts)
{
	if (facts.description.starts_with("ImageJ="))
		return imagejLayout(facts);
	if (isOme(facts.description))
		return omeLayout(facts);
	TiffLayout layout = shapedLayout(facts);
	layout.runs = {{0, 0, 0, layout.planes()}};
	for (std::uint32_t t = 0; layout.times > 1 && t < layout.times; ++t)
		layout.time_values.push_back(t);
	return layout;
}

} // namespace vp::reader::volumes
