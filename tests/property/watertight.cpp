#include "pair_checks.h"

#include "mesh/bridges.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

namespace vp::test
{

namespace
{

using PointName = std::pair<std::size_t, PointId>; // block and point

// The points that are one place across seams, by one of their names.
class JoinedPoints
{
public:
	explicit JoinedPoints(const grid::BlockSet& set)
	{
		for (std::size_t b = 0; b < set.blocks.size(); ++b)
			if (const grid::BlockSeams* seams = set.interfaces.of(b))
				for (const grid::SeamLink& link : seams->all())
					join(cornersOf(set, b, link.cell, link.face),
					     cornersOf(set, link.block, link.other, link.other_face));
	}
	PointName nameOf(PointName point) const
	{
		for (auto at = other_.find(point); at != other_.end(); at = other_.find(point))
			point = at->second;
		return point;
	}

private:
	using Corners = std::vector<std::pair<PointName, Vec3>>;

	static Corners cornersOf(const grid::BlockSet& set, std::size_t block, CellId cell, std::uint32_t face)
	{
		return visitGrid(set.blocks[block],
		                 [&](const auto& grid)
		                 {
			                 grid::CellFaces faces;
			                 grid.cellFaces(cell, faces);
			                 Corners corners;
			                 for (const PointId p : faces[static_cast<int>(face)])
				                 corners.push_back({{block, p}, grid.point(p)});
			                 return corners;
		                 });
	}
	void join(const Corners& here, const Corners& there)
	{
		for (const auto& [name, place] : here)
		{
			const auto distance = [&, at = place](const auto& other) { return glm::length(other.second - at); };
			const PointName a = nameOf(name);
			const PointName b = nameOf(std::ranges::min_element(there, {}, distance)->first);
			if (a != b)
				other_[std::max(a, b)] = std::min(a, b);
		}
	}

	std::map<PointName, PointName> other_; // to a lesser name
};

// Finds out whether two vertices lie on one face of the domain's boundary: without a neighbor, and on no seam.
class BoundaryFaces
{
public:
	explicit BoundaryFaces(const grid::BlockSet& set) : points_(set)
	{
		for (std::size_t b = 0; b < set.blocks.size(); ++b)
			visitGrid(set.blocks[b], [&](const auto& grid) { addFaces(set, b, grid); });
	}
	bool holdBoth(const mesh::EdgePoint& v, const mesh::EdgePoint& w) const
	{
		const auto facesOf = [&](std::uint32_t block, PointId p) -> const std::set<std::size_t>&
		{
			static const std::set<std::size_t> none;
			const auto at = faces_of_.find(points_.nameOf({block, p}));
			return at == faces_of_.end() ? none : at->second;
		};
		return std::ranges::any_of(facesOf(v.block, v.lower),
		                           [&](std::size_t f)
		                           {
			                           return facesOf(v.block, v.higher).contains(f) &&
			                                  facesOf(w.block, w.lower).contains(f) &&
			                                  facesOf(w.block, w.higher).contains(f);
		                           });
	}

private:
	template <class G>
	void addFaces(const grid::BlockSet& set, std::size_t block, const G& grid)
	{
		const grid::BlockSeams* seams = set.interfaces.of(block);
		grid::CellFaces faces;
		for (const grid::BoundaryIndex::Face& face : set.blocks[block].boundary.faces)
		{
			if (seams && !seams->of(face.cell, face.face).empty())
				continue;
			grid.cellFaces(face.cell, faces);
			for (const PointId p : faces[static_cast<int>(face.face)])
				faces_of_[points_.nameOf({block, p})].insert(count_);
			++count_;
		}
	}

	JoinedPoints points_;
	std::map<PointName, std::set<std::size_t>> faces_of_;
	std::size_t count_ = 0;
};

// The polygons on an edge, and which way each runs along it.
struct EdgeUse
{
	std::size_t polygon;
	bool forward;
};

using EdgeUses = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<EdgeUse>>;

EdgeUses usesOf(const mesh::SheetMesh& mesh)
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
	// Where a plane runs through points, polygons without area are left out, and their neighbors meet along a line
	// that has other vertices on either side. Cells drawn together have several faces on the same edges.
	if (!pair.raw.conforming || !pair.generic)
		return;
	const mesh::SheetMesh& mesh = pair.sheet.mesh;
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
		// way by its cell: against its neighbors, all of them alike.
		const bool alike = uses[0].forward == uses[1].forward;
		EXPECT_FALSE(alike && pair.raw.flat_faces) << "polygons that run the same way along an edge";
		// A loop of a folded cell within another one of it is taken for a hole, whatever way it runs by its cell.
		const auto hasHole = [&](const auto& use) { return !mesh::bridgesOf(mesh.polygon(use.polygon)).empty(); };
		if (!pair.raw.flat_faces && (hasHole(uses[0]) || hasHole(uses[1])))
			continue;
		EXPECT_TRUE(sides.relate(uses[0].polygon, uses[1].polygon, alike)) << "polygons do not agree on their sides";
	}
}

} // namespace vp::test
