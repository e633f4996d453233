#include "formats.h"
#include "manifest_writer.h"
#include "netcdf_size.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkExodusIIReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include <string_view>

void readExodus(const Request& request, ManifestWriter& manifest)
{
	refuseShortNetcdf(request.file);
	vtkNew<vtkExodusIIReader> reader;
	if (!reader->CanReadFile(request.file.c_str()))
		throw Refusal("not an Exodus II file, though its first bytes are netCDF's or HDF5's");
	reader->SetFileName(request.file.c_str());
	reader->SetApplyDisplacements(request.displace != 0.0);
	reader->SetDisplacementMagnitude(static_cast<float>(request.displace));
	reader->UpdateInformation();
	reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
	reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
	for (int block = 0; block < reader->GetNumberOfObjects(vtkExodusIIReader::ELEM_BLOCK); ++block)
		reader->SetObjectStatus(vtkExodusIIReader::ELEM_BLOCK, block, 1);
	for (int set = 0; request.patches && set < reader->GetNumberOfObjects(vtkExodusIIReader::SIDE_SET); ++set)
		reader->SetObjectStatus(vtkExodusIIReader::SIDE_SET, set, 1);
	updateAtTime(*reader, request, manifest);
	// Cells and what else they have, by kind of object.
	auto* objects = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
	for (unsigned int kind = 0; objects && kind < objects->GetNumberOfBlocks(); ++kind)
	{
		const char* name =
		    objects->HasMetaData(kind) ? objects->GetMetaData(kind)->Get(vtkCompositeDataSet::NAME()) : "";
		if (name && std::string_view(name) == "Side Sets")
			manifest.addPatches(objects->GetBlock(kind));
		else
			manifest.add(objects->GetBlock(kind));
	}
}
