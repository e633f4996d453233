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

// The cells of a grid in the making, one after the other; each knows the file's cell it is part of.
class GrownCells
{
public:
	GrownCells();
	~GrownCells();

	void startSource(vtkIdType cell) { source_ = cell; }
	void addPoint(vtkIdType point);
	// Of a polyhedron: faces, then per face its size and points.
	void addFaces(std::span<const vtkIdType> stream);
	// Ends a cell that has the points, and faces, added since the last.
	void endCell(std::uint8_t type);

	// A prism over a polygon as a polyhedron: first the points of the one end, then of the other.
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
