// Adds slabs of a lattice: some layers of its cells, with the points that they need.
#include "manifest_writer.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/structured_blocks.h"
#include "vprobe-read/cells/visible_cells.h"

#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <optional>

namespace vp::reader::manifest
{

namespace
{

// Returns the kind of lattice that a data set is, and its points. Returns null if it is not a lattice that has separate
// layers.
const char* latticeOf(vtkDataSet* data, std::array<int, 3>& points)
{
	if (auto* image = vtkImageData::SafeDownCast(data))
	{
		image->GetDimensions(points.data());
		return cells::isAxisAligned(image->GetDirectionMatrix()) ? "image" : nullptr;
	}
	if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
	{
		rectilinear->GetDimensions(points.data());
		return "rectilinear";
	}
	if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(data))
	{
		curvilinear->GetDimensions(points.data());
		return "curvilinear";
	}
	return nullptr;
}

std::array<int, 6> extentOf(vtkDataSet* lattice)
{
	std::array<int, 6> extent{};
	if (auto* image = vtkImageData::SafeDownCast(lattice))
		image->GetExtent(extent.data());
	else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(lattice))
		rectilinear->GetExtent(extent.data());
	else if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(lattice))
		curvilinear->GetExtent(extent.data());
	return extent;
}

} // namespace

void Writer::addLone(vtkDataObject* object)
{
	if (collected_)
		return add(object);
	auto* data = vtkDataSet::SafeDownCast(object);
	const vtkSmartPointer<vtkDataSet> moved = data ? displacement_.moved(data) : nullptr;
	const Displacement::Pause has_moved(displacement_);
	if (!moved || !parts_.splits() || !addSlab(moved))
		add(moved ? moved.Get() : object);
}

// Returns false, without beginning a part, if the data set is not a lattice that can be split.
bool Writer::addSlab(vtkDataSet* data)
{
	std::array<int, 3> points = {0, 0, 0};
	const char* kind = latticeOf(data, points);
	if (!kind || points[0] < 2 || points[1] < 2 || points[2] < 3 || !cells::hiddenCellsOf(data, points).empty())
		return false;
	const auto count = [&](int axis) { return static_cast<std::size_t>(points[axis]); };
	const std::optional<CellLayers> layers = parts_.beginLattice(
	    {{"kind", kind}, {"points", count(0) * count(1) * count(2)}}, count(2) - 1, (count(0) - 1) * (count(1) - 1));
	if (layers)
		addLayers(data, *layers);
	return true;
}

void Writer::addLayers(vtkDataObject* object, const CellLayers& layers)
{
	auto* read = vtkDataSet::SafeDownCast(object);
	const vtkSmartPointer<vtkDataSet> whole = read ? displacement_.moved(read) : nullptr;
	const Displacement::Pause has_moved(displacement_);
	std::array<int, 3> points = {0, 0, 0};
	if (!whole || !latticeOf(whole, points) || layers.end >= static_cast<std::size_t>(points[2]))
		throw damaged("it does not hold the lattice that its head describes");
	std::array<int, 6> extent = extentOf(whole);
	const std::array<int, 3> first = {extent[0], extent[2], extent[4]};
	extent[5] = extent[4] + static_cast<int>(layers.end);
	extent[4] += static_cast<int>(layers.begin);
	const auto slab = vtkSmartPointer<vtkDataSet>::Take(whole->NewInstance());
	slab->ShallowCopy(whole);
	slab->Crop(extent.data());
	const InsidePart inside(parts_);
	if (auto* image = vtkImageData::SafeDownCast(slab))
		addImageOf(image, first);
	else
		add(slab);
}

} // namespace vp::reader::manifest
