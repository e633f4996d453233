#include "exodus_cells.h"
#include "exodus_nodal.h"
#include "exodus_points.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCompositeDataIterator.h>
#include <vtkDoubleArray.h>
#include <vtkExodusIIReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <string_view>

namespace vp::reader::wrapped
{

namespace
{

// Adds variables of the file's nodes to the blocks, which know the nodes of their points.
void addOddNodes(const std::vector<vtkSmartPointer<vtkDoubleArray>>& arrays, vtkMultiBlockDataSet* objects)
{
	const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(objects->NewIterator());
	for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
	{
		auto* grid = vtkUnstructuredGrid::SafeDownCast(leaf->GetCurrentDataObject());
		vtkDataArray* ids =
		    grid ? grid->GetPointData()->GetArray(vtkExodusIIReader::GetImplicitNodeIdArrayName()) : nullptr;
		if (!ids)
			continue;
		for (const auto& array : arrays)
		{
			vtkNew<vtkDoubleArray> part;
			part->SetName(array->GetName());
			part->SetNumberOfComponents(array->GetNumberOfComponents());
			part->SetNumberOfTuples(ids->GetNumberOfTuples());
			for (vtkIdType p = 0; p < ids->GetNumberOfTuples(); ++p)
			{
				const auto node = static_cast<vtkIdType>(ids->GetTuple1(p)) - 1;
				if (node < 0 || node >= array->GetNumberOfTuples())
					throw damaged("a point is none of its nodes");
				part->SetTuple(p, node, array);
			}
			grid->GetPointData()->AddArray(part);
		}
	}
}

void numberNodes(vtkMultiBlockDataSet* objects)
{
	const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(objects->NewIterator());
	for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
		if (auto* data = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()))
			numberExodusNodes(data);
}

// The numbers of the nodes have done their work.
void forgetNodes(vtkMultiBlockDataSet* objects)
{
	const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(objects->NewIterator());
	for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
		if (auto* data = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()))
			data->GetPointData()->RemoveArray(vtkExodusIIReader::GetImplicitNodeIdArrayName());
}

} // namespace

void readExodus(const Request& request, manifest::Writer& manifest)
{
	checks::refuseShortNetcdf(request.file);
	hdf5::refuseMissingParts(request.file);
	vtkNew<vtkExodusIIReader> reader;
	if (!reader->CanReadFile(request.file.c_str()))
		throw Refusal("not an Exodus II file, though its first bytes are netCDF's or HDF5's");
	refuseMissingExodus(request.file);
	reader->SetFileName(request.file.c_str());
	reader->SetApplyDisplacements(false); // that is done for all formats
	reader->UpdateInformation();
	checks::refuseOnComplaint();
	for (const std::string& name : repeatedExodusNames(request.file))
		manifest.warn(fmt::format("several variables are called {}; only one of them is shown", name));
	const bool is_odd = hasOddExodusNodes(request.file);
	const std::vector<OddExodusBlock> odd_blocks = oddExodusBlocks(request.file);
	// VTK looks for the points of a block in a search tree, three quarters of its time for a million cells.
	const bool leaves_out = odd_blocks.empty() && !hasExodusPolyhedra(request.file);
	const bool squeezes = odd_blocks.empty() && !leaves_out;
	reader->SetSqueezePoints(squeezes);
	reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, is_odd ? 0 : 1);
	const bool sets_points = hasDoubleExodusPoints(request.file);
	const bool numbers_nodes = is_odd || sets_points;
	// VTK 9.1 crashes where it is to number points that it does not squeeze. Those are all nodes of the file, in order.
	reader->SetGenerateImplicitNodeIdArray(numbers_nodes && squeezes);
	reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
	for (int block = 0; block < reader->GetNumberOfObjects(vtkExodusIIReader::ELEM_BLOCK); ++block)
		reader->SetObjectStatus(vtkExodusIIReader::ELEM_BLOCK, block, 1);
	for (int set = 0; request.patches && set < reader->GetNumberOfObjects(vtkExodusIIReader::SIDE_SET); ++set)
		reader->SetObjectStatus(vtkExodusIIReader::SIDE_SET, set, 1);
	const std::vector<double> times = exodusTimes(request.file);
	const std::size_t step = manifest::offerSteps(times, request, manifest).value_or(0);
	if (times.empty())
		reader->Update();
	else
	{
		// By its number: the reader looks for times as if they rose, and takes equal ones for modes of a body.
		reader->SetIgnoreFileTime(true);
		reader->SetHasModeShapes(false);
		reader->UpdateTimeStep(static_cast<double>(step));
	}
	checks::refuseOnComplaint();
	if (reader->GetErrorCode() != 0)
		throw damaged("the reader gave up");
	// Cells and what else they have, by kind of object.
	auto* objects = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
	if (leaves_out && objects)
		leaveOutExodusPoints(objects, numbers_nodes);
	else if (numbers_nodes && !squeezes && objects)
		numberNodes(objects);
	if (is_odd && objects)
		addOddNodes(oddExodusNodes(request.file, step), objects);
	if (sets_points && objects && !setExodusPoints(request.file, objects))
		manifest.warn("the places of its points have 7 digits");
	if (!odd_blocks.empty() && objects)
		putExodusCellsRight(request.file, odd_blocks, reader, objects);
	if (objects)
		forgetNodes(objects);
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

} // namespace vp::reader::wrapped
