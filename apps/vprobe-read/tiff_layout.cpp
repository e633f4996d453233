#include "tiff_layout.h"

#include "refusal.h"
#include "xml_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace
{

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

double positive(const std::string& text, double otherwise)
{
	const double value = std::strtod(text.c_str(), nullptr);
	return std::isfinite(value) && value > 0.0 ? value : otherwise;
}

std::uint32_t count(const std::string& text)
{
	const double value = positive(text, 1.0);
	return value < 1e9 ? static_cast<std::uint32_t>(value) : 1;
}

std::string unitsOf(const std::string& text)
{
	if (text == "micron" || text == "\\u00B5m" || text == "um")
		return "µm";
	return text == "pixel" || text == "inch" ? "" : text;
}

TiffLayout ofImageJ(std::string_view text, std::uint64_t pages, std::array<double, 2> resolution)
{
	TiffLayout layout;
	layout.channels = count(valueOfLine(text, "channels"));
	layout.times = count(valueOfLine(text, "frames"));
	const std::string slices = valueOfLine(text, "slices");
	layout.slices = slices.empty() ? static_cast<std::uint32_t>(pages / layout.channels / layout.times) : count(slices);
	for (std::size_t axis = 0; axis < 2; ++axis)
		if (resolution[axis] > 0.0)
			layout.spacing[axis] = 1.0 / resolution[axis];
	layout.spacing[2] = positive(valueOfLine(text, "spacing"), 1.0);
	layout.length_units = unitsOf(valueOfLine(text, "unit"));
	layout.time_step = positive(valueOfLine(text, "finterval"), 1.0);
	return layout;
}

const XmlElement* descendant(const XmlElement& from, std::string_view name)
{
	for (const XmlElement& child : from.children)
	{
		if (child.name == name || child.name.ends_with(fmt::format(":{}", name)))
			return &child;
		if (const XmlElement* found = descendant(child, name))
			return found;
	}
	return nullptr;
}

TiffLayout ofOme(const XmlElement& pixels, std::uint32_t samples)
{
	TiffLayout layout;
	const auto text = [&](std::string_view key) { return std::string(pixels.attribute(key)); };
	layout.channels = std::max(count(text("SizeC")) / samples, 1u);
	layout.slices = count(text("SizeZ"));
	layout.times = count(text("SizeT"));
	const std::string order = text("DimensionOrder");
	if (order.size() == 5 && order.starts_with("XY"))
		layout.order = order.substr(2);
	layout.spacing = {positive(text("PhysicalSizeX"), 1.0), positive(text("PhysicalSizeY"), 1.0),
	                  positive(text("PhysicalSizeZ"), 1.0)};
	layout.length_units = text("PhysicalSizeXUnit");
	if (layout.length_units.empty() && !text("PhysicalSizeX").empty())
		layout.length_units = "µm"; // the schema's default
	layout.time_step = positive(text("TimeIncrement"), 1.0);
	return layout;
}

} // namespace

std::uint64_t TiffLayout::pageOf(std::uint32_t channel, std::uint32_t slice, std::uint32_t time) const
{
	std::uint64_t page = 0;
	for (std::size_t i = order.size(); i-- > 0;)
	{
		const auto [size, index] = order[i] == 'C'   ? std::pair(channels, channel)
		                           : order[i] == 'Z' ? std::pair(slices, slice)
		                                             : std::pair(times, time);
		page = page * size + index;
	}
	return page;
}

TiffLayout tiffLayout(std::string_view description, std::uint64_t pages, std::uint32_t samples,
                      std::array<double, 2> resolution)
{
	if (description.starts_with("ImageJ="))
		return ofImageJ(description, pages, resolution);
	if (description.find("<OME") != description.npos)
	{
		const std::optional<XmlFile> xml = parseXml(description);
		const XmlElement* pixels = xml ? descendant(xml->root, "Pixels") : nullptr;
		if (!pixels)
			throw damaged("its OME-XML names no Pixels");
		return ofOme(*pixels, samples);
	}
	TiffLayout layout;
	layout.slices = static_cast<std::uint32_t>(pages);
	return layout;
}
