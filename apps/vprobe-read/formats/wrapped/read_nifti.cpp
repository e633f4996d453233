#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/structured_blocks.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageHeader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace vp::reader::wrapped
{

namespace
{

bool isRescaled(vtkNIFTIImageReader* reader)
{
	const double slope = reader->GetRescaleSlope(), intercept = reader->GetRescaleIntercept();
	return slope != 0.0 && std::isfinite(slope) && std::isfinite(intercept) && (slope != 1.0 || intercept != 0.0);
}

// The components of one time, where each time is a component or several; as stored, or rescaled to real values.
vtkSmartPointer<vtkDataArray> valuesAt(vtkDataArray* all, int first, int components, vtkNIFTIImageReader* reader)
{
	const bool rescaled = isRescaled(reader);
	const double slope = reader->GetRescaleSlope(), intercept = reader->GetRescaleIntercept();
	const auto values =
	    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(rescaled ? VTK_DOUBLE : all->GetDataType()));
	values->SetName("NIFTI");
	values->SetNumberOfComponents(components);
	values->SetNumberOfTuples(all->GetNumberOfTuples());
	for (int component = 0; component < components; ++component)
		values->CopyComponent(component, all, first + component);
	if (rescaled)
		for (vtkIdType tuple = 0; tuple < values->GetNumberOfTuples(); ++tuple)
			for (int component = 0; component < components; ++component)
				values->SetComponent(tuple, component, values->GetComponent(tuple, component) * slope + intercept);
	return values;
}

// The header's code; its other bits are of time.
std::string lengthUnitsOfCode(int code)
{
	constexpr int kOfSpace = 7;
	constexpr const char* names[] = {"", "m", "mm", "µm"};
	return (code & kOfSpace) < 4 ? names[code & kOfSpace] : "";
}

std::optional<std::pair<double, double>> windowOf(vtkNIFTIImageHeader& header)
{
	const double lo = header.GetCalMin(), hi = header.GetCalMax();
	return lo < hi && std::isfinite(hi - lo) ? std::optional(std::pair{lo, hi}) : std::nullopt;
}

std::string timeUnitsOfCode(int code)
{
	switch (code & 0x38)
	{
	case 8:
		return "s";
	case 16:
		return "ms";
	case 24:
		return "µs";
	default:
		return "";
	}
}

// The direction of the axes, and the place of the first point, in the right column.
vtkMatrix4x4* placeOfNifti(vtkNIFTIImageReader& reader)
{
	return reader.GetSFormMatrix() ? reader.GetSFormMatrix() : reader.GetQFormMatrix();
}

void placeNifti(vtkImageData& image, vtkNIFTIImageReader& reader)
{
	vtkMatrix4x4* place = placeOfNifti(reader);
	if (!place)
		return;
	std::array<double, 9> direction;
	for (int row = 0; row < 3; ++row)
		for (int column = 0; column < 3; ++column)
			direction[3 * row + column] = place->GetElement(row, column);
	image.SetDirectionMatrix(direction.data());
	image.SetOrigin(place->GetElement(0, 3), place->GetElement(1, 3), place->GetElement(2, 3));
}

// Values that may stay where they are: numbers of one time after those of the other.
struct NiftiValues
{
	std::string file;
	std::uint64_t begin = 0;
	arrays::ValueLayout layout; // at one time
	bool is_reversed = false;   // the reader turns the order of the layers, so that the axes are right-handed
};

// The file with the values, as the reader of VTK finds it. Empty if they are packed.
std::string niftiValuesFile(const std::string& file)
{
	std::filesystem::path path = file;
	if (path.extension() == ".hdr")
		path.replace_extension(".img");
	std::error_code absent;
	if (!std::filesystem::is_regular_file(path, absent) || MappedText(path.string()).text().starts_with("\x1f\x8b"))
		return {};
	return path.string();
}

// Returns nothing if the values cannot stay in the file, or if a whole read has to say what is wrong.
std::optional<NiftiValues> plainNifti(const Request& request, vtkNIFTIImageReader* reader)
{
	if (request.stays_above == ~std::uint64_t(0))
		return std::nullopt;
	reader->UpdateInformation();
	NiftiValues values;
	values.file = niftiValuesFile(request.file);
	values.begin = reader->GetHeaderSize();
	const std::uint64_t steps = std::max(reader->GetTimeDimension(), 1);
	const auto type = arrays::numberTypeOfVtk(reader->GetDataScalarType());
	const auto components = static_cast<std::uint64_t>(reader->GetNumberOfScalarComponents());
	// Components may lie one behind the other, as times do, and are no parts then.
	vtkNIFTIImageHeader& header = *reader->GetNIFTIHeader();
	const bool is_planar = header.GetDim(0) > 4 && header.GetDim(5) != 1;
	if (reader->GetErrorCode() != 0 || values.file.empty() || !type || components % steps != 0 || is_planar ||
	    isRescaled(reader))
		return std::nullopt;
	for (int axis = 0; axis < 3; ++axis)
	{
		if (reader->GetDataExtent()[2 * axis + 1] < 0)
			return std::nullopt;
		values.layout.points[axis] = static_cast<std::uint32_t>(reader->GetDataExtent()[2 * axis + 1]) + 1;
	}
	values.layout.type = *type;
	values.layout.components = static_cast<std::uint32_t>(components / steps);
	values.layout.is_big_endian = reader->GetSwapBytes() != 0;
	values.is_reversed = reader->GetQFac() < 0;
	vtkNew<vtkImageData> empty;
	placeNifti(*empty, *reader);
	std::uint64_t all = 0;
	const std::uint64_t size = std::filesystem::file_size(values.file);
	const bool is_there = !__builtin_mul_overflow(values.layout.byteCount(), steps, &all) && values.begin <= size &&
	                      all <= size - values.begin;
	const bool stays =
	    request.leaves(values.layout.byteCount()) && is_there && cells::isAxisAligned(empty->GetDirectionMatrix());
	return stays ? std::optional(values) : std::nullopt;
}

vtkSmartPointer<vtkDataArray> storedNifti(const NiftiValues& values, std::uint64_t step)
{
	const arrays::ValueLayout& layout = values.layout;
	const std::uint64_t begin = values.begin + step * layout.byteCount();
	if (!values.is_reversed)
		return arrays::storedArray(layout, "NIFTI", arrays::storedRows(values.file, begin, layout));
	const std::uint64_t item_bytes = layout.components * byteSize(layout.type);
	const std::uint64_t layer_bytes = layout.points[0] * item_bytes * layout.points[1];
	std::vector<std::uint64_t> layers;
	for (std::uint64_t layer = layout.points[2]; layer-- > 0;)
		layers.push_back(begin + layer * layer_bytes);
	return arrays::storedArray(layout, "NIFTI",
	                           arrays::storedLayers(values.file, layers,
	                                                {layout.points[0], layout.points[1], layout.points[2]}, item_bytes,
	                                                layout.is_big_endian && byteSize(layout.type) > 1));
}

} // namespace

