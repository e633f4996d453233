#include "formats.h"
#include "manifest_writer.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkDataSet.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>

void readHdf(const Request& request, ManifestWriter& manifest)
{
	vtkNew<vtkHDFReader> reader;
	if (!reader->CanReadFile(request.file.c_str()))
		throw Refusal("not a VTKHDF file, though its first bytes are HDF5's, or a damaged one");
	reader->SetFileName(request.file.c_str());
	updateAtTime(*reader, request, manifest);
	manifest.add(reader->GetOutputDataObject(0));
}
