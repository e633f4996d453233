// Reads the facts about DICOM frames: of single pictures at the top of their files, of enhanced ones in functional
// groups
// (PS3.3 C.7.6.16), which are the frame's own or shared by all, and others by offsets.
#include "dicom_frames.h"

#include "dicom_item.h"
#include "dicom_keys.h"
#include "dicom_offsets.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::volumes
{

namespace
{

using gdcm::Tag;

constexpr const char* kSegmentationStorage = "1.2.840.10008.5.1.4.1.1.66.4"; // PS3.4 B.5
constexpr double kMaxFrames = 1e6; // a study of the largest scanners has some ten thousand

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

// Its first window of values. A window in a frame's own group is that of the file too.
std::optional<std::pair<double, double>> windowOf(const DicomItem& root)
{
	std::vector<DicomItem> places{root};
	for (const Tag& groups : {Tag(0x5200, 0x9229), Tag(0x5200, 0x9230)})
		if (const auto group = root.item(groups))
			if (const auto lut = group->item(Tag(0x0028, 0x9132)))
				places.push_back(*lut);
	for (const DicomItem& item : places)
	{
		const auto center = item.hint(Tag(0x0028, 0x1050)), width = item.hint(Tag(0x0028, 0x1051));
		if (center && width && *width > 0.0)
			return std::pair{*center - 0.5 * *width, *center + 0.5 * *width};
	}
	return std::nullopt;
}

// Returns the facts at the top of a file, which hold for all of its frames.
DicomFrame frameOf(const std::string& file, const DicomItem& root)
{
	DicomFrame frame;
	frame.file = file;
	frame.form = pixelFormOf(root);
	frame.number = root.hint(Tag(0x0020, 0x0013)).value_or(0.0);
	setRescale(root, frame);
	if (const auto scaling = root.number(Tag(0x3004, 0x000e))) // files of RT dose have it
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
		const FrameGroups groups(&own[f], shared ? &*shared : nullptr);
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
		addKeys(dimensions, groups, frame);
		if (count == 1)
			addKeys(root, frame);
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
	addKeys(root, frame);
	all.frames.push_back(std::move(frame));
}

void addByOffsets(DicomFrame top, const DicomItem& root, std::size_t count, DicomFrames& all)
{
	setSpacingOf(root, top, all);
	const auto detector = root.item(Tag(0x0054, 0x0022)); // files of nuclear medicine have it
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
	if (all.frames.empty())
	{
		all.window = windowOf(root);
		all.is_segmentation = root.text(Tag(0x0008, 0x0016)) == kSegmentationStorage;
	}
	if (!root.items(Tag(0x5200, 0x9230)).empty())
		addEnhanced(top, root, frames, all);
	else if (frames == 1)
		addSingle(top, root, all);
	else
		addByOffsets(top, root, frames, all);
}

} // namespace vp::reader::volumes
