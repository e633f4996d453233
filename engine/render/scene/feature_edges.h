#pragma once

#include "grid/block.h"
#include "render/scene/outline.h"

#include <span>
#include <vector>

namespace vp::render
{

// If the dihedral angle between two boundary faces is larger, their edge is drawn.
constexpr double kFeatureAngle = 30.0; // degrees

// An edge around which more faces of the boundary may lie in other pieces of the block.
struct OpenEdge
{
	Segment segment;
	std::vector<Vec3f> normals; // normals of the known faces
};

// Returns true if an edge of a boundary is drawn, by the normals of the faces around it: it is sharp, or does not
// belong to exactly two of them. Without faces the edge is not on the boundary.
bool isFeature(std::span<const Vec3f> normals);

// Appends the edges of the block's boundary that are features. Faces are matched by sorting their edges, which takes
// n log n time in the size of the boundary.
void addFeatureEdges(const grid::Block& block, std::vector<Segment>& segments);

// The same of a piece of a block. is_inside: per face of its boundary, whether another piece lies there. The edges of
// those go to `open` in place of `segments`.
void addFeatureEdges(const grid::Block& piece, const std::vector<bool>& is_inside, std::vector<Segment>& segments,
                     std::vector<OpenEdge>& open);

// Puts lines into an order that depends on their places alone, and so their ends.
void putInOrder(std::vector<Segment>& segments);

} // namespace vp::render
