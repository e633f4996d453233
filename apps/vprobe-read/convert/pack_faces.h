#pragma once

#include "read/cell_types.h"
#include "read/prisms.h"
#include "vprobe-read/cells/cell_lists.h"

#include <vtkCellArray.h>
#include <vtkUnstructuredGrid.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::reader::convert
{

// The faces of a grid's polyhedra. Prisms over pentagons and hexagons count as polyhedra.
class PackFaces
{
public:
	explicit PackFaces(vtkUnstructuredGrid* grid);

	// VTK's types, of prisms that of polyhedra.
	std::span<const std::uint8_t> types() const { return types_; }
	bool hasPolyhedra() const { return has_polyhedra_; }
	// Calls visit(std::span<const vtkIdType>) with the points of each face of a cell, which has none if it is no
	// polyhedron. Throws a Refusal if its faces are damaged.
	template <class Visit>
	void forEachFace(std::size_t cell, Visit&& visit) const
	{
		if (types_[cell] != read::kPolyhedron)
			return;
		std::vector<vtkIdType> of_prism;
		std::span<const vtkIdType> stream;
		if (const int sides = read::prismSides(own_types_[cell]); sides > 0)
			stream = of_prism = facesOfPrism(cell, static_cast<vtkIdType>(sides));
		else
			stream = cells::polyhedronFaces(grid_, static_cast<vtkIdType>(cell));
		for (std::size_t at = 1; at < stream.size(); at += 1 + static_cast<std::size_t>(stream[at]))
			visit(stream.subspan(at + 1, static_cast<std::size_t>(stream[at])));
	}

private:
	std::vector<vtkIdType> facesOfPrism(std::size_t cell, vtkIdType sides) const;

	vtkUnstructuredGrid* grid_;
	std::span<const std::uint8_t> own_types_;        // as the grid has them
	std::vector<std::uint8_t> types_without_prisms_; // if it has prisms
	std::span<const std::uint8_t> types_;
	bool has_polyhedra_;
};

} // namespace vp::reader::convert
