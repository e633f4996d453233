#include "complaints.h"
#include "formats.h"
#include "manifest_writer.h"
#include "meta_header.h"
#include "refusal.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMetaImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <fmt/format.h>

#include <cstring>

namespace
{

// VTK's reader takes MET_LONG for 8 bytes, where MetaIO has put values of 4 in the first half of the room.
void narrowLongs(vtkImageData* image, int type)
{
	vtkDataArray* longs = image->GetPointData()->GetScalars();
	if (!longs || longs->GetDataTypeSize() != 8)
		return;
	const auto narrow = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
	narrow->SetName(longs->GetName());
	narrow->SetNumberOfComponents(longs->GetNumberOfComponents());
	narrow->SetNumberOfTuples(longs->GetNumberOfTuples());
	std::memcpy(narrow->GetVoidPointer(0), longs->GetVoidPointer(0),
	            static_cast<std::size_t>(narrow->GetNumberOfValues()) * 4);
	image->GetPointData()->SetScalars(narrow);
}

} // namespace

void readMetaImage(const Request& request, ManifestWriter& manifest)
{
	MetaHeader header = readMetaHeader(request.file);
	if (header.size.size() < 3)
		throw Refusal("nothing to slice: a picture of two dimensions");
	if (header.element_bytes == 0)
		throw damaged("its ElementType is unknown");
	makeSpacingPositive(header);
	if (header.type == "MET_LONG_LONG" || header.type == "MET_ULONG_LONG")
		throw Refusal(fmt::format("its ElementType {} is not read; save it as MET_DOUBLE, or as NRRD", header.type));
	refuseShortData(request.file, header);

	vtkNew<vtkMetaImageReader> reader;
	if (!reader->CanReadFile(request.file.c_str()))
		throw damaged("its header cannot be read");
	reader->SetFileName(request.file.c_str());
	reader->Update();
	refuseOnComplaint();

	vtkImageData* image = reader->GetOutput();
	const int* points = image->GetDimensions();
	for (int axis = 0; axis < 3; ++axis)
		if (points[axis] < 0 || header.size[axis] != static_cast<std::uint64_t>(points[axis]))
			throw damaged("its header cannot be followed");
	if (header.spacing.size() >= 3)
		image->SetSpacing(header.spacing.data()); // VTK's reader drops the sign
	if (header.type == "MET_LONG" || header.type == "MET_ULONG")
		narrowLongs(image, header.type == "MET_LONG" ? VTK_INT : VTK_UNSIGNED_INT);
	image->SetDirectionMatrix(header.direction.data()); // which VTK's reader leaves out
	manifest.addLone(image);
}
