// What frames of DICOM say of themselves: single pictures at the top of their files, enhanced ones in functional groups
// (PS3.3 C.7.6.16), which are the frame's own or shared by all, and others by offsets.
#include "dicom_frames.h"

#include "dicom_item.h"
#include "dicom_offsets.h"
#include "refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace
{

using gdcm::Tag;

constexpr double kMaxFrames = 1e6; // a study of the largest scanners has some ten thousand

// A key: the sequence that holds its element, which may be missing at the top of a file, and the element.
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

// A frame's functional groups: its own come before those that it shares.
class FrameGroups
{
public:
	FrameGroups(const DicomItem* own, const DicomItem* shared, const DicomItem& root) : root_(&root)
	{
		for (const DicomItem* item : {own, shared})
			if (item)
				items_.push_back(item);
	}
	std::optional<DicomItem> group(const Tag& sequence) const
	{
		for (const DicomItem* item : items_)
			if (auto found = item->item(sequence))
				return found;
		return std::nullopt;
	}
	// From the sequences inside each other; from the top of the file where none is named.
	std::optional<DicomItem> inside(const std::vector<Tag>& sequences) const
	{
		if (sequences.empty())
			return *root_;
		auto found = group(sequences[0]);
		for (std::size_t i = 1; found && i < sequences.size(); ++i)
			found = found->item(sequences[i]);
		return found;
	}

private:
	std::vector<const DicomItem*> items_;
	const DicomItem* root_;
};

void addKeys(const std::vector<KeySource>& sources, const FrameGroups& groups, DicomFrame& frame)
{
	for (const KeySource& source : sources)
	{
		const auto holder = groups.inside(source.sequences);
		DicomKey key{source.name, 0.0, {}, source.seconds, source.is_time};
		if (holder && source.is_text)
			key.text = keyText(*holder, source.element);
		else if (holder)
			key.number = holder->hint(source.element).value_or(0.0);
		frame.keys.push_back(std::move(key));
	}
}

// What the file calls its dimensions. Those of places and stacks are looked at by themselves.
struct Dimension
{
	std::size_t position; // in the values of each frame
	std::string name;
	bool is_time;
};

std::vector<Dimension> dimensionsOf(const DicomItem& root)
{
	constexpr std::uint32_t places[] = {0x00200032, 0x00209301, 0x00209056, 0x00209057,
	                                    0x00201041, 0x00209113, 0x0020930e, 0x00400008};
	constexpr std::uint32_t times[] = {0x00209128, 0x0020930d, 0x00209153, 0x00189074, 0x00189151, 0x00209156};
	std::vector<Dimension> dimensions;
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

void addDimensions(const std::vector<Dimension>& dimensions, const FrameGroups& groups, DicomFrame& frame)
{
	const auto content = groups.group(Tag(0x0020, 0x9111));
	const auto values = content ? content->numbers(Tag(0x0020, 0x9157)) : std::vector<double>();
	for (const Dimension& dimension : dimensions)
		frame.keys.push_back({dimension.name,
		                      dimension.position < values.size() ? values[dimension.position] : 0.0,
		                      {},
		                      0.0,
		                      dimension.is_time});
	if (content)
		frame.stack = content->text(Tag(0x0020, 0x9056));
}

void setPlace(const DicomItem& item, const Tag& tag, DicomFrame& frame)
{
	const auto place = item.exactly(3, tag);
	if (place.empty())
		return;
	std::copy_n(place.begin(), 3, frame.origin.begin());
	frame.has_place = true;
}

void setAxes(const DicomItem& item, const Tag& tag, DicomFrame& frame)
{
	const auto axes = item.exactly(6, tag);
	if (!axes.empty())
		std::copy_n(axes.begin(), 6, frame.axes.begin());
}

// From row to row comes first in the file.
bool setSpacing(const DicomItem& item, const Tag& tag, DicomFrame& frame)
{
	const auto spacing = item.exactly(2, tag);
	if (!spacing.empty())
		frame.spacing = {spacing[1], spacing[0]};
	return !spacing.empty();
}

void setRescale(const DicomItem& item, DicomFrame& frame)
{
	frame.slope = item.number(Tag(0x0028, 0x1053)).value_or(frame.slope);
	frame.intercept = item.number(Tag(0x0028, 0x1052)).value_or(frame.intercept);
	if (!std::isfinite(frame.slope) || !std::isfinite(frame.intercept))
		throw damaged("its rescale slope or intercept is not finite");
}

void setSpacingOf(const DicomItem& root, DicomFrame& frame, DicomFrames& all)
{
	if (setSpacing(root, Tag(0x0028, 0x0030), frame))
		return;
	if (setSpacing(root, Tag(0x0018, 0x1164), frame))
		all.note(
		    "it has no PixelSpacing; its pixels are as far apart as they are at the detector (ImagerPixelSpacing)");
	else if (setSpacing(root, Tag(0x0018, 0x2010), frame))
		all.note(
		    "it has no PixelSpacing; its pixels are as far apart as they were scanned (NominalScannedPixelSpacing)");
	else
	{
		all.note("it has no PixelSpacing; its pixels are taken to be 1 apart");
		all.has_units = false;
	}
}

// What stands at the top of a file, for all of its frames.
DicomFrame frameOf(const std::string& file, const DicomItem& root)
{
	DicomFrame frame;
	frame.file = file;
	frame.form = pixelFormOf(root);
	frame.number = root.hint(Tag(0x0020, 0x0013)).value_or(0.0);
	setRescale(root, frame);
	if (const auto scaling = root.number(Tag(0x3004, 0x000e))) // of RT dose
		frame.slope = *scaling;
	return frame;
}

void addEnhanced(const DicomFrame& top, const DicomItem& root, std::size_t count, DicomFrames& all)
{
	const auto own = root.items(Tag(0x5200, 0x9230));
	const auto shared = root.item(Tag(0x5200, 0x9229));
	const auto dimensions = dimensionsOf(root);
	if (own.size() != count)
		throw damaged(fmt::format("it describes {} frames, and has {}", own.size(), count));
	for (std::size_t f = 0; f < count; ++f)
	{
		const FrameGroups groups(&own[f], shared ? &*shared : nullptr, root);
		DicomFrame frame = top;
		frame.index = f;
		frame.number += static_cast<double>(f) / kMaxFrames; // behind the frames of the file before it
		if (const auto group = groups.group(Tag(0x0020, 0x9113)))
			setPlace(*group, Tag(0x0020, 0x0032), frame);
		else if (const auto in_volume = groups.group(Tag(0x0020, 0x930e)))
			setPlace(*in_volume, Tag(0x0020, 0x9301), frame);
		if (const auto group = groups.group(Tag(0x0020, 0x9116)))
			setAxes(*group, Tag(0x0020, 0x0037), frame);
		else if (const auto in_volume = groups.group(Tag(0x0020, 0x930f)))
			setAxes(*in_volume, Tag(0x0020, 0x9302), frame);
		const auto measures = groups.group(Tag(0x0028, 0x9110));
		if (!measures || !setSpacing(*measures, Tag(0x0028, 0x0030), frame))
			setSpacingOf(root, frame, all);
		if (const auto group = groups.group(Tag(0x0028, 0x9145)))
			setRescale(*group, frame);
		addDimensions(dimensions, groups, frame);
		addKeys(frameKeys(), groups, frame);
		if (count == 1)
			addKeys(fileKeys(), groups, frame);
		if (!frame.has_place)
			throw Refusal(count == 1
			                  ? "nothing to slice: a picture that does not say where it lies"
			                  : fmt::format("nothing to slice: its {} frames do not say where they lie, as those "
			                                "of a film",
			                                count));
		all.frames.push_back(std::move(frame));
	}
}

void addSingle(DicomFrame frame, const DicomItem& root, DicomFrames& all)
{
	if (root.text(Tag(0x0008, 0x0008)).find("MOSAIC") != std::string::npos)
		throw Refusal("a mosaic: one picture of many slices side by side; dcm2niix makes a volume of it");
	setPlace(root, Tag(0x0020, 0x0032), frame);
	setAxes(root, Tag(0x0020, 0x0037), frame);
	if (const auto location = root.hint(Tag(0x0020, 0x1041)); !frame.has_place && location)
	{
		all.note("it has no ImagePositionPatient; its slices are placed by SliceLocation");
		const auto normal = frame.normal();
		for (std::size_t a = 0; a < 3; ++a)
			frame.origin[a] = normal[a] * *location;
		frame.has_place = true;
	}
	setSpacingOf(root, frame, all);
	addKeys(fileKeys(), FrameGroups(nullptr, nullptr, root), frame);
	all.frames.push_back(std::move(frame));
}

void addByOffsets(DicomFrame top, const DicomItem& root, std::size_t count, DicomFrames& all)
{
	setSpacingOf(root, top, all);
	const auto detector = root.item(Tag(0x0054, 0x0022)); // of nuclear medicine
	for (const DicomItem* item : {detector ? &*detector : nullptr, &root})
	{
		if (!item)
			continue;
		setPlace(*item, Tag(0x0020, 0x0032), top);
		setAxes(*item, Tag(0x0020, 0x0037), top);
	}
	if (!top.has_place)
		all.note("it has no ImagePositionPatient; its first pixel is taken to lie at 0");
	top.has_place = true;
	std::vector<DicomFrame> frames(count, top);
	for (std::size_t f = 0; f < count; ++f)
		frames[f].index = f, frames[f].number += static_cast<double>(f) / kMaxFrames;
	const auto offsets = frameOffsets(root, all, frames);
	const auto normal = top.normal();
	for (std::size_t f = 0; f < count; ++f)
	{
		for (std::size_t a = 0; a < 3; ++a)
			frames[f].origin[a] += offsets[f] * normal[a];
		all.frames.push_back(std::move(frames[f]));
	}
}

} // namespace

std::array<double, 3> DicomFrame::normal() const
{
	const auto& a = axes;
	return {a[1] * a[5] - a[2] * a[4], a[2] * a[3] - a[0] * a[5], a[0] * a[4] - a[1] * a[3]};
}

double DicomFrame::depth() const
{
	const auto n = normal();
	return origin[0] * n[0] + origin[1] * n[1] + origin[2] * n[2];
}

void DicomFrames::note(const std::string& line)
{
	if (std::find(notes.begin(), notes.end(), line) == notes.end())
		notes.push_back(line);
}

void addFramesOf(const std::string& file, const DicomItem& root, DicomFrames& all)
{
	const double count = root.number(Tag(0x0028, 0x0008)).value_or(1.0);
	if (!(count >= 0.0 && count <= kMaxFrames))
		throw damaged(fmt::format("it says that it has {} frames", count));
	const auto frames = std::max<std::size_t>(1, static_cast<std::size_t>(count));
	const DicomFrame top = frameOf(file, root);
	if (!root.items(Tag(0x5200, 0x9230)).empty())
		addEnhanced(top, root, frames, all);
	else if (frames == 1)
		addSingle(top, root, all);
	else
		addByOffsets(top, root, frames, all);
}
