#include "pair_checks.h"

#include "mesh/bridges.h"
#include "mesh/mesh_values.h"
#include "same_mesh.h"
#include "seed/cut_cells.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace vp::test
{

namespace
{

constexpr double kUlp = 2.3e-16;

std::pair<Vec3, Vec3> endsOf(const grid::BlockSet& set, const mesh::EdgePoint& edge)
{
	return visitGrid(set.blocks[edge.block],
	                 [&](const auto& grid) { return std::pair(grid.point(edge.lower), grid.point(edge.higher)); });
}

double largest(const Vec3& p)
{
	return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

std::vector<CellId> cellsOfTree(const grid::Block& block, const TestPlane& test_plane)
{
	const surface::Plane plane(test_plane.origin, test_plane.normal);
	std::vector<CellId> cells;
	visitGrid(block, [&](const auto& grid)
	          { seed::visitCutCells(grid, grid::treeOf(block), plane, [&](CellId cell) { cells.push_back(cell); }); });
	return sorted(std::move(cells));
}

double areaOf(const mesh::SheetMesh& mesh, std::size_t polygon, const Vec3& normal)
{
	const auto corners = mesh.polygon(polygon);
	Vec3 sum(0.0);
	for (std::size_t i = 1; i + 1 < corners.size(); ++i)
		sum += glm::cross(mesh.positions[corners[i]] - mesh.positions[corners[0]],
		                  mesh.positions[corners[i + 1]] - mesh.positions[corners[0]]);
	return 0.5 * glm::dot(sum, normal);
}

} // namespace

double roundingOf(const grid::BlockSet& set, const TestPlane& plane)
{
	const Box box = set.bounds();
	return 16.0 * kUlp * (largest(box.lo) + largest(box.hi) + largest(plane.origin));
}

bool isGeneric(const grid::BlockSet& set, const TestPlane& plane)
{
	const Side side(plane);
	const double rounding = roundingOf(set, plane);
	for (const grid::Block& block : set.blocks)
	{
		const bool clear = visitGrid(block,
		                             [&](const auto& grid)
		                             {
			                             for (PointId p = 0; p < grid.pointCount(); ++p)
				                             if (std::abs(side.distance(grid.point(p))) <= rounding)
					                             return false;
			                             return true;
		                             });
		if (!clear)
			return false;
	}
	return true;
}

double areaOf(const SlicedSheet& sheet)
{
	double area = 0.0;
	for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
		area += areaOf(sheet.mesh, p, sheet.slice.sheet.normal);
	return area;
}

void checkCells(const Pair& pair)
{
	for (std::size_t b = 0; b < pair.set.blocks.size(); ++b)
	{
		const std::vector<CellId> scanned = scanCutCells(pair.set.blocks[b], pair.plane);
		EXPECT_EQ(pair.sheet.cutCells(b), scanned) << "block " << b;
		EXPECT_EQ(cellsOfTree(pair.set.blocks[b], pair.plane), scanned) << "tree of block " << b;
	}
}

void checkVertices(const Pair& pair)
{
	const mesh::SheetMesh& mesh = pair.sheet.mesh;
	const Side side(pair.plane);
	const double rounding = roundingOf(pair.set, pair.plane);
	const grid::FieldChoice linear{"linear", grid::Association::point, 0};
	for (std::size_t v = 0; v < mesh.positions.size(); ++v)
	{
		const Vec3& p = mesh.positions[v];
		const auto [a, b] = endsOf(pair.set, mesh.edges[v]);
		const double t = mesh.edges[v].t;
		ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
		EXPECT_TRUE(t >= 0.0 && t <= 1.0);
		EXPECT_LE(largest(p - (a + t * (b - a))), rounding);
		EXPECT_LE(std::abs(side.distance(p)), rounding);
		const grid::Block& block = pair.set.blocks[mesh.edges[v].block];
		const double value = mesh::interpolate(block, *linear.in(block), 0, mesh.edges[v]);
		EXPECT_NEAR(value, linearAt(p), 8.0 * rounding + 16.0 * kUlp);
	}
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		ASSERT_GE(mesh.polygon(p).size(), 3u);
		EXPECT_GT(areaOf(mesh, p, pair.sheet.slice.sheet.normal), 0.0);
		const std::set<std::uint32_t> distinct(mesh.polygon(p).begin(), mesh.polygon(p).end());
		EXPECT_TRUE(!pair.generic || distinct.size() == mesh.polygon(p).size() ||
		            !mesh::bridgesOf(mesh.polygon(p)).empty())
		    << "a polygon meets itself at a vertex";
	}
}

namespace
{

using Real = long double;
using Vec = glm::vec<3, Real>;

// Cuts single cells anew: signs as ever, all else in long double, loops put together by their edges' names.
class SectionCutter
{
public:
	SectionCutter(const grid::Block& block, const TestPlane& plane) : block_(block), side_(plane), origin_(plane.origin)
	{
	}

	struct Section
	{
		Real area = 0.0L; // area of the loops, less those that are holes in others
		Real slack = 0.0L;
		bool closed = true;
	};

	Section cut(CellId cell)
	{
		arcs_.clear();
		slack_ = 0.0L;
		visitGrid(block_,
		          [&](const auto& grid)
		          {
			          grid::CellFaces faces;
			          grid.cellFaces(cell, faces);
			          for (int f = 0; f < faces.size(); ++f)
				          cutFace(grid, faces[f]);
		          });
		return addLoops();
	}

private:
	using Edge = std::pair<PointId, PointId>;
	struct Crossing
	{
		Edge edge;
		Vec at;
		bool leaves;
	};

	template <class G>
	Crossing crossing(const G& grid, PointId from, PointId to, bool leaves)
	{
		const Vec n(side_.normal());
		const Vec a = Vec(grid.point(from)) - Vec(origin_);
		const Vec b = Vec(grid.point(to)) - Vec(origin_);
		const Real da = glm::dot(n, a);
		const Real db = glm::dot(n, b);
		// Within rounding of the plane any place of the edge may be meant.
		const Real t = da == db ? 0.5L : std::clamp(da / (da - db), 0.0L, 1.0L);
		const Real length = glm::length(b - a);
		const Real size = glm::length(a) + glm::length(b);
		const Real shallow =
		    std::abs(da - db) > 0.0L ? std::min<Real>(length, 8.0L * kUlp * size * length / std::abs(da - db)) : length;
		slack_ = std::max(slack_, shallow + 8.0L * kUlp * (size + glm::length(Vec(origin_))));
		return {std::minmax(from, to), a + t * (b - a), leaves};
	}

	template <class G>
	void cutFace(const G& grid, std::span<const PointId> face)
	{
		std::vector<Crossing> crossings;
		for (std::size_t i = 0; i < face.size(); ++i)
		{
			const PointId a = face[i];
			const PointId b = face[(i + 1) % face.size()];
			const bool positive = side_.positive(grid.point(a));
			if (positive != side_.positive(grid.point(b)))
				crossings.push_back(crossing(grid, a, b, positive));
		}
		if (crossings.empty())
			return;
		if (crossings.size() > 2 && isFlatAndHidden(grid, face))
			return pairInOrder(std::move(crossings), grid, face);
		std::vector<PointId> ids(face.begin(), face.end());
		std::ranges::sort(ids);
		double sum = 0.0; // the rule for faces cut more than once
		for (const PointId p : ids)
			sum += side_.distance(grid.point(p));
		const bool joined = crossings.size() > 2 && sum >= 0.0;
		for (std::size_t i = 0; i < crossings.size(); ++i)
			if (crossings[i].leaves)
			{
				const std::size_t other = (i + (joined ? 1 : crossings.size() - 1)) % crossings.size();
				if (crossings[i].edge != crossings[other].edge)
					arcs_.push_back({crossings[i], crossings[other]});
			}
	}

	template <class G>
	static Vec normalOf(const G& grid, std::span<const PointId> face, const Vec& mean)
	{
		Vec normal(0.0L);
		for (std::size_t i = 0; i < face.size(); ++i)
			normal += glm::cross(Vec(grid.point(face[i])) - mean, Vec(grid.point(face[(i + 1) % face.size()])) - mean);
		return normal;
	}

	// Whether a corner of the face is hidden from the mean of its points, which lie in a plane, or nearly so.
	template <class G>
	static bool isFlatAndHidden(const G& grid, std::span<const PointId> face)
	{
		Vec mean(0.0L);
		for (const PointId p : face)
			mean += Vec(grid.point(p)) / static_cast<Real>(face.size());
		const Vec normal = normalOf(grid, face, mean);
		bool hidden = false;
		Real off = 0.0L;
		Real size = 0.0L;
		for (std::size_t i = 0; i < face.size(); ++i)
		{
			const Vec a = Vec(grid.point(face[i])) - mean;
			const Vec b = Vec(grid.point(face[(i + 1) % face.size()])) - mean;
			hidden = hidden || glm::dot(glm::cross(a, b), normal) < 0.0L;
			off = std::max(off, std::abs(glm::dot(a, normal)) / glm::length(normal));
			size = std::max(size, glm::length(a));
		}
		return hidden && off <= 0.1L * size;
	}

	// Along the line in which the plane cuts the face, what leaves goes with what comes back next.
	template <class G>
	void pairInOrder(std::vector<Crossing> crossings, const G& grid, std::span<const PointId> face)
	{
		const Vec along = glm::cross(normalOf(grid, face, Vec(grid.point(face[0]))), Vec(side_.normal()));
		std::ranges::sort(crossings, {}, [&](const Crossing& c) { return glm::dot(c.at, along); });
		std::vector<Crossing> open;
		for (const Crossing& crossing : crossings)
			if (open.empty() || open.back().leaves == crossing.leaves)
				open.push_back(crossing);
			else
			{
				if (open.back().edge != crossing.edge)
					arcs_.push_back({open.back(), crossing});
				open.pop_back();
			}
	}

	// Seen along the normal, by the angles between the corners.
	bool isWithin(const Vec& p, const std::vector<Vec>& corners) const
	{
		const Vec normal(side_.normal());
		Real angle = 0.0L;
		for (std::size_t i = 0; i < corners.size(); ++i)
		{
			const Vec a = corners[i] - p;
			const Vec b = corners[(i + 1) % corners.size()] - p;
			angle += std::atan2(glm::dot(glm::cross(a, b), normal), glm::dot(a, b));
		}
		return std::abs(angle) > 3.0L;
	}

	// Cells whose edges have two arcs each: all but those folded on themselves by repeated points.
	Section addLoops()
	{
		Section section;
		std::map<Edge, std::vector<std::size_t>> at;
		for (std::size_t i = 0; i < arcs_.size(); ++i)
			for (const Crossing& end : arcs_[i])
				at[end.edge].push_back(i);
		section.closed = std::ranges::all_of(at, [](const auto& edge) { return edge.second.size() == 2; });
		std::vector<bool> done(arcs_.size(), false);
		Real perimeter = 0.0L;
		std::vector<std::pair<std::vector<Vec>, Real>> loops; // corners, and the middles between them; areas
		for (std::size_t start = 0; start < arcs_.size() && section.closed; ++start)
		{
			Vec sum(0.0L);
			std::vector<Vec> corners;
			const Vec about = arcs_[start][0].at;
			std::size_t arc = start;
			Edge edge = arcs_[start][0].edge;
			while (!done[arc])
			{
				done[arc] = true;
				const bool forward = arcs_[arc][0].edge == edge;
				const Crossing& from = arcs_[arc][forward ? 0 : 1];
				const Crossing& to = arcs_[arc][forward ? 1 : 0];
				sum += glm::cross(from.at - about, to.at - about);
				corners.insert(corners.end(), {from.at, (from.at + to.at) / 2.0L});
				perimeter += glm::length(to.at - from.at);
				edge = to.edge;
				arc = at[edge][0] == arc ? at[edge][1] : at[edge][0];
			}
			if (!corners.empty())
				loops.emplace_back(std::move(corners), 0.5L * std::abs(glm::dot(sum, Vec(side_.normal()))));
		}
		for (const auto& [corners, area] : loops)
		{
			const auto isAround = [&, &corners = corners](const auto& other)
			{
				return &other.first != &corners &&
				       std::ranges::all_of(corners, [&](const Vec& p) { return isWithin(p, other.first); });
			};
			section.area += std::ranges::count_if(loops, isAround) % 2 == 0 ? area : -area;
		}
		// Every vertex moved by the slack.
		section.slack = slack_ * (perimeter + slack_ * static_cast<Real>(arcs_.size()));
		return section;
	}

	const grid::Block& block_;
	Side side_;
	Vec3 origin_;
	std::vector<std::array<Crossing, 2>> arcs_;
	Real slack_ = 0.0L; // how far rounding moves a vertex
};

} // namespace

void checkAreas(const Pair& pair)
{
	const mesh::SheetMesh& mesh = pair.sheet.mesh;
	std::map<std::pair<std::uint32_t, CellId>, double> areas;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		areas[{mesh.polygon_cells[p].block, mesh.polygon_cells[p].cell}] +=
		    areaOf(mesh, p, pair.sheet.slice.sheet.normal);
	for (std::uint32_t b = 0; b < pair.set.blocks.size(); ++b)
	{
		for (const grid::BoundaryIndex::Face& face : pair.sheet.slice.seeds.faces_in_plane[b])
			areas.erase({b, face.cell});
		SectionCutter cutter(pair.set.blocks[b], pair.plane);
		for (const CellId cell : scanCutCells(pair.set.blocks[b], pair.plane))
		{
			const SectionCutter::Section section = cutter.cut(cell);
			const auto found = areas.find({b, cell});
			const double area = found == areas.end() ? 0.0 : found->second;
			if (section.closed)
			{
				EXPECT_NEAR(area, double(section.area), double(section.slack) + 1e-12 * area)
				    << "cell " << cell << " of block " << b;
			}
			if (found != areas.end())
				areas.erase(found);
		}
	}
	EXPECT_TRUE(areas.empty()) << "polygons of cells that are not cut";
}

void checkFinders(const Pair& pair, cut::Cutter& cutter, const std::optional<probe::Window>& window)
{
	const SlicedSheet expected = window ? cut(cutter, pair.asked, {}, Search::generations, window) : pair.sheet;
	const SlicedSheet found = cut(cutter, pair.asked, {}, Search::fastest, window);
	for (std::size_t b = 0; b < pair.set.blocks.size(); ++b)
		EXPECT_EQ(found.slice.cuts[b].cutCells(), expected.slice.cuts[b].cutCells()) << "block " << b;
	const SlicedSheet spread = cut(cutter, pair.asked, {.lattice = true}, Search::generations, window);
	for (std::size_t b = 0; b < pair.set.blocks.size(); ++b)
		EXPECT_EQ(spread.cutCells(b), expected.cutCells(b)) << "hot spots, block " << b;
	if (pair.set.interfaces.seam_faces == 0)
		return expectSameMesh(found.mesh, expected.mesh);
	// If several vertices are at one place, up to rounding, the first one stays.
	const double size = pair.set.bounds().diagonal();
	EXPECT_NEAR(areaOf(found), areaOf(expected), roundingOf(pair.set, pair.plane) * size * 16.0);
}

} // namespace vp::test
