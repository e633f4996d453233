// Stacks of TIFF pages through libtiff: VTK's readers know neither ImageJ's nor OME's times, and turn pages over.
#include "tiff_layout.h"
#include "tiff_pages.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>
#include <optional>

namespace vp::reader::volumes
{

namespace fs = std::filesystem;

namespace
{

// The files of a data set, one of them open at a time.
class TiffFiles
{
public:
	TiffFiles(std::string first, const std::vector<std::string>& names) : first_(std::move(first)), names_(names) {}
	TiffPages& open(std::uint32_t file)
	{
		if (file == current_)
			return *pages_;
		const std::string path = file == 0 ? first_ : (fs::path(first_).parent_path() / names_[file]).string();
		std::error_code error;
		if (!fs::is_regular_file(path, error))
			throw Refusal(
			    fmt::format("some of its planes are in {}, which cannot be opened; keep the files together", path));
		pages_.reset();
		current_ = std::numeric_limits<std::uint32_t>::max();
		pages_.emplace(path);
		current_ = file;
		return *pages_;
	}

private:
	std::string first_;
	const std::vector<std::string>& names_;
	std::optional<TiffPages> pages_;
	std::uint32_t current_ = std::numeric_limits<std::uint32_t>::max();
};

struct TiffPlane
{
	std::uint32_t file = 0;
	std::uint64_t page = std::numeric_limits<std::uint64_t>::max(); // none
};

// A file that was renamed, and whose XML has no UUID, names only itself by its old name.
void findRenamed(TiffLayout& layout, const std::string& file)
{
	const auto names_itself = [](const TiffRun& run) { return run.file == 0; };
	std::error_code error;
	if (layout.files.size() != 2 || std::any_of(layout.runs.begin(), layout.runs.end(), names_itself) ||
	    fs::exists(fs::path(file).parent_path() / layout.files[1], error))
		return;
	for (TiffRun& run : layout.runs)
		run.file = 0;
}

// The page of every plane.
std::vector<TiffPlane> pagesOfPlanes(const TiffLayout& layout, TiffFiles& files)
{
	std::vector<TiffPlane> planes(layout.planes());
	for (const TiffRun& run : layout.runs)
	{
		const std::uint64_t there = planes.size() - run.plane;
		std::uint64_t count = run.count.value_or(there);
		if (!run.count)
		{
			const std::uint64_t pages = files.open(run.file).count();
			count = std::min(there, pages - std::min(pages, run.page));
		}
		if (count > there)
			throw damaged("its description maps more pages than it has planes");
		for (std::uint64_t i = 0; i < count; ++i)
			planes[run.plane + i] = {run.file, run.page + i};
	}
	return planes;
}

// The pages like the first one that is no preview, by their numbers.
std::vector<std::uint64_t> alikePages(const TiffPages& pages)
{
	std::uint64_t first = 0;
	while (first + 1 < pages.count() && pages.isPreview(first))
		++first;
	std::vector<std::uint64_t> alike;
	for (std::uint64_t page = first; page < pages.count(); ++page)
		if (pages.kind(page) == pages.kind(first) && (!pages.isPreview(page) || page == first))
			alike.push_back(page);
	return alike;
}

// OME's description may lie in another file.
std::string descriptionOf(const std::string& file, TiffPages& pages)
{
	std::string description = pages.description();
	const std::string name = omeMetadataFile(description);
	if (name.empty())
		return description;
	const std::string path = (fs::path(file).parent_path() / name).string();
	std::error_code error;
	if (!fs::is_regular_file(path, error))
		throw Refusal(fmt::format("its description is in {}, which cannot be opened; keep the files together", path));
	const MappedText mapped(path);
	const std::string_view text = mapped.text();
	return text.starts_with("II") || text.starts_with("MM") ? TiffPages(path).description() : std::string(text);
}

// Reads the planes of one time, and puts each where it belongs.
class TiffVolume
{
public:
	TiffVolume(const TiffLayout& layout, TiffFiles& files, std::vector<std::uint64_t> alike, std::uint32_t time)
	    : layout_(layout), files_(files), alike_(std::move(alike)), planes_(pagesOfPlanes(layout, files))
	{
		if (layout.counts_previews)
		{
			const TiffPlane first = planes_[layout.planeOf(0, 0, time)];
			TiffPages& pages = files_.open(first.file);
			const std::uint64_t page = first.page < pages.count() ? first.page : 0;
			kind_ = pages.kind(page);
			pages.refuseImpossible(page);
			return;
		}
		TiffPages& pages = files_.open(0);
		kind_ = pages.kind(alike_.front());
		pages.refuseImpossible(alike_.front());
		reads_behind_ = alike_.size() == 1 && layout.planes() > 1 && alike_.front() == 0 && pages.isPlain(0);
		if (!reads_behind_ && layout.planes() > alike_.size())
			throw damaged(
			    fmt::format("it has {} pages where its description asks for {}", alike_.size(), layout.planes()));
	}

