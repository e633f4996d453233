#pragma once

#include "grid/grid.h"

#include <array>
#include <cstdint>
#include <span>

namespace vp::grid
{

// The orientation of a cell. Positive: all its faces run counter-clockwise seen from outside.
enum class Turn : std::int8_t
{
	negative = -1,
	mixed = 0, // both orientations occur, or the cell is flat, or it is not certain
	positive = 1
};

// A corner where three edges meet: the point, then its neighbors, counter-clockwise seen from inside a cell that is not
// inverted.
struct CornerFrame
{
	std::array<std::uint8_t, 4> corner;
};

// Returns the corners of a table shape. The tip of a pyramid is left out, since four edges meet there.
std::span<const CornerFrame> cornerFrames(CellShape shape);

// Returns the sign of the Jacobian of the map that fills a cell of a table shape. The map is linear on triangles and
// bilinear on quads, so neighbors agree on their face. The result is exact for tetrahedra and pyramids, where the
// Jacobian is least at a corner. For wedges and hexahedra the corners are not enough: a brick 2 x 1 at the bottom and
// 1 x 2 at the top, turned by 180 degrees, has eight good corners and an inverted middle. For these the signs of the
// Bernstein coefficients of the Jacobian are used, which bound it. Corners at edges without length are ignored.
Turn turnOf(CellShape shape, std::span<const Vec3> points);

// Returns the sign of det(u, v, w) if it is the same for all u, v and w in these boxes. The Jacobian then has this sign
// in every hexahedron whose edges along u, v and w lie in the boxes.
Turn turnOfEdges(const Box& u, const Box& v, const Box& w);

// Returns true if the faces of a polyhedron pass each edge once in each direction. Only then do they say where its
// inside is. Files often list faces in any direction.
bool orientedAlike(const CellFaces& faces);

} // namespace vp::grid
