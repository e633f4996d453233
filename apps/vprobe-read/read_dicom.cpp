// DICOM through GDCM: one file of many frames, or the files of a series, named by one of them or by their folder.
#include "dicom_slice.h"
#include "formats.h"
#include "manifest_writer.h"
#include "mapped_text.h"
#include "read_files.h"
#include "refusal.h"
#include "time_choice.h"
#include "value_image.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <fmt/format.h>

#include <gdcmImageReader.h>
#include <gdcmRescaler.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>

using vp::grid::NumberType;

namespace
{

namespace fs = std::filesystem;

constexpr int kMaxFiles = 100000;

NumberType typeOf(gdcm::PixelFormat::ScalarType type)
{
	switch (type)
	{
	case gdcm::PixelFormat::UINT8:
		return NumberType::uint8;
	case gdcm::PixelFormat::INT8:
		return NumberType::int8;
	case gdcm::PixelFormat::UINT12:
	case gdcm::PixelFormat::UINT16:
		return NumberType::uint16;
	case gdcm::PixelFormat::INT12:
	case gdcm::PixelFormat::INT16:
		return NumberType::int16;
	case gdcm::PixelFormat::UINT32:
		return NumberType::uint32;
	case gdcm::PixelFormat::INT32:
		return NumberType::int32;
	case gdcm::PixelFormat::FLOAT32:
		return NumberType::float32;
	case gdcm::PixelFormat::FLOAT64:
		return NumberType::float64;
	default:
		throw Refusal("pixels of a DICOM type that is not read; convert it with gdcmconv");
	}
}

// A file's pixels, rescaled to what they stand for.
struct Pixels
{
	ValueLayout layout;
	std::string bytes;
	std::array<double, 3> origin;
	std::array<double, 3> spacing;
	std::array<double, 6> axes;
};

// GDCM makes up the rest of pixels that a file does not have. Pixels have a length of their own, or end with a mark.
void refuseShortPixels(const std::string& file)
{
	constexpr std::string_view tag("\xE0\x7F\x10\x00", 4);
	constexpr std::string_view end_mark("\xFE\xFF\xDD\xE0", 4);
	const MappedText mapped(file);
	const std::string_view text = mapped.text();
	for (std::size_t at = text.find(tag, 132); at != text.npos; at = text.find(tag, at))
	{
		at += tag.size();
		const std::string_view type = text.substr(at, 2);
		if (type == "OW" || type == "OB" || type == "UN")
			at += 4;
		std::uint32_t length = 0;
		if (text.size() - at >= sizeof length)
			std::memcpy(&length, text.data() + at, sizeof length);
		at = std::min(at + sizeof length, text.size());
		const bool is_short = length == ~std::uint32_t(0) ? text.find(end_mark, at) == text.npos
		                                                  : length == 0 || text.size() - at < length;
		if (is_short)
			throw damaged(fmt::format("{} ends within its pixels", fs::path(file).filename().string()));
		if (length != ~std::uint32_t(0))
			at += length;
	}
}

Pixels pixelsOf(const std::string& file)
{
	refuseShortPixels(file);
	gdcm::ImageReader reader;
	reader.SetFileName(file.c_str());
	if (!reader.Read())
		throw damaged(fmt::format("GDCM cannot read {}", fs::path(file).filename().string()));
	const gdcm::Image& image = reader.GetImage();
	const unsigned* sides = image.GetDimensions();
	Pixels pixels;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		pixels.layout.points[axis] = axis < image.GetNumberOfDimensions() ? sides[axis] : 1;
		pixels.origin[axis] = image.GetOrigin(static_cast<unsigned>(axis));
		pixels.spacing[axis] = image.GetSpacing(static_cast<unsigned>(axis));
	}
	for (std::size_t i = 0; i < 6; ++i)
		pixels.axes[i] = image.GetDirectionCosines(static_cast<unsigned>(i));
	pixels.layout.components = image.GetPixelFormat().GetSamplesPerPixel();
	if (pixels.layout.components > 1 && image.GetPlanarConfiguration() != 0)
		throw Refusal("pixels with a plane for each color; convert it with gdcmconv --raw");

	gdcm::Rescaler rescaler;
	rescaler.SetIntercept(image.GetIntercept());
	rescaler.SetSlope(image.GetSlope());
	rescaler.SetPixelFormat(image.GetPixelFormat());
	const bool is_rescaled = image.GetSlope() != 1.0 || image.GetIntercept() != 0.0;
	pixels.layout.type =
	    typeOf(is_rescaled ? rescaler.ComputeInterceptSlopePixelType() : image.GetPixelFormat().GetScalarType());
	ValueLayout stored = pixels.layout;
	stored.type = typeOf(image.GetPixelFormat().GetScalarType());
	if (image.GetBufferLength() != stored.byteCount())
		throw damaged(fmt::format("{} has {} bytes of pixels where {} are wanted", fs::path(file).filename().string(),
		                          image.GetBufferLength(), stored.byteCount()));
	std::string raw(stored.byteCount(), '\0');
	if (!image.GetBuffer(raw.data()))
		throw damaged(fmt::format("the pixels of {} do not unpack", fs::path(file).filename().string()));
	if (!is_rescaled)
		pixels.bytes = std::move(raw);
	else
	{
		pixels.bytes.resize(pixels.layout.byteCount());
		if (!rescaler.Rescale(pixels.bytes.data(), raw.data(), raw.size()))
			throw damaged("its pixels cannot be rescaled");
	}
	return pixels;
}

