#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageHeader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::reader::wrapped
{

namespace
{

// The components of one time, where each time is a component or several; as stored, or rescaled to real values.
vtkSmartPointer<vtkDataArray> valuesAt(vtkDataArray* all, int first, int components, double slope, double intercept)
{
	const bool rescaled =
	    slope != 0.0 && std::isfinite(slope) && std::isfinite(intercept) && (slope != 1.0 || intercept != 0.0);
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

} // namespace

void readNifti(const Request& request, manifest::Writer& manifest)
{
	vtkNew<vtkNIFTIImageReader> reader;
	if (!reader->CanReadFile(request.file.c_str()))
		throw damaged("not a NIfTI file that can be opened");
	reader->SetFileName(request.file.c_str());
	reader->TimeAsVectorOn();
	reader->Update();
	checks::refuseOnComplaint();
	if (reader->GetErrorCode() != 0)
		throw damaged("the reader gave up");

	vtkImageData* image = reader->GetOutput();
	vtkDataArray* all = image->GetPointData()->GetScalars();
	if (!all || image->GetNumberOfPoints() == 0)
		throw damaged("it holds no values");
	const int steps = std::max(reader->GetTimeDimension(), 1);
	const int components = all->GetNumberOfComponents() / steps;
	if (components * steps != all->GetNumberOfComponents())
		throw damaged("its times do not match its values");
	std::vector<double> times;
	const double step = reader->GetTimeSpacing();
	for (int i = 0; steps > 1 && i < steps; ++i)
		times.push_back(i * (std::isfinite(step) && step > 0.0 ? step : 1.0));
	int chosen = 0;
	if (const std::optional<double> time = manifest::chooseIfAny(times, request))
		chosen = static_cast<int>(std::find(times.begin(), times.end(), *time) - times.begin());
	const auto values =
	    valuesAt(all, chosen * components, components, reader->GetRescaleSlope(), reader->GetRescaleIntercept());
	image->GetPointData()->Initialize();
	image->GetPointData()->SetScalars(values);

	if (vtkMatrix4x4* place = reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix())
	{
		std::array<double, 9> direction;
		for (int row = 0; row < 3; ++row)
			for (int column = 0; column < 3; ++column)
				direction[3 * row + column] = place->GetElement(row, column);
		image->SetDirectionMatrix(direction.data());
		image->SetOrigin(place->GetElement(0, 3), place->GetElement(1, 3), place->GetElement(2, 3));
	}
	manifest.setLengthUnits(lengthUnitsOfCode(reader->GetNIFTIHeader()->GetXYZTUnits()));
	constexpr int kIntentLabel = 1002; // NIFTI_INTENT_LABEL of nifti1.h
	vtkNIFTIImageHeader& header = *reader->GetNIFTIHeader();
	manifest.setImaging({"RAS", true, header.GetIntentCode() == kIntentLabel, windowOf(header)});
	manifest.setTimeUnits(timeUnitsOfCode(reader->GetNIFTIHeader()->GetXYZTUnits()));
	manifest.addLone(image);
	manifest.offerTimes(std::move(times));
}

} // namespace vp::reader::wrapped
