#include "sliced_sheet.h"
#include "test_grids.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <map>

namespace vp::test
{

namespace
{

// The cut of a face by the plane as segments, in a direction that follows from the face's orientation.
struct FaceCut
{
	std::vector<std::pair<Vec3, Vec3>> segments;
	bool ambiguous = false; // cut more than once: how its crossings pair up is a matter of rule
};

Vec3 crossing(const Vec3& a, const Vec3& b, const Side& side)
{
	const double da = side.distance(a);
	const double db = side.distance(b);
	return a + da / (da - db) * (b - a);
}

FaceCut cutFace(const std::vector<Vec3>& face, const Side& side)
{
	Vec3 enters(0.0); // where the way around the face comes to the positive side
	Vec3 leaves(0.0);
	int crossings = 0;
	for (std::size_t i = 0; i < face.size(); ++i)
	{
		const Vec3& a = face[i];
		const Vec3& b = face[(i + 1) % face.size()];
		if (side.positive(a) == side.positive(b))
			continue;
		(side.positive(b) ? enters : leaves) = crossing(a, b, side);
		++crossings;
	}
	if (crossings > 2)
		return {{}, true};
	if (crossings == 0)
		return {};
	return {{{leaves, enters}}, false};
}

struct CellSection
{
	double area = 0.0;
	bool known = true;
};

// The area of a cell's section as the line integral around it: each face gives its part, so no polygon is put together.
CellSection sectionByFaces(const grid::Block& block, CellId cell, const Side& side)
{
	CellSection section;
	Vec3 sum(0.0);
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          grid::CellFaces faces;
		          grid.cellFaces(cell, faces);
		          const Vec3 about = grid.point(faces.points[0]);
		          for (int f = 0; f < faces.size(); ++f)
		          {
			          std::vector<Vec3> corners;
			          for (const PointId p : faces[f])
				          corners.push_back(grid.point(p));
			          const FaceCut cut = cutFace(corners, side);
			          section.known = section.known && !cut.ambiguous;
			          for (const auto& [from, to] : cut.segments)
				          sum += glm::cross(from - about, to - about);
		          }
	          });
	section.area = 0.5 * std::abs(glm::dot(sum, side.normal()));
	return section;
}

// The area of the convex hull of all edge crossings: right for convex cells with flat faces, whatever their faces are
// listed like.
double sectionByHull(const grid::Block& block, CellId cell, const Side& side)
{
	const Vec3 n = side.normal();
	const Vec3 u = glm::normalize(std::abs(n.x) < 0.6 ? glm::cross(n, Vec3(1, 0, 0)) : glm::cross(n, Vec3(0, 1, 0)));
	const Vec3 v = glm::cross(n, u);
	std::vector<std::pair<double, double>> points;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          grid::CellFaces faces;
		          grid.cellFaces(cell, faces);
		          const Vec3 about = grid.point(faces.points[0]);
		          for (int f = 0; f < faces.size(); ++f)
			          for (std::size_t i = 0; i < faces[f].size(); ++i)
			          {
				          const Vec3 a = grid.point(faces[f][i]);
				          const Vec3 b = grid.point(faces[f][(i + 1) % faces[f].size()]);
				          if (side.positive(a) == side.positive(b))
					          continue;
				          const Vec3 p = crossing(a, b, side) - about;
				          points.emplace_back(glm::dot(p, u), glm::dot(p, v));
			          }
	          });
	std::ranges::sort(points);
	std::vector<std::pair<double, double>> hull;
	const auto turn = [](const auto& a, const auto& b, const auto& c)
	{ return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first); };
	for (int half = 0; half < 2; ++half)
	{
		const std::size_t start = hull.size();
		for (const auto& p : points)
		{
			while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0)
				hull.pop_back();
			hull.push_back(p);
		}
		hull.pop_back();
		std::ranges::reverse(points);
	}
	double area = 0.0;
	for (std::size_t i = 0; i < hull.size(); ++i)
	{
		const auto& [ax, ay] = hull[i];
		const auto& [bx, by] = hull[(i + 1) % hull.size()];
		area += 0.5 * (ax * by - ay * bx);
	}
	return area;
}

bool hasFlatConvexCells(const grid::Block& block)
{
	for (const char* name : {"blob", "graded", "tets", "mixed", "collapsed_hexahedra", "inverted", "hexagonal_prisms",
	                         "two_to_one", "three_on_a_face", "u_shape", "two_pieces"})
		if (block.name == name)
			return true;
	return false;
}

std::vector<TestPlane> planesFor(const grid::Block& block)
{
	std::vector<TestPlane> planes = randomPlanes(block.bounds, tries(200), 20);
	const std::vector<TestPlane> more = degeneratePlanes(block, 21);
	planes.insert(planes.end(), more.begin(), more.end());
	// As long as a sheet's: scaled twice, a normal may differ in its last bit.
	for (TestPlane& plane : planes)
		plane.normal = probe::makeSheet(plane.origin, plane.normal).normal;
	return planes;
}

