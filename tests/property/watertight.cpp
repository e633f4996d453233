#include "pair_checks.h"

#include "slice/union_find.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

namespace vp::test
{

namespace
{

// Whether two vertices lie on one face without a neighbour. Where faces lie on each other, as at the wrap of a ring, a
// vertex bears the name of either side: their corners count as one.
class BoundaryFaces
{
public:
	explicit BoundaryFaces(const grid::BlockSet& set) : set_(set), same_(countPoints())
	{
		for (std::uint32_t b = 0; b < set.blocks.size(); ++b)
			if (const grid::BlockSeams* seams = set.interfaces.of(b))
				for (const grid::SeamLink& link : seams->all())
					joinCorners({b, link.cell, link.face}, {link.block, link.other, link.other_face});
		std::size_t count = 0;
		for (std::uint32_t b = 0; b < set.blocks.size(); ++b)
			for (const grid::BoundaryIndex::Face& face : set.blocks[b].boundary.faces)
			{
				for (const PointId p : pointsOf({b, face.cell, face.face}))
					faces_of_[number(b, p)].insert(count);
				++count;
			}
	}
	bool holdBoth(const slice::EdgePoint& v, const slice::EdgePoint& w) const
	{
		const auto& faces = facesOf(v.block, v.lower);
		return std::ranges::any_of(faces,
		                           [&](std::size_t f)
		                           {
			                           return facesOf(v.block, v.higher).contains(f) &&
			                                  facesOf(w.block, w.lower).contains(f) &&
			                                  facesOf(w.block, w.higher).contains(f);
		                           });
	}

private:
	struct Face
	{
		std::uint32_t block;
		CellId cell;
		std::uint32_t face;
	};

	// Fills starts_, the number of each block's first point.
	std::size_t countPoints()
	{
		std::size_t points = 0;
		for (const grid::Block& block : set_.blocks)
		{
			starts_.push_back(static_cast<std::uint32_t>(points));
			points += visitGrid(block, [](const auto& grid) { return grid.pointCount(); });
		}
		return points;
	}
	std::uint32_t number(std::uint32_t block, PointId point) const { return same_.root(starts_[block] + point); }
	std::vector<PointId> pointsOf(const Face& face) const
	{
		return visitGrid(set_.blocks[face.block],
		                 [&](const auto& grid)
		                 {
			                 grid::CellFaces faces;
			                 grid.cellFaces(face.cell, faces);
			                 const auto points = faces[static_cast<int>(face.face)];
			                 return std::vector<PointId>(points.begin(), points.end());
		                 });
	}
	Vec3 place(std::uint32_t block, PointId point) const
	{
		return visitGrid(set_.blocks[block], [&](const auto& grid) { return grid.point(point); });
	}
	void joinCorners(const Face& face, const Face& other)
	{
		const std::vector<PointId> corners = pointsOf(other);
		for (const PointId p : pointsOf(face))
			same_.join(starts_[face.block] + p,
			           starts_[other.block] +
			               *std::ranges::min_element(
			                   corners, {},
			                   [&](PointId q) { return glm::length(place(face.block, p) - place(other.block, q)); }));
	}
	const std::set<std::size_t>& facesOf(std::uint32_t block, PointId point) const
	{
		static const std::set<std::size_t> none;
		const auto at = faces_of_.find(number(block, point));
		return at == faces_of_.end() ? none : at->second;
	}

	const grid::BlockSet& set_;
	std::vector<std::uint32_t> starts_;
	mutable slice::UnionFind same_; // root() shortens paths
	std::map<std::uint32_t, std::set<std::size_t>> faces_of_;
};

// The polygons on an edge, and which way each runs along it.
struct EdgeUse
{
	std::size_t polygon;
	bool forward;
};

using EdgeUses = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<EdgeUse>>;

EdgeUses usesOf(const slice::SheetMesh& mesh)
{
	EdgeUses uses;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		for (std::size_t i = 0; i < polygon.size(); ++i)
		{
			const std::uint32_t v = polygon[i];
			const std::uint32_t w = polygon[(i + 1) % polygon.size()];
			uses[std::minmax(v, w)].push_back({p, v < w});
		}
	}
	return uses;
}

// Polygons turned one against the other as their common edges ask: a union-find whose links know whether they turn.
class Sides
{
public:
	explicit Sides(std::size_t polygons) : parent_(polygons), turned_(polygons, false)
	{
		std::iota(parent_.begin(), parent_.end(), std::size_t(0));
	}
	// False where what is known already says otherwise.
	bool relate(std::size_t a, std::size_t b, bool turned)
	{
		const bool a_turned = toRoot(a);
		const bool b_turned = toRoot(b);
		if (a == b)
			return (a_turned != b_turned) == turned;
		parent_[a] = b;
		turned_[a] = (a_turned != b_turned) != turned;
		return true;
	}

private:
	bool toRoot(std::size_t& polygon) const
	{
		bool turned = false;
		while (parent_[polygon] != polygon)
		{
			turned = turned != turned_[polygon];
			polygon = parent_[polygon];
		}
		return turned;
	}
	std::vector<std::size_t> parent_;
	std::vector<bool> turned_;
};

} // namespace

void checkWatertight(const Pair& pair)
{
	// Where a plane runs through points, polygons without area are left out, and their neighbours meet along a line
	// that has other vertices on either side. Cells drawn together have several faces on the same edges.
	if (!pair.raw.conforming || !pair.generic)
		return;
	const slice::SheetMesh& mesh = pair.sheet.mesh;
	const BoundaryFaces boundary(pair.set);
	Sides sides(mesh.polygons());
	for (const auto& [edge, uses] : usesOf(mesh))
	{
		const bool rim = boundary.holdBoth(mesh.edges[edge.first], mesh.edges[edge.second]);
		EXPECT_TRUE(uses.size() == 2 || (rim && uses.size() == 1) || (pair.raw.collapsed && uses.size() % 2 == 0))
		    << "edge used " << uses.size() << " times" << (rim ? ", on the rim" : "");
		if (uses.size() != 2)
			continue;
		// Polygons face the sheet's normal. One of a folded cell, or of a concave one at a warped face, faces the other
		// way by its cell: against its neighbours, all of them alike.
		const bool alike = uses[0].forward == uses[1].forward;
		EXPECT_FALSE(alike && pair.raw.flat_faces) << "polygons that run the same way along an edge";
		EXPECT_TRUE(sides.relate(uses[0].polygon, uses[1].polygon, alike)) << "polygons do not agree on their sides";
	}
}

} // namespace vp::test
