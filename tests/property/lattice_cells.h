#pragma once

#include "lattice_sets.h"

namespace vp::test
{

// Lattices and what is made of their cells.

using Ids = std::vector<std::int64_t>;

// Points of a lattice at whole numbers, moved.
RawBlock lattice(Draw& draw, const Disorder& disorder, const LatticeSize& size);

std::int64_t pointAt(const RawBlock& block, int i, int j, int k);
Ids cornersAt(const RawBlock& block, int i, int j, int k); // in VTK's order of a hexahedron
std::vector<Ids> facesOf(const Ids& hexahedron);

template <class Visit>
void forCells(const RawBlock& block, Visit&& visit)
{
	for (int k = 0; k + 1 < int(block.points_along[2]); ++k)
		for (int j = 0; j + 1 < int(block.points_along[1]); ++j)
			for (int i = 0; i + 1 < int(block.points_along[0]); ++i)
				visit(i, j, k);
}

// The lattice as explicit cells: `add(i, j, k, corners)` appends those of one lattice cell.
template <class Add>
void toCells(RawBlock& block, Add&& add)
{
	forCells(block, [&](int i, int j, int k) { add(i, j, k, cornersAt(block, i, j, k)); });
	block.kind = RawKind::cells;
}

void addHexahedron(RawBlock& block, const Ids& corners);
void addWedges(RawBlock& block, const Ids& corners); // two, by the diagonal of the faces normal to k
void addTetrahedra(RawBlock& block,
                   const Ids& corners); // six about the diagonal 0-6, alike in every cell, so that they fit
void addPyramids(RawBlock& block, const Ids& corners);               // six about the center
void addPolyhedron(RawBlock& block, const Ids& corners, Draw& draw); // its faces listed either way round
void addPolyhedron(RawBlock& block, std::vector<Ids> faces);

} // namespace vp::test
