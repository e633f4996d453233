#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "ranks/team.h"

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vp::ranks
{

/// A face by its corners, in whatever order.
struct FaceKey
{
	std::uint64_t sum = 0;
	std::uint64_t mixed = 0;
	std::uint64_t corners = 0;

	auto operator<=>(const FaceKey&) const = default;
};

void addCorner(const Vec3& corner, FaceKey& key);

/// A component of a point array at a vertex, and the magnitude of the numbers that it was interpolated from. The
/// magnitude is 0 for names of categories.
struct ValueAt
{
	double value;
	double scale;

	bool isSame(const ValueAt& other) const;
};

/// A vertex on the rim of a rank's mesh, with what tells whether it is one with a vertex of another rank.
struct RimVertex
{
	static constexpr std::uint32_t kNone = ~std::uint32_t(0);

	int rank = 0;
	/// kNone: the mesh has no vertex there. A cell that the sheet meets in this grid point alone, or in an edge, joins
	/// vertices of other ranks whose cells lie on different faces of it.
	std::uint32_t vertex = 0;
	Vec3 place{};
	double near = 0.0; // largest distance between two places that are meant to be one
	std::uint32_t component = 0;
	std::uint32_t whole = 0; // the block that one process would have
	bool of_lattice = false; // the block is a lattice, whose pieces share points
	bool of_pack = false;    // the block is a share of a pack; these share points, too
	// If so, the ends of its edge as the pack numbers them. One process has one vertex of an edge. Others at a grid
	// point are joined by faces alone.
	std::array<PointId, 2> points{};
	bool on_edge = true;          // the vertex lies on a cell's edge; else on the rim of a window
	std::array<Vec3, 2> ends{};   // ends of its edge; the grid point if it lies on one
	double edge_length = 0.0;     // its edge is that long, also if it lies on a grid point
	std::vector<FaceKey> faces{}; // faces of cells on which it lies; ascending
	std::vector<std::pair<std::string, std::vector<ValueAt>>> arrays{}; // by name

	bool isInMesh() const { return vertex != kNone; }
	bool isAcross(const RimVertex& other) const;      // true if a seam lies between the two
	bool isOnSameEdge(const RimVertex& other) const;  // but for rounding
	bool hasSamePoints(const RimVertex& other) const; // within one lattice or one pack
	bool hasDataOf(const RimVertex& other) const;
	/// Returns true if a join changes neither the place nor a value, as in one process (mesh/join_vertices.h).
	bool isOneWith(const RimVertex& other) const;
};

/// A vertex on an edge of the grid, without its place, its faces and its number. whole: per block, the block that one
/// process would have in its place.
RimVertex vertexOn(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole, const mesh::EdgePoint& at);

/// A vertex that is a grid point, as one of whole cells.
RimVertex gridVertex(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole, const mesh::SheetMesh& mesh,
                     std::uint32_t vertex);

void put(MessageWriter& to, const RimVertex& vertex);
RimVertex takeVertex(MessageReader& from, int rank);

} // namespace vp::ranks
