#include "dicom_offsets.h"

#include "dicom_item.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::reader::volumes
{

namespace
{

using gdcm::Tag;

constexpr std::uint32_t kGridFrameOffsets = 0x3004000c;
constexpr std::uint32_t kSliceLocations = 0x00182005;
constexpr std::uint32_t kFrameTime = 0x00181063;
constexpr std::uint32_t kFrameTimes = 0x00181065;

std::vector<double> vectorOf(const DicomItem& root, std::uint32_t tag, std::size_t count)
{
	auto numbers = root.exactly(count, Tag(tag));
	if (numbers.empty())
		throw damaged(fmt::format("{} is missing, by which its frames are told apart", nameOf(Tag(tag))));
	return numbers;
}

// The planes of RT dose (PS3.3 C.8.8.3.2): relative to the first, which has 0 then, or places along z.
std::vector<double> doseOffsets(const DicomItem& root, const DicomFrame& first, std::size_t count)
{
	auto offsets = vectorOf(root, kGridFrameOffsets, count);
	if (offsets[0] == 0.0)
		return offsets;
	const double up = first.normal()[2];
	if (std::abs(offsets[0] - first.origin[2]) > 1e-3 || std::abs(std::abs(up) - 1.0) > 1e-3)
		throw Refusal("its GridFrameOffsetVector begins neither with 0 nor with the z of its ImagePositionPatient");
	for (double& offset : offsets)
		offset = (offset - first.origin[2]) * (up > 0.0 ? 1.0 : -1.0);
	return offsets;
}

std::vector<double> evenOffsets(const DicomItem& root, DicomFrames& all, std::size_t count)
{
	double step = root.number(Tag(0x0018, 0x0088)).value_or(0.0);
	if (step == 0.0)
	{
		step = root.number(Tag(0x0018, 0x0050)).value_or(0.0);
		all.note(step > 0.0
		             ? "it has no SpacingBetweenSlices; its frames are taken to be as far apart as they are thick"
		             : "it says nothing of the distance of its frames, which are taken to be 1 apart");
		all.has_units = all.has_units && step > 0.0;
		step = step > 0.0 ? step : 1.0;
	}
	std::vector<double> offsets(count);
	for (std::size_t f = 0; f < count; ++f)
		offsets[f] = step * static_cast<double>(f);
	return offsets;
}

struct NuclearVector
{
	std::uint32_t tag;
	const char* name;
	bool is_time;
	bool is_view; // a view of a camera that turns round the patient
};
constexpr std::array<NuclearVector, 8> kNuclearVectors = {{
    {0x00540010, "energy window", false, false},
    {0x00540020, "detector", false, false},
    {0x00540030, "phase", true, false},
    {0x00540050, "rotation", false, true},
    {0x00540060, "interval of the heart", true, false},
    {0x00540070, "time slot", true, false},
    {0x00540090, "angular view", false, true},
    {0x00540100, "time slice", true, false},
}};
constexpr std::uint32_t kSliceVector = 0x00540080;

// Nuclear medicine (PS3.3 C.8.4.8): vectors count from 1 what each frame is.
std::vector<double> nuclearOffsets(const DicomItem& root, DicomFrames& all, std::vector<DicomFrame>& frames)
{
	for (const NuclearVector& vector : kNuclearVectors)
	{
		const auto numbers = root.exactly(frames.size(), Tag(vector.tag));
		const bool varies = std::any_of(numbers.begin(), numbers.end(), [&](double n) { return n != numbers[0]; });
		if (varies && vector.is_view)
			throw Refusal(fmt::format("nothing to slice: its {} frames are projections, not slices; reconstruct them",
			                          frames.size()));
		for (std::size_t f = 0; varies && f < frames.size(); ++f)
			frames[f].keys.push_back({vector.name, numbers[f], {}, 0.0, vector.is_time});
	}
	const auto slices = root.exactly(frames.size(), Tag(kSliceVector));
	const std::string type = root.text(Tag(0x0008, 0x0008));
	if (slices.empty() && type.find("RECON") == type.npos)
		throw Refusal(fmt::format(
		    "nothing to slice: its {} frames have no SliceVector, so they are no slices of a volume", frames.size()));
	auto offsets = evenOffsets(root, all, 2);
	const double step = offsets[1];
	offsets.resize(frames.size());
	for (std::size_t f = 0; f < frames.size(); ++f)
		offsets[f] = step * (slices.empty() ? static_cast<double>(f) : slices[f] - 1.0);
	return offsets;
}

bool isNuclear(const DicomItem& root)
{
	return root.has(Tag(kSliceVector)) || root.text(Tag(0x0008, 0x0060)) == "NM" ||
	       std::any_of(kNuclearVectors.begin(), kNuclearVectors.end(),
	                   [&](const NuclearVector& vector) { return root.has(Tag(vector.tag)); });
}

// Modalities whose files of many frames are films.
bool isFilm(const DicomItem& root)
{
	constexpr const char* films[] = {"US", "XA", "RF", "ES", "GM", "XC", "IVUS", "SM", "OP"};
	const std::string modality = root.text(Tag(0x0008, 0x0060));
	return std::find(std::begin(films), std::end(films), modality) != std::end(films);
}

} // namespace

std::vector<double> frameOffsets(const DicomItem& root, DicomFrames& all, std::vector<DicomFrame>& frames)
{
	const auto pointers = root.numbers(Tag(0x0028, 0x0009));
	const auto pointsTo = [&](std::uint32_t tag)
	{ return std::find(pointers.begin(), pointers.end(), static_cast<double>(tag)) != pointers.end(); };
	const auto names = [&](std::uint32_t tag) { return pointsTo(tag) || (pointers.empty() && root.has(Tag(tag))); };

	if (names(kGridFrameOffsets))
		return doseOffsets(root, frames[0], frames.size());
	if (isNuclear(root))
		return nuclearOffsets(root, all, frames);
	if (names(kSliceLocations))
	{
		auto places = vectorOf(root, kSliceLocations, frames.size());
		for (std::size_t f = places.size(); f-- > 0;)
			places[f] -= places[0];
		return places;
	}
	if (names(kFrameTime) || names(kFrameTimes) || (isFilm(root) && !root.has(Tag(0x0018, 0x0088))))
		throw Refusal(
		    fmt::format("nothing to slice: its {} frames are times of one picture, not slices", frames.size()));
	if (!pointers.empty())
		throw Refusal(fmt::format("its frames differ in {}, which is no place; dcm2niix may know them",
		                          nameOf(Tag(static_cast<std::uint32_t>(pointers[0])))));
	return evenOffsets(root, all, frames.size());
}

} // namespace vp::reader::volumes
