// A volume in slices: TIFF or PNG files of one page each, in a folder or by a pattern, in the order of their numbers.
#include "tiff_layout.h"
#include "tiff_pages.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/slice_files.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <optional>

namespace vp::reader::volumes
{

namespace fs = std::filesystem;

namespace
{

bool isPngFile(const std::string& file)
{
	const std::string ending = fs::path(file).extension().string();
	return ending == ".png" || ending == ".PNG";
}

std::string fileNameOf(const std::string& file)
{
	return fs::path(file).filename().string();
}

// One picture, rows from the top.
struct SlicePicture
{
	arrays::ValueLayout values;
	std::optional<TiffPages> pages{}; // if it is a TIFF file
	vtkSmartPointer<vtkImageData> image{};
};

SlicePicture tiffSlice(const std::string& file)
{
	SlicePicture slice;
	TiffPages& pages = slice.pages.emplace(file);
	if (pages.count() != 1)
		throw Refusal(fmt::format("{} has {} pages, and a slice has one; name the file, or several without quotes",
		                          fileNameOf(file), pages.count()));
	const TiffPageKind& kind = pages.kind(0);
	slice.values = {{kind.width, kind.height, 1}, kind.samples, kind.type()};
	pages.refuseImpossible(0);
	return slice;
}

SlicePicture pngSlice(const std::string& file)
{
	vtkNew<vtkPNGReader> reader;
	if (reader->CanReadFile(file.c_str()) == 0)
		throw damaged(fmt::format("{} is no PNG file", fileNameOf(file)));
	reader->SetFileName(file.c_str());
	reader->Update();
	SlicePicture slice;
	slice.image = reader->GetOutput();
	std::array<int, 3> size;
	slice.image->GetDimensions(size.data());
	vtkDataArray* values = slice.image->GetPointData()->GetScalars();
	if (!values || size[0] < 1 || size[1] < 1)
		throw damaged(fmt::format("{} holds no picture", fileNameOf(file)));
	slice.values = {{static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]), 1},
	                static_cast<std::uint32_t>(values->GetNumberOfComponents()),
	                values->GetDataType() == VTK_UNSIGNED_SHORT ? grid::NumberType::uint16 : grid::NumberType::uint8};
	return slice;
}

void copyRows(SlicePicture& slice, char* to)
{
	if (slice.pages)
		return slice.pages->read(0, to);
	// VTK has the last row first.
	const auto* from = static_cast<const char*>(slice.image->GetPointData()->GetScalars()->GetVoidPointer(0));
	const std::size_t rows = slice.values.points[1], row = slice.values.byteCount() / rows;
	for (std::size_t y = 0; y < rows; ++y)
		std::memcpy(to + y * row, from + (rows - 1 - y) * row, row);
}

// The last number in a name, if there is one.
std::optional<std::uint64_t> numberOf(const std::string& file)
{
	const std::string stem = fs::path(file).stem().string();
	const auto isDigit = [](unsigned char c) { return std::isdigit(c) != 0; };
	const auto end = std::find_if(stem.rbegin(), stem.rend(), isDigit);
	const auto begin = std::find_if_not(end, stem.rend(), isDigit);
	const std::string digits(begin.base(), end.base());
	if (digits.empty() || digits.size() > 18)
		return std::nullopt;
	return std::stoull(digits);
}

// A slice that is not there is told: its neighbors are shown one beside the other.
void tellOfGaps(const std::vector<std::string>& files, manifest::Writer& manifest)
{
	for (std::size_t i = 1; i < files.size(); ++i)
	{
		const auto before = numberOf(files[i - 1]), here = numberOf(files[i]);
		const auto first = numberOf(files[0]), second = numberOf(files[1]);
		if (!before || !here || !first || !second || *here <= *before || *second <= *first)
			return;
		if (*here - *before != *second - *first)
			return manifest.warn(fmt::format("no slice lies between {} and {}, whose numbers are farther apart than "
			                                 "those of the first two",
			                                 fileNameOf(files[i - 1]), fileNameOf(files[i])));
	}
}

// Takes the distances of the values from the first TIFF file.
void placeImage(const std::string& first, vtkImageData* image, manifest::Writer& manifest)
{
	if (isPngFile(first))
		return;
	TiffPages pages(first);
	TiffLayout layout;
	try
	{
		layout = tiffLayout({fileNameOf(first), pages.description(), 1, pages.kind(0).samples, pages.resolution(),
		                     pages.resolutionUnit()});
	}
	catch (const Refusal&)
	{
		return; // its description is of a whole stack
	}
	image->SetSpacing(layout.spacing.data());
	image->SetOrigin(layout.origin.data());
	manifest.setLengthUnits(layout.length_units);
}

} // namespace

void readSlices(const Request& request, manifest::Writer& manifest)
{
	const std::vector<std::string> files = request.slices.empty() ? checks::sliceFiles(request.file) : request.slices;
	if (files.empty())
		throw Refusal("no TIFF or PNG file is there; check the folder or the pattern");
	const bool are_png = isPngFile(files.front());
	if (std::any_of(files.begin(), files.end(), [&](const std::string& file) { return isPngFile(file) != are_png; }))
		throw Refusal(fmt::format("holds TIFF and PNG files; choose by a pattern in quotes, '{}/*.{}'",
		                          fs::path(files.front()).parent_path().string(), are_png ? "png" : "tif"));
	if (files.size() < 2)
		throw Refusal("nothing to slice: it holds one picture; a volume has two slices or more");
	const auto open = [&](const std::string& file) { return are_png ? pngSlice(file) : tiffSlice(file); };
	arrays::ValueLayout volume = open(files.front()).values;
	const std::uint64_t bytes = volume.byteCount();
	volume.points[2] = static_cast<std::uint32_t>(files.size());
	const auto array = arrays::emptyArray(volume, "values");
	auto* to = static_cast<char*>(array->GetVoidPointer(0));
	for (std::size_t i = 0; i < files.size(); ++i)
	{
		SlicePicture slice = open(files[i]);
		const arrays::ValueLayout& values = slice.values;
		if (values.points[0] != volume.points[0] || values.points[1] != volume.points[1] ||
		    values.components != volume.components || values.type != volume.type)
			throw Refusal(fmt::format("{} has another size or type than {}; keep the slices of one volume together",
			                          fileNameOf(files[i]), fileNameOf(files.front())));
		copyRows(slice, to + i * bytes);
	}
	tellOfGaps(files, manifest);
	const vtkSmartPointer<vtkImageData> image = arrays::imageOf(array, volume.points);
	placeImage(files.front(), image, manifest);
	manifest.setImaging({"rows-down", true});
	manifest.addLone(image);
}

} // namespace vp::reader::volumes
