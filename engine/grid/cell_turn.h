#pragma once

#include "grid/grid.h"

#include <array>
#include <cstdint>
#include <span>

namespace vp::grid
{

// Which way a cell is turned throughout: positive where its faces run counter-clockwise seen from outside.
enum class Turn : std::int8_t
{
	negative = -1,
	mixed = 0, // both ways, flat, or not certain
	positive = 1
};

// A corner whose three edges make a volume: the point, then its neighbors counter-clockwise seen from inside the cell,
// by the numbering of a cell that is not inverted.
struct CornerFrame
{
	std::array<std::uint8_t, 4> corner;
};

// Of a table shape; a pyramid's tip, where four edges meet, has none.
std::span<const CornerFrame> cornerFrames(CellShape shape);

// The sign of the Jacobian of the map that fills a cell of a table shape: linear on triangles, bilinear on quads, so
// that neighbors agree on their face. Exact for tetrahedra and pyramids, whose Jacobian is least at a corner. For
// wedges and hexahedra the corners are not enough (a brick 2 x 1 at the bottom and 1 x 2 at the top, turned by 180
// degrees, has eight good corners and an inverted middle): there it is the signs of the Jacobian's Bernstein
// coefficients, between which it lies. Corners at edges without length count for nothing.
Turn turnOf(CellShape shape, std::span<const Vec3> points);

// Whether det(u, v, w) has one sign for all u, v and w within these boxes: that of the map's Jacobian in every
// hexahedron whose edges along u, v and w are among them.
Turn turnOfEdges(const Box& u, const Box& v, const Box& w);

// Whether each edge is run through once in either direction: only then do a polyhedron's faces say what is inside.
// Files often list faces either way round.
bool orientedAlike(const CellFaces& faces);

} // namespace vp::grid
