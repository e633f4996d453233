#include "ensight_check.h"
#include "formats.h"
#include "manifest_writer.h"
#include "refusal.h"
#include "text_end.h"
#include "time_choice.h"

#include <vtkGenericEnSightReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

void readEnSight(const Request& request, ManifestWriter& manifest)
{
	vtkNew<vtkGenericEnSightReader> reader;
	reader->SetCaseFileName(request.file.c_str());
	reader->ReadAllVariablesOn();
	const std::optional<double> time = updateAtTime(*reader, request, manifest);
	if (refuseShortEnSight(request.file, time))
		manifest.warn(kCutTextWarning);
	manifest.add(reader->GetOutputDataObject(0));
}