	arrays::ValueLayout values() const
	{
		return {{kind_.width, kind_.height, layout_.slices}, kind_.samples, kind_.type()};
	}
	void readPlane(std::uint32_t channel, std::uint32_t slice, std::uint32_t time, char* to)
	{
		const std::uint64_t plane = layout_.planeOf(channel, slice, time);
		if (reads_behind_)
			return files_.open(0).readBehindFirst(plane, to);
		const TiffPlane at = planes_[plane];
		if (at.page == TiffPlane().page)
			throw damaged(
			    fmt::format("its description gives no page of slice {}, channel {}, time {}", slice, channel, time));
		TiffPages& pages = files_.open(at.file);
		if (at.page >= (layout_.counts_previews ? pages.count() : alike_.size()))
			throw damaged(
			    fmt::format("it has {} pages where its description asks for page {}", pages.count(), at.page));
		const std::uint64_t page = layout_.counts_previews ? at.page : alike_[at.page];
		if (pages.kind(page) != kind_)
			throw damaged(fmt::format("page {} has another size or type than the first one", page));
		pages.read(page, to);
	}

private:
	const TiffLayout& layout_;
	TiffFiles& files_;
	std::vector<std::uint64_t> alike_;
	std::vector<TiffPlane> planes_;
	TiffPageKind kind_;
	bool reads_behind_ = false;
};

vtkSmartPointer<vtkDataArray> calibrated(vtkSmartPointer<vtkDataArray> values, const TiffLayout& layout)
{
	if (!layout.value_units.empty())
		values->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), layout.value_units.c_str());
	if (layout.slope == 1.0 && layout.intercept == 0.0)
		return values;
	const auto scaled = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_DOUBLE));
	scaled->SetName(values->GetName());
	scaled->SetNumberOfComponents(values->GetNumberOfComponents());
	scaled->SetNumberOfTuples(values->GetNumberOfTuples());
	scaled->CopyInformation(values->GetInformation());
	for (vtkIdType tuple = 0; tuple < values->GetNumberOfTuples(); ++tuple)
		for (int component = 0; component < values->GetNumberOfComponents(); ++component)
			scaled->SetComponent(tuple, component,
			                     layout.intercept + layout.slope * values->GetComponent(tuple, component));
	return scaled;
}

void tellOfOthers(const TiffLayout& layout, const TiffPages& pages, std::size_t alike, manifest::Writer& manifest)
{
	if (layout.counts_previews)
		return;
	if (const std::uint64_t others = pages.count() - alike; others > 0)
		manifest.warn(fmt::format("{} pages unlike the first one, or previews, are left out", others));
	if (alike > layout.planes())
		manifest.warn(fmt::format("{} pages more than its description asks for are left out", alike - layout.planes()));
}

} // namespace

void readTiff(const Request& request, manifest::Writer& manifest)
{
	TiffLayout layout;
	TiffFiles files(request.file, layout.files);
	std::vector<std::uint64_t> alike;
	{
		TiffPages& pages = files.open(0);
		alike = alikePages(pages);
		const TiffPageKind kind = pages.kind(alike.front());
		kind.type();
		layout = tiffLayout({fs::path(request.file).filename().string(), descriptionOf(request.file, pages),
		                     alike.size(), kind.samples, pages.resolution(), pages.resolutionUnit()});
		findRenamed(layout, request.file);
		tellOfOthers(layout, pages, alike.size(), manifest);
	}
	for (const std::string& note : layout.notes)
		manifest.warn(note);
	manifest::StepsInTime times = manifest::stepsInTime(layout.time_values, manifest);
	manifest::chooseIfAny(times.times, request);
	const auto step =
	    static_cast<std::uint32_t>(times.times.empty() ? 0 : times.steps[manifest::chooseStep(times.times, request)]);

	TiffVolume volume(layout, files, std::move(alike), step);
	const arrays::ValueLayout values = volume.values();
	const std::uint64_t page_bytes = values.byteCount() / layout.slices;
	vtkSmartPointer<vtkImageData> image;
	for (std::uint32_t channel = 0; channel < layout.channels; ++channel)
	{
		auto array = arrays::emptyArray(values, layout.channels > 1 ? fmt::format("channel {}", channel) : "values");
		char* to = static_cast<char*>(array->GetVoidPointer(0));
		for (std::uint32_t slice = 0; slice < layout.slices; ++slice)
			volume.readPlane(channel, slice, step, to + slice * page_bytes);
		array = calibrated(array, layout);
		if (image)
			image->GetPointData()->AddArray(array);
		else
			image = arrays::imageOf(array, values.points);
	}
	image->SetSpacing(layout.spacing.data());
	image->SetOrigin(layout.origin.data());
	manifest.setLengthUnits(layout.length_units);
	manifest.setTimeUnits(layout.time_units);
	manifest.setImaging({"rows-down", true});
	manifest.addLone(image);
	manifest.offerTimes(std::move(times.times));
}

} // namespace vp::reader::volumes
