#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstdint>
#include <span>
#include <vector>

class vtkIdTypeArray;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace vp::reader::cells
{

// Collects the cells of a grid, one after the other. Each knows which cell of the file it is part of.
class GrownCells
{
public:
	GrownCells();
	~GrownCells();

	void startSource(vtkIdType cell) { source_ = cell; }
	void addPoint(vtkIdType point);
	// Adds the faces of a polyhedron: their number, then for each face its size and points.
	void addFaces(std::span<const vtkIdType> stream);
	// Ends a cell that has the points, and faces, added since the last.
	void endCell(std::uint8_t type);

	// Adds a prism over a polygon as a polyhedron. points: first those of one end, then those of the other.
	void addPrism(std::span<const vtkIdType> points);

	void fill(vtkUnstructuredGrid* grid) const;
	std::vector<std::int64_t> takeSources() { return std::move(sources_); }

private:
	vtkIdType source_ = 0;
	vtkNew<vtkUnsignedCharArray> types_;
	vtkNew<vtkIdTypeArray> offsets_;
	vtkNew<vtkIdTypeArray> connectivity_;
	vtkNew<vtkIdTypeArray> faces_;
	vtkNew<vtkIdTypeArray> face_locations_;
	vtkIdType face_location_ = -1;
	std::vector<std::int64_t> sources_;
};

} // namespace vp::reader::cells
