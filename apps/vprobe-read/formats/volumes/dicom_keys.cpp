// Finds the keys that tell frames of DICOM in one place apart.
#include "dicom_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace vp::reader::volumes
{

namespace
{

using gdcm::Tag;

// A key: the sequences that hold its element, inside each other, none at the top of a file; and the element.
struct KeySource
{
	const char* name;
	std::vector<Tag> sequences;
	Tag element;
	bool is_text;
	bool is_time;
	double seconds;
};

const std::vector<KeySource>& frameKeys()
{
	static const std::vector<KeySource> keys = {
	    {"time offset", {{0x0020, 0x9310}}, {0x0020, 0x930d}, false, true, 1.0},
	    {"trigger time", {{0x0018, 0x9118}}, {0x0020, 0x9153}, false, true, 1e-3},
	    {"temporal position", {{0x0020, 0x9111}}, {0x0020, 0x9128}, false, true, 0.0},
	    {"echo time", {{0x0018, 0x9114}}, {0x0018, 0x9082}, false, false, 0.0},
	    {"b-value", {{0x0018, 0x9117}}, {0x0018, 0x9087}, false, false, 0.0},
	    {"direction of diffusion", {{0x0018, 0x9117}, {0x0018, 0x9076}}, {0x0018, 0x9089}, true, false, 0.0},
	    {"segment", {{0x0062, 0x000a}}, {0x0062, 0x000b}, false, false, 0.0},
	    {"image type", {{0x0018, 0x9226}}, {0x0008, 0x9007}, true, false, 0.0},
	    {"image type", {{0x0018, 0x9329}}, {0x0008, 0x9007}, true, false, 0.0},
	    {"image type", {{0x0018, 0x9751}}, {0x0008, 0x9007}, true, false, 0.0},
	};
	return keys;
}

const std::vector<KeySource>& fileKeys()
{
	static const std::vector<KeySource> keys = {
	    {"frame reference time", {}, {0x0054, 0x1300}, false, true, 1e-3},
	    {"trigger time", {}, {0x0018, 0x1060}, false, true, 1e-3},
	    {"temporal position", {}, {0x0020, 0x0100}, false, true, 0.0},
	    {"echo time", {}, {0x0018, 0x0081}, false, false, 0.0},
	    {"echo number", {}, {0x0018, 0x0086}, true, false, 0.0},
	    {"b-value", {}, {0x0018, 0x9087}, false, false, 0.0},
	    {"direction of diffusion", {}, {0x0018, 0x9089}, true, false, 0.0},
	    {"image type", {}, {0x0008, 0x0008}, true, false, 0.0},
	    {"acquisition number", {}, {0x0020, 0x0012}, false, true, 0.0},
	    {"acquisition time", {}, {0x0008, 0x002a}, true, true, 0.0},
	    {"acquisition time", {}, {0x0008, 0x0032}, true, true, 0.0},
	    {"content time", {}, {0x0008, 0x0033}, true, true, 0.0},
	};
	return keys;
}

// Numbers of binary elements as text, in full.
std::string keyText(const DicomItem& item, const Tag& tag)
{
	if (tag != Tag(0x0018, 0x9089))
		return item.text(tag);
	std::string text;
	for (const double number : item.numbers(tag))
		text += fmt::format("{} ", number);
	return text;
}

void addKey(const KeySource& source, const DicomItem* holder, DicomFrame& frame)
{
	DicomKey key{source.name, 0.0, {}, source.seconds, source.is_time};
	if (holder && source.is_text)
		key.text = keyText(*holder, source.element);
	else if (holder)
		key.number = holder->hint(source.element).value_or(0.0);
	frame.keys.push_back(std::move(key));
}

// From sequences inside each other.
std::optional<DicomItem> holderOf(const KeySource& source, const FrameGroups& groups)
{
	auto found = groups.group(source.sequences[0]);
	for (std::size_t i = 1; found && i < source.sequences.size(); ++i)
		found = found->item(source.sequences[i]);
	return found;
}

} // namespace

std::optional<DicomItem> FrameGroups::group(const Tag& sequence) const
{
	for (const DicomItem* item : {own_, shared_})
		if (item)
			if (auto found = item->item(sequence))
				return found;
	return std::nullopt;
}

std::vector<DicomDimension> dimensionsOf(const DicomItem& root)
{
	constexpr std::uint32_t places[] = {0x00200032, 0x00209301, 0x00209056, 0x00209057,
	                                    0x00201041, 0x00209113, 0x0020930e, 0x00400008};
	constexpr std::uint32_t times[] = {0x00209128, 0x0020930d, 0x00209153, 0x00189074, 0x00189151, 0x00209156};
	std::vector<DicomDimension> dimensions;
	std::size_t position = 0;
	for (const DicomItem& item : root.items(Tag(0x0020, 0x9222)))
	{
		const auto pointer = static_cast<std::uint32_t>(item.number(Tag(0x0020, 0x9165)).value_or(0.0));
		const bool is_place = std::find(std::begin(places), std::end(places), pointer) != std::end(places);
		const bool is_time = std::find(std::begin(times), std::end(times), pointer) != std::end(times);
		if (!is_place)
			dimensions.push_back({position, nameOf(Tag(pointer)), is_time});
		++position;
	}
	return dimensions;
}

void addKeys(const std::vector<DicomDimension>& dimensions, const FrameGroups& groups, DicomFrame& frame)
{
	const auto content = groups.group(Tag(0x0020, 0x9111));
	const auto values = content ? content->numbers(Tag(0x0020, 0x9157)) : std::vector<double>();
	if (content)
		frame.stack = content->text(Tag(0x0020, 0x9056));
	// These come first: they have names and units.
	for (const KeySource& source : frameKeys())
	{
		const auto holder = holderOf(source, groups);
		addKey(source, holder ? &*holder : nullptr, frame);
	}
	for (const DicomDimension& dimension : dimensions)
		frame.keys.push_back({dimension.name,
		                      dimension.position < values.size() ? values[dimension.position] : 0.0,
		                      {},
		                      0.0,
		                      dimension.is_time});
}

void addKeys(const DicomItem& root, DicomFrame& frame)
{
	for (const KeySource& source : fileKeys())
		addKey(source, &root, frame);
}

} // namespace vp::reader::volumes
