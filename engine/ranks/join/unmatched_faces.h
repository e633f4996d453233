#pragma once

#include "grid/block.h"
#include "grid/face_tolerance.h"
#include "mesh/sheet_mesh.h"
#include "ranks/neighborhood.h"
#include "ranks/team.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vp::ranks
{

/// A face of a cell that has no neighbor there in this rank.
struct UnmatchedFace
{
	mesh::BlockCell cell{};
	std::uint32_t number = 0;    // by which the rank across is to know it; any
	std::vector<Vec3> corners{}; // each place once
	grid::FaceTolerance tolerance{};

	Vec3 center() const;
	Box box() const;
	double apart() const { return std::min(tolerance.greatest(), tolerance.most); }
};

/// Returns nothing if the cell has a neighbor there, or the face fewer than three corners.
std::optional<UnmatchedFace> unmatchedFace(const grid::BlockSet& blocks, const mesh::BlockCell& cell, int face);

/// Returns true if one process has two blocks as parts of one lattice, so that no part of its boundary lies between
/// them. Pieces of unstructured grids do not count: in one process too they meet at seams, since they share no points.
/// whole: per block, the block that one process would have in its place.
bool areOneLattice(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole, std::uint32_t a,
                   std::uint32_t b);

/// A face of another rank.
struct FaceAcross
{
	int rank;
	std::uint32_t number; // as its rank gave it
	std::uint32_t block;

	auto operator<=>(const FaceAcross&) const = default;
};

/// Which faces of several ranks lie on each other.
struct MatchedFaces
{
	std::vector<std::vector<FaceAcross>> across; // for each face, those of other ranks that lie on it; ascending
	bool hang = false; // a face that lies on none is a part of one of another rank, or has such a part; the same at all
};

/// Matches the faces of all ranks, as those of two blocks that meet (grid/interfaces.h). They are brought together at
/// the ranks that their places belong to. boxes: boxesOf() the team. All ranks call this together.
MatchedFaces matchFaces(Team& team, const std::vector<Box>& boxes, std::span<const UnmatchedFace> faces);

} // namespace vp::ranks
