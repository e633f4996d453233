// OME-TIFF, by https://ome-model.readthedocs.io/en/stable/ome-tiff/specification.html
#include "tiff_layout.h"

#include "base/real_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/length_units.h"
#include "vprobe-read/text/xml_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::volumes
{

namespace
{

bool isCalled(const text::XmlElement& element, std::string_view name)
{
	return element.name == name || element.name.ends_with(fmt::format(":{}", name));
}

const text::XmlElement* omeDescendant(const text::XmlElement& from, std::string_view name)
{
	for (const text::XmlElement& child : from.children)
	{
		if (isCalled(child, name))
			return &child;
		if (const text::XmlElement* found = omeDescendant(child, name))
			return found;
	}
	return nullptr;
}

std::optional<double> realOf(const text::XmlElement& element, std::string_view key)
{
	const std::optional<double> value = parseReal(element.attribute(key));
	return value && std::isfinite(*value) ? value : std::nullopt;
}

std::uint32_t indexOf(const text::XmlElement& element, std::string_view key, std::uint32_t otherwise)
{
	if (!element.has(key))
		return otherwise;
	const double value = realOf(element, key).value_or(-1.0);
	if (value < 0.0 || value > 1e9 || value != std::floor(value))
		throw damaged(fmt::format("its OME-XML says {}=\"{}\"", key, element.attribute(key)));
	return static_cast<std::uint32_t>(value);
}

std::uint32_t sizeOf(const text::XmlElement& pixels, std::string_view key)
{
	const std::uint32_t size = indexOf(pixels, key, 1);
	if (size == 0)
		throw damaged(fmt::format("its OME-XML says {}=\"0\"", key));
	return size;
}

void placeOme(TiffLayout& layout, const text::XmlElement& pixels)
{
	constexpr std::array keys = {"PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ"};
	std::array<std::string, 3> units;
	std::array<bool, 3> given{};
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const std::optional<double> size = realOf(pixels, keys[axis]);
		given[axis] = size && *size > 0.0;
		layout.spacing[axis] = given[axis] ? *size : 1.0;
		units[axis] = pixels.attribute(fmt::format("{}Unit", keys[axis]));
		if (units[axis].empty() && given[axis])
			units[axis] = "µm"; // the schema's default
	}
	if (!given[0] && !given[1] && !given[2])
		return;
	for (std::size_t axis = 0; axis < 3; ++axis)
		if (!given[axis])
		{
			layout.notes.push_back(fmt::format("its OME-XML gives no {}, which is taken for 1", keys[axis]));
			const auto other = static_cast<std::size_t>(std::find(given.begin(), given.end(), true) - given.begin());
			units[axis] = units[other];
		}
	const text::OneLengthUnit one = text::oneLengthUnit(units);
	layout.length_units = one.sign;
	if (one.differ)
		layout.notes.push_back(text::unitsDiffer(units));
	for (std::size_t axis = 0; axis < 3; ++axis)
		layout.spacing[axis] *= one.factors[axis];
}

// The times of the planes of the first slice and channel where all have one, or else equal steps.
void timeOme(TiffLayout& layout, const text::XmlElement& pixels)
{
	if (layout.times < 2)
		return;
	std::vector<double> of_planes(layout.times, NAN);
	std::string units = "s"; // the schema's default
	for (const text::XmlElement& plane : pixels.children)
	{
		if (!isCalled(plane, "Plane") || !realOf(plane, "DeltaT"))
			continue;
		const std::uint32_t t = indexOf(plane, "TheT", 0);
		if (t >= layout.times || indexOf(plane, "TheZ", 0) != 0 || indexOf(plane, "TheC", 0) != 0)
			continue;
		of_planes[t] = *realOf(plane, "DeltaT");
		if (plane.has("DeltaTUnit"))
			units = plane.attribute("DeltaTUnit");
	}
	layout.time_units = units;
	layout.time_values = of_planes;
	if (std::all_of(of_planes.begin(), of_planes.end(), [](double t) { return std::isfinite(t); }))
		return;
	const std::optional<double> step = realOf(pixels, "TimeIncrement");
	const bool has_step = step && *step > 0.0;
	for (std::uint32_t t = 0; t < layout.times; ++t)
		layout.time_values[t] = t * (has_step ? *step : 1.0);
	layout.time_units = !has_step                         ? ""
	                    : pixels.has("TimeIncrementUnit") ? std::string(pixels.attribute("TimeIncrementUnit"))
	                                                      : "s";
}

// Which file has the pages of a TiffData element. A file that was renamed is known by its UUID.
std::uint32_t fileOf(TiffLayout& layout, const text::XmlElement& data, std::string_view own_uuid,
                     const std::string& own_name)
{
	const auto uuid = std::find_if(data.children.begin(), data.children.end(),
	                               [](const text::XmlElement& child) { return isCalled(child, "UUID"); });
	if (uuid == data.children.end())
		return 0;
	std::string_view text = uuid->text;
	while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ')
		text.remove_suffix(1);
	while (!text.empty() && static_cast<unsigned char>(text.front()) <= ' ')
		text.remove_prefix(1);
	const std::string name(uuid->attribute("FileName"));
	if ((!own_uuid.empty() && text == own_uuid) || name == own_name)
		return 0;
	if (name.empty())
		throw Refusal("some of its planes are in another file, which it does not name; save it as one file");
	const auto known = std::find(layout.files.begin(), layout.files.end(), name);
	if (known == layout.files.end())
	{
		layout.files.push_back(name);
		return static_cast<std::uint32_t>(layout.files.size() - 1);
	}
	return static_cast<std::uint32_t>(known - layout.files.begin());
}

void mapPlanes(TiffLayout& layout, const text::XmlElement& pixels, std::string_view own_uuid, const TiffFacts& facts)
{
	for (const text::XmlElement& data : pixels.children)
	{
		if (isCalled(data, "BinData"))
			throw Refusal("its pixels are in its XML (BinData); save it as TIFF pages");
		if (!isCalled(data, "TiffData"))
			continue;
		std::uint32_t c = indexOf(data, "FirstC", 0);
		const std::uint32_t z = indexOf(data, "FirstZ", 0), t = indexOf(data, "FirstT", 0);
		if (c >= layout.channels)
			c /= facts.samples; // where each sample is counted
		if (c >= layout.channels || z >= layout.slices || t >= layout.times)
			throw damaged("a TiffData of its OME-XML names a plane that it has not");
		TiffRun run{layout.planeOf(c, z, t), fileOf(layout, data, own_uuid, facts.file), indexOf(data, "IFD", 0), {}};
		const char* const count = data.has("PlaneCount") ? "PlaneCount" : "NumPlanes"; // which is the older name
		if (data.has(count))
			run.count = indexOf(data, count, 0);
		else if (data.has("IFD"))
			run.count = 1;
		layout.runs.push_back(run);
	}
	if (layout.runs.empty())
		layout.runs.push_back({0, 0, 0, std::nullopt});
}

} // namespace

