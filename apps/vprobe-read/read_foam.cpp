#include "complaints.h"
#include "formats.h"
#include "manifest_writer.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>

#include <string>

void readFoam(const Request& request, ManifestWriter& manifest)
{
	takeWarningsToo(); // which is how this reader tells of files that end early
	vtkNew<vtkOpenFOAMReader> reader;
	reader->SetFileName(request.file.c_str());
	reader->SetDecomposePolyhedra(false);
	reader->SetCreateCellToPoint(true);
	reader->SetCacheMesh(false);
	reader->UpdateInformation();
	refuseOnComplaint();
	// The cells of each region; its patches, sets and particles are flat.
	bool has_cells = false;
	for (int i = 0; i < reader->GetNumberOfPatchArrays(); ++i)
	{
		const std::string name = reader->GetPatchArrayName(i);
		const bool cells = name.ends_with("internalMesh");
		reader->SetPatchArrayStatus(name.c_str(), cells);
		has_cells |= cells;
	}
	if (!has_cells)
		throw damaged("no constant/polyMesh with cells beside it");
	reader->EnableAllCellArrays();
	reader->EnableAllPointArrays();
	reader->DisableAllLagrangianArrays();
	updateAtTime(*reader, request, manifest);
	manifest.add(reader->GetOutputDataObject(0));
}
