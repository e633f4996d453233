#include "formats.h"
#include "manifest_writer.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkGenericEnSightReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

void readEnSight(const Request& request, ManifestWriter& manifest)
{
	vtkNew<vtkGenericEnSightReader> reader;
	reader->SetCaseFileName(request.file.c_str());
	reader->ReadAllVariablesOn();
	updateAtTime(*reader, request, manifest);
	manifest.add(reader->GetOutputDataObject(0));
}