void readNifti(const Request& request, manifest::Writer& manifest)
{
	vtkNew<vtkNIFTIImageReader> reader;
	if (!reader->CanReadFile(request.file.c_str()))
		throw damaged("not a NIfTI file that can be opened");
	reader->SetFileName(request.file.c_str());
	reader->TimeAsVectorOn();
	const std::optional<NiftiValues> plain = plainNifti(request, reader);
	if (!plain)
		reader->Update();
	checks::refuseOnComplaint();
	if (reader->GetErrorCode() != 0)
		throw damaged("the reader gave up");

	vtkSmartPointer<vtkImageData> image = reader->GetOutput();
	vtkDataArray* all = image->GetPointData()->GetScalars();
	if (!plain && (!all || image->GetNumberOfPoints() == 0))
		throw damaged("it holds no values");
	const int steps = std::max(reader->GetTimeDimension(), 1);
	const int components = reader->GetNumberOfScalarComponents() / steps;
	if (components * steps != reader->GetNumberOfScalarComponents())
		throw damaged("its times do not match its values");
	std::vector<double> times;
	const double step = reader->GetTimeSpacing();
	for (int i = 0; steps > 1 && i < steps; ++i)
		times.push_back(i * (std::isfinite(step) && step > 0.0 ? step : 1.0));
	int chosen = 0;
	if (const std::optional<double> time = manifest::chooseIfAny(times, request))
		chosen = static_cast<int>(std::find(times.begin(), times.end(), *time) - times.begin());
	if (plain)
	{
		image = arrays::imageOf(storedNifti(*plain, static_cast<std::uint64_t>(chosen)), plain->layout.points);
		image->SetSpacing(reader->GetDataSpacing());
	}
	else
	{
		const auto values = valuesAt(all, chosen * components, components, reader);
		image->GetPointData()->Initialize();
		image->GetPointData()->SetScalars(values);
	}
	placeNifti(*image, *reader);
	manifest.setLengthUnits(lengthUnitsOfCode(reader->GetNIFTIHeader()->GetXYZTUnits()));
	constexpr int kIntentLabel = 1002; // NIFTI_INTENT_LABEL of nifti1.h
	vtkNIFTIImageHeader& header = *reader->GetNIFTIHeader();
	manifest.setImaging({"RAS", true, header.GetIntentCode() == kIntentLabel, windowOf(header)});
	manifest.setTimeUnits(timeUnitsOfCode(reader->GetNIFTIHeader()->GetXYZTUnits()));
	manifest.addLone(image);
	manifest.offerTimes(std::move(times));
}

} // namespace vp::reader::wrapped
