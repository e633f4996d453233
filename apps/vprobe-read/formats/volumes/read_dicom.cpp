// DICOM through GDCM: one file of many frames, or the files of a series, named by one of them or by their folder. What
// the frames say of themselves decides where they lie, never the order in which they come.
#include "dicom_frames.h"
#include "dicom_item.h"
#include "dicom_pixels.h"
#include "dicom_places.h"
#include "dicom_slice.h"
#include "dicom_steps.h"
#include "dicom_values.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>

namespace vp::reader::volumes
{

namespace
{

namespace fs = std::filesystem;

constexpr int kMaxFiles = 100000;

// The files that are given as the slices of one volume.
std::vector<DicomSlice> givenSlices(const std::vector<std::string>& files)
{
	std::vector<DicomSlice> slices;
	for (const std::string& file : files)
	{
		const auto slice = dicomSlice(file);
		const std::string name = fs::path(file).filename().string();
		if (!slice)
			throw damaged(fmt::format("{} is no DICOM image that can be opened", name));
		if (slice->frames > 1 && !slice->is_part)
			throw Refusal(fmt::format("{} has {} frames, and a slice has one; name it alone", name, slice->frames));
		if (!slices.empty() && slice->series != slices.front().series)
			throw Refusal(fmt::format("{} is of another series than {}; give the slices of one series", name,
			                          fs::path(files.front()).filename().string()));
		slices.push_back(*slice);
	}
	return slices;
}

// The files of one series: that of `request.file`, or, where it is a folder, the largest in it.
std::vector<DicomSlice> sliceFiles(const Request& request, manifest::Writer& manifest)
{
	if (!request.slices.empty())
		return givenSlices(request.slices);
	const bool is_folder = fs::is_directory(request.file);
	const fs::path folder = is_folder ? fs::path(request.file) : fs::absolute(request.file).parent_path();
	std::string wanted;
	if (!is_folder)
	{
		const auto given = dicomSlice(request.file);
		if (!given)
			throw damaged("not a DICOM image that can be opened");
		if (given->frames > 1 && !given->is_part)
			return {*given};
		wanted = given->series;
	}
	std::map<std::string, std::vector<DicomSlice>> series;
	int files = 0;
	const OnlyLooking looking; // into files of other series, and into any other file
	for (const auto& entry : fs::directory_iterator(folder))
		if (entry.is_regular_file() && ++files <= kMaxFiles)
			if (auto slice = dicomSlice(entry.path().string()))
				series[slice->series].push_back(std::move(*slice));
	if (series.empty())
		throw Refusal("a folder; name a file in it");
	const auto framesIn = [](const std::vector<DicomSlice>& slices)
	{
		return std::accumulate(slices.begin(), slices.end(), 0.0,
		                       [](double sum, const DicomSlice& slice) { return sum + slice.frames; });
	};
	const auto smaller = [&](const auto& a, const auto& b) { return framesIn(a.second) < framesIn(b.second); };
	const auto chosen = is_folder ? std::max_element(series.begin(), series.end(), smaller) : series.find(wanted);
	if (chosen == series.end())
		throw damaged("it is gone");
	const auto& first = chosen->second.front();
	if (first.is_part && first.parts > 0 && static_cast<std::size_t>(first.parts) != chosen->second.size())
		throw Refusal(
		    fmt::format("it is one of {} files of one image, of which {} are in its folder; keep them together",
		                first.parts, chosen->second.size()));
	if (is_folder && series.size() > 1)
		manifest.warn(
		    fmt::format("the largest of {} series is shown; name a file to see that of another", series.size()));
	return std::move(chosen->second);
}

DicomFrames framesOf(const std::vector<DicomSlice>& files)
{
	DicomFrames all;
	for (const DicomSlice& slice : files)
	{
		gdcm::Reader head;
		gdcm::Reader whole; // where GDCM cannot stop, as within deflated data
		head.SetFileName(slice.file.c_str());
		whole.SetFileName(slice.file.c_str());
		const bool is_enough = head.ReadUpToTag(gdcm::Tag(0x7fe0, 0x0008));
		if (!is_enough && !whole.Read())
			throw damaged(fmt::format("GDCM cannot read {}", fs::path(slice.file).filename().string()));
		addFramesOf(slice.file, DicomItem((is_enough ? head : whole).GetFile().GetDataSet()), all);
	}
	return all;
}

// Pixels of frames, in their order, as one array in a type that holds all of them.
vtkSmartPointer<vtkDataArray> valuesOf(const std::vector<DicomFrame>& frames, manifest::Writer& manifest)
{
	DicomValueType type;
	std::map<std::string, std::vector<std::size_t>> files; // the numbers of the frames in each
	for (std::size_t f = 0; f < frames.size(); ++f)
	{
		type.add(frames[f].form, frames[f].slope, frames[f].intercept);
		files[frames[f].file].push_back(f);
	}
	const DicomPixelForm& form = frames[0].form;
	const arrays::ValueLayout layout{
	    {form.columns, form.rows, static_cast<std::uint32_t>(frames.size())}, form.samples, type.type(), false};
	std::string bytes;
	std::size_t padded = 0;
	for (const auto& [file, numbers] : files)
	{
		DicomPixels pixels(file);
		if (bytes.empty()) // a file that is too short for what it says was refused
			bytes.resize(layout.byteCount());
		for (const std::size_t f : numbers)
			rescale(pixels.frame(frames[f].index), frames[f].slope, frames[f].intercept, layout.type,
			        bytes.data() + f * (bytes.size() / frames.size()));
		padded += pixels.padded();
	}
	if (padded > 0)
		manifest.warn(fmt::format("{} of its {} values stand for no part of a picture (PixelPaddingValue); they are "
		                          "kept as values",
		                          padded, layout.valueCount()));
	return arrays::arrayOf(bytes, layout, "DICOM");
}

} // namespace

void readDicom(const Request& request, manifest::Writer& manifest)
{
	gdcm::Trace::WarningOff();
	gdcm::Trace::ErrorOff();
	DicomFrames all = framesOf(sliceFiles(request, manifest));
	DicomSteps steps = stepsOf(all);
	manifest::chooseIfAny(steps.times, request); // refuses an index where there are no times
	const auto& frames = steps.steps[steps.times.empty() ? 0 : manifest::chooseStep(steps.times, request)];
	const auto grid = gridOfFrames(frames);
	if (!vtkImageData::SafeDownCast(grid))
		all.note("its frames are not evenly far apart; the grid follows them, and none may be missing");
	grid->GetPointData()->SetScalars(valuesOf(frames, manifest));
	for (const std::string& note : all.notes)
		manifest.warn(note);
	if (all.has_units)
		manifest.setLengthUnits("mm");
	// Without a place of their own, frames are pictures one over the other.
	manifest.setImaging({frames.front().has_place ? "LPS" : "rows-down", true, all.is_segmentation, all.window});
	if (steps.are_seconds)
		manifest.setTimeUnits("s");
	manifest.addLone(grid);
	manifest.offerTimes(std::move(steps.times));
}

} // namespace vp::reader::volumes