bool isOme(std::string_view description)
{
	return description.find("<OME") != description.npos || description.find(":OME") != description.npos;
}

std::string omeMetadataFile(std::string_view description)
{
	if (!isOme(description) || description.find("BinaryOnly") == description.npos)
		return {};
	const std::optional<text::XmlFile> xml = text::parseXml(description);
	const text::XmlElement* only = xml ? omeDescendant(xml->root, "BinaryOnly") : nullptr;
	return only ? std::string(only->attribute("MetadataFile")) : std::string();
}

TiffLayout omeLayout(const TiffFacts& facts)
{
	const std::optional<text::XmlFile> xml = text::parseXml(facts.description);
	if (!xml)
		throw damaged("its OME-XML is not well-formed");
	const text::XmlElement* pixels = omeDescendant(xml->root, "Pixels");
	if (!pixels)
		throw damaged("its OME-XML names no Pixels");
	TiffLayout layout;
	layout.counts_previews = true;
	layout.channels = std::max(sizeOf(*pixels, "SizeC") / facts.samples, 1u);
	layout.slices = sizeOf(*pixels, "SizeZ");
	layout.times = sizeOf(*pixels, "SizeT");
	layout.planes();
	const std::string order(pixels->attribute("DimensionOrder"));
	std::string sorted = order;
	std::sort(sorted.begin(), sorted.end());
	if (!order.starts_with("XY") || sorted != "CTXYZ")
		throw damaged(fmt::format("its OME-XML says DimensionOrder=\"{}\"", order));
	layout.order = order.substr(2);
	placeOme(layout, *pixels);
	timeOme(layout, *pixels);
	mapPlanes(layout, *pixels, xml->root.attribute("UUID"), facts);
	const auto images = std::count_if(xml->root.children.begin(), xml->root.children.end(),
	                                  [](const text::XmlElement& child) { return isCalled(child, "Image"); });
	if (images > 1)
		layout.notes.push_back(fmt::format("it has {} images; the first is shown", images));
	return layout;
}

} // namespace vp::reader::volumes