// Returns the area of all polygons of each cell, signed by the mesh's winding.
std::map<CellId, double> polygonAreas(const mesh::SheetMesh& mesh, const Vec3& normal)
{
	std::map<CellId, double> areas;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		Vec3 sum(0.0);
		for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
			sum += glm::cross(mesh.positions[polygon[i]] - mesh.positions[polygon[0]],
			                  mesh.positions[polygon[i + 1]] - mesh.positions[polygon[0]]);
		areas[mesh.polygon_cells[p].cell] += 0.5 * glm::dot(sum, normal);
	}
	return areas;
}

std::string describe(const grid::Block& block, const TestPlane& plane)
{
	char text[200];
	std::snprintf(text, sizeof(text), "%s, origin %.17g %.17g %.17g, normal %.17g %.17g %.17g", block.name.c_str(),
	              plane.origin.x, plane.origin.y, plane.origin.z, plane.normal.x, plane.normal.y, plane.normal.z);
	return text;
}

} // namespace

TEST(Scan, TraversalFindsEveryCutCell)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const TestPlane& plane : planesFor(block))
			ASSERT_EQ(cut(cutter, plane).cutCells(), scanCutCells(block, plane)) << describe(block, plane);
	}
}

TEST(Scan, TheSideOfTheNormalDoesNotMatter)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const TestPlane& plane : randomPlanes(block.bounds, 20, 22))
			ASSERT_EQ(cut(cutter, plane).cutCells(), cut(cutter, {plane.origin, -3.0 * plane.normal}).cutCells())
			    << describe(block, plane);
	}
}

TEST(Scan, PolygonsHaveTheAreaOfTheCellsSection)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		const double scale = block.bounds.diagonal() * block.bounds.diagonal();
		std::size_t compared = 0;
		std::size_t unknown = 0;
		for (const TestPlane& plane : planesFor(block))
		{
			const Side side(plane);
			const SlicedSheet sheet = cut(cutter, plane);
			std::map<CellId, double> areas = polygonAreas(sheet.mesh, sheet.slice.sheet.normal);
			for (const grid::BoundaryIndex::Face& face : sheet.slice.seeds.faces_in_plane[0])
				areas.erase(face.cell);
			for (const CellId cell : scanCutCells(block, plane))
			{
				const CellSection expected = sectionByFaces(block, cell, side);
				++(expected.known ? compared : unknown);
				if (expected.known)
				{
					ASSERT_NEAR(areas[cell], expected.area, 1e-12 * scale)
					    << "cell " << cell << " of " << describe(block, plane);
				}
				if (hasFlatConvexCells(block))
				{
					ASSERT_NEAR(areas[cell], sectionByHull(block, cell, side), 1e-12 * scale)
					    << "cell " << cell << " of " << describe(block, plane);
				}
				areas.erase(cell);
			}
			ASSERT_TRUE(areas.empty()) << "polygons of cells that are not cut: " << describe(block, plane);
		}
		EXPECT_GT(compared, 20 * unknown) << block.name;
	}
}

// Inner faces are walked along both ways, so what is left is the line integral around the domain's section.
TEST(Scan, TheWholeAreaIsTheLineIntegralAroundIt)
{
	for (const grid::Block& block : allGrids())
	{
		if (block.name == "three_on_a_face" || block.name == "inverted")
			continue; // cells overlap, or their faces are not oriented alike
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		std::size_t compared = 0;
		for (const TestPlane& plane : randomPlanes(block.bounds, 100, 23))
		{
			const Side side(plane);
			Vec3 sum(0.0);
			bool known = true;
			visitGrid(block,
			          [&](const auto& grid)
			          {
				          grid::CellFaces faces;
				          for (CellId c = 0; c < grid.cellCount(); ++c)
				          {
					          grid.cellFaces(c, faces);
					          for (int f = 0; f < faces.size(); ++f)
					          {
						          bool inner = false;
						          grid.forEachNeighbor(c, f, [&](CellId) { inner = true; });
						          if (inner)
							          continue;
						          std::vector<Vec3> corners;
						          for (const PointId p : faces[f])
							          corners.push_back(grid.point(p));
						          const FaceCut cut = cutFace(corners, side);
						          known = known && !cut.ambiguous;
						          for (const auto& [from, to] : cut.segments)
							          sum += glm::cross(from - plane.origin, to - plane.origin);
					          }
				          }
			          });
			if (!known)
				continue;
			++compared;
			const SlicedSheet sheet = cut(cutter, plane);
			double area = 0.0;
			for (const auto& [cell, part] : polygonAreas(sheet.mesh, sheet.slice.sheet.normal))
				area += part;
			ASSERT_NEAR(area, 0.5 * std::abs(glm::dot(sum, side.normal())),
			            1e-12 * block.bounds.diagonal() * block.bounds.diagonal())
			    << describe(block, plane);
		}
		EXPECT_GT(compared, 80u) << block.name;
	}
}

} // namespace vp::test
