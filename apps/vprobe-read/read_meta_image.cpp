#include "complaints.h"
#include "formats.h"
#include "manifest_writer.h"
#include "meta_header.h"
#include "refusal.h"

#include <vtkImageData.h>
#include <vtkMetaImageReader.h>
#include <vtkNew.h>

void readMetaImage(const Request& request, ManifestWriter& manifest)
{
	MetaHeader header = readMetaHeader(request.file);
	if (header.size.size() < 3)
		throw Refusal("nothing to slice: a picture of two dimensions");
	if (header.element_bytes == 0)
		throw damaged("its ElementType is unknown");
	makeSpacingPositive(header);
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
		image->SetSpacing(header.spacing.data());       // VTK's reader drops the sign
	image->SetDirectionMatrix(header.direction.data()); // which VTK's reader leaves out
	manifest.addLone(image);
}
