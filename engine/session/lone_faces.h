#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "session/neighborhood.h"
#include "session/team.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vp::session
{

/// A face of a cell that has no neighbor there in this rank.
struct LoneFace
{
	mesh::BlockCell cell{};
	std::vector<Vec3> corners{}; // each place once
	double tolerance = 0.0;      // of a corner
	double most = 0.0;           // which no tolerance may pass

	Vec3 center() const;
	double apart() const { return std::min(tolerance, most); }
	/// As faces of two blocks that meet (grid/interfaces.h).
	bool liesOn(const LoneFace& other) const;
};

/// Returns nothing if the cell has a neighbor there, or the face fewer than three corners.
std::optional<LoneFace> loneFace(const grid::BlockSet& blocks, const mesh::BlockCell& cell, int face);

/// A face of another rank, by its number among those that this rank has given.
struct FaceAcross
{
	int rank;
	std::uint32_t number;

	auto operator<=>(const FaceAcross&) const = default;
};

/// Returns for each face those of other ranks that lie on it. Faces are brought together at the ranks that their places
/// belong to. All ranks call this together.
std::vector<std::vector<FaceAcross>> facesAcross(Team& team, const std::vector<Box>& boxes,
                                                 std::span<const LoneFace> faces);

/// Whether a face that lies on none of another rank meets some of another size there. All ranks get the same answer.
bool facesHang(Team& team, const std::vector<Box>& boxes, std::span<const LoneFace> faces,
               std::span<const std::vector<FaceAcross>> across);

/// The boxes of other ranks.
class BoxesOfOthers
{
public:
	BoxesOfOthers(const Team& team, const std::vector<Box>& boxes);

	bool meet(const Box& box) const;

private:
	std::vector<Box> boxes_;
};

} // namespace vp::session