// The files of one series: that of `request.file`, or, where it is a folder, the largest in it.
std::vector<DicomSlice> sliceFiles(const Request& request, ManifestWriter& manifest)
{
	const bool is_folder = fs::is_directory(request.file);
	const fs::path folder = is_folder ? fs::path(request.file) : fs::absolute(request.file).parent_path();
	std::string wanted;
	if (!is_folder)
	{
		const auto given = dicomSlice(request.file);
		if (!given)
			throw damaged("not a DICOM image that can be opened");
		if (given->frames > 1)
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
	const auto smaller = [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); };
	const auto chosen = is_folder ? std::max_element(series.begin(), series.end(), smaller) : series.find(wanted);
	if (chosen == series.end())
		throw damaged("it is gone");
	if (is_folder && series.size() > 1)
		manifest.warn(
		    fmt::format("the largest of {} series is shown; name a file to see that of another", series.size()));
	return std::move(chosen->second);
}

// By depth; files at the same depth are times, by their numbers.
std::vector<std::vector<DicomSlice>> stacksOf(std::vector<DicomSlice> slices)
{
	std::sort(slices.begin(), slices.end(),
	          [](const DicomSlice& a, const DicomSlice& b)
	          { return std::pair(a.depth(), a.number) < std::pair(b.depth(), b.number); });
	constexpr double kSame = 1e-4; // mm
	std::vector<std::vector<DicomSlice>> times;
	std::size_t time = 0;
	for (std::size_t s = 0; s < slices.size(); ++s)
	{
		time = s > 0 && std::abs(slices[s].depth() - slices[s - 1].depth()) < kSame ? time + 1 : 0;
		if (time == times.size())
			times.emplace_back();
		times[time].push_back(slices[s]);
	}
	for (const auto& stack : times)
		if (stack.size() != times[0].size())
			throw Refusal("its slices lie in the same place, and not equally many in each; keep one time in a folder");
	return times;
}

} // namespace

void readDicom(const Request& request, ManifestWriter& manifest)
{
	gdcm::Trace::WarningOff();
	gdcm::Trace::ErrorOff();
	const std::vector<std::vector<DicomSlice>> stacks = stacksOf(sliceFiles(request, manifest));
	std::vector<double> times;
	for (std::size_t t = 0; stacks.size() > 1 && t < stacks.size(); ++t)
		times.push_back(static_cast<double>(t));
	const auto& slices = stacks[static_cast<std::size_t>(chooseIfAny(times, request).value_or(0.0))];

	Pixels all = pixelsOf(slices[0].file);
	if (slices.size() == 1 && all.layout.points[2] < 2)
		throw Refusal("nothing to slice: a single picture; keep the files of a series in one folder");
	std::vector<std::array<double, 3>> origins = {all.origin};
	for (std::size_t s = 1; s < slices.size(); ++s)
	{
		Pixels one = pixelsOf(slices[s].file);
		if (one.layout.points != std::array{all.layout.points[0], all.layout.points[1], 1u} ||
		    one.layout.type != all.layout.type || one.layout.components != all.layout.components ||
		    one.axes != all.axes)
			throw Refusal(fmt::format("{} is of another size, type or direction than the rest of its series",
			                          fs::path(slices[s].file).filename().string()));
		all.bytes += one.bytes;
		origins.push_back(one.origin);
	}
	// Between the first and the last slice, which need not be as far apart as they are thick.
	const auto& x = all.axes;
	std::array<double, 3> normal = {x[1] * x[5] - x[2] * x[4], x[2] * x[3] - x[0] * x[5], x[0] * x[4] - x[1] * x[3]};
	if (slices.size() > 1)
	{
		all.layout.points[2] = static_cast<std::uint32_t>(slices.size());
		std::array<double, 3> way;
		for (std::size_t a = 0; a < 3; ++a)
			way[a] = (origins.back()[a] - origins.front()[a]) / static_cast<double>(slices.size() - 1);
		all.spacing[2] = std::hypot(way[0], way[1], way[2]);
		for (std::size_t a = 0; a < 3; ++a)
			normal[a] = way[a] / all.spacing[2];
		for (std::size_t s = 1; s + 1 < slices.size(); ++s)
			for (std::size_t a = 0; a < 3; ++a)
				if (std::abs(origins[0][a] + way[a] * static_cast<double>(s) - origins[s][a]) > 0.01 * all.spacing[2])
					throw Refusal(fmt::format("{} is not as far from its neighbors as the other slices; a slice is "
					                          "missing, or the series has several parts",
					                          fs::path(slices[s].file).filename().string()));
	}
	const auto image = imageOf(arrayOf(all.bytes, all.layout, "DICOM"), all.layout.points);
	std::array<double, 9> direction;
	for (std::size_t row = 0; row < 3; ++row)
	{
		direction[3 * row] = x[row];
		direction[3 * row + 1] = x[3 + row];
		direction[3 * row + 2] = normal[row];
	}
	for (const double number : direction)
		if (!std::isfinite(number))
			throw damaged("its directions make no grid");
	for (const double spacing : all.spacing)
		if (!std::isfinite(spacing) || spacing <= 0.0)
			throw damaged("its spacings make no grid");
	image->SetOrigin(origins[0].data());
	image->SetSpacing(all.spacing.data());
	image->SetDirectionMatrix(direction.data());
	manifest.setLengthUnits("mm");
	manifest.addLone(image);
	manifest.offerTimes(std::move(times));
}
