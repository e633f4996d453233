// Borders between ranks where vertices are hard to tell from each other. What is joined is what one process joins.
#include "one_sheet.h"
#include "ranks/join/boundary_edges.h"
#include "ranks/join/polygons_around.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vp::test
{

namespace
{

// Askew, and through points of the lattice.
const TestPlane kCuts[] = {{{1.0, 0.4, 0.3}, {0.3, 0.2, 1.0}}, {{1.0, 0.5, 0.25}, {0.0, 0.0, 1.0}}};

void expectJoinedAsByOne(const std::vector<grid::Block>& blocks, const cut::CutRequest& request,
                         const std::string& where)
{
	Figures expected;
	withOneAndWithMany(
	    blocks,
	    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	    {
		    expected = figuresOf(ranks, own, OneSheet(ranks, own, request));
		    EXPECT_GT(expected.polygons, 4u) << where;
	    },
	    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	    { expectSame(figuresOf(ranks, own, OneSheet(ranks, own, request)), expected, where); });
}

void expectJoinedAsByOne(const std::vector<grid::Block>& blocks, const std::string& where)
{
	for (const TestPlane& plane : kCuts)
		expectJoinedAsByOne(blocks, requestFor(plane), where);
}

// Adds hexahedra between u0 and u0 + 1 whose points are moved; v0: the same along v. The points are the column's own.
void addColumn(CellListMaker& maker, double u0, double v0, const auto& move)
{
	constexpr double step = 1.0 / kSteps;
	constexpr int n = kSteps + 1;
	std::vector<std::int64_t> ids;
	for (int k = 0; k < n; ++k)
		for (int j = 0; j < n; ++j)
			for (int i = 0; i < n; ++i)
				ids.push_back(maker.point(move(Vec3(u0 + step * i, v0 + step * j, step * k))));
	const auto id = [&](int i, int j, int k) { return ids[static_cast<std::size_t>((k * n + j) * n + i)]; };
	for (int k = 0; k < kSteps; ++k)
		for (int j = 0; j < kSteps; ++j)
			for (int i = 0; i < kSteps; ++i)
				maker.cell(grid::kHexahedron,
				           {id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1),
				            id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)});
}

grid::Block movedBlock(double u0, const auto& move, double v0 = 0.0)
{
	CellListMaker maker;
	addColumn(maker, u0, v0, move);
	return withArrays(maker.block("moved"));
}

Vec3 unmoved(const Vec3& p)
{
	return p;
}

// Not along z: a plane of lattice points stays one.
Vec3 movedBy(double length, const Vec3& p)
{
	return p + length * Vec3(std::sin(40.0 * p.y), std::cos(50.0 * p.z), 0.0);
}

Vec3 movedByRounding(const Vec3& p)
{
	return movedBy(1e-13, p);
}

// More than rounding, less than a cell.
Vec3 movedALittle(const Vec3& p)
{
	return movedBy(1e-9, p);
}

// Adds a point array, whose values are a function of the place.
grid::Block withArray(grid::Block block, const std::string& name, const auto& value_at)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    std::vector<double> values(grid.pointCount());
		    for (PointId p = 0; p < grid.pointCount(); ++p)
			    values[grid.sourcePoint(p)] = value_at(grid.point(p));
		    block.fields.push_back(grid::makeField(name, grid::Association::point, 1, std::move(values)));
	    },
	    block.grid);
	return block;
}

std::vector<grid::Block> twoBlocks()
{
	return {movedBlock(0.0, unmoved), movedBlock(1.0, unmoved)};
}

// Four columns around the edge u = v = 1, one for each rank.
std::vector<grid::Block> fourColumns(const auto& move_third)
{
	return {movedBlock(0.0, unmoved), movedBlock(1.0, unmoved), movedBlock(0.0, move_third, 1.0),
	        movedBlock(1.0, unmoved, 1.0)};
}

} // namespace

// The sheet runs through the edge that two columns share, and through cells of these two alone. Those beside them have
// faces on both.
TEST(HardBorders, RanksThatShareAnEdgeAloneAreJoinedByThoseBeside)
{
	CellListMaker maker;
	for (const auto& [u0, v0] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}})
		addColumn(maker, u0, v0, unmoved);
	const grid::BlockSet whole = setOfBlocks({withArrays(maker.block("moved"))});
	for (const Vec3 normal : {Vec3(1.0, -1.0, 0.0), Vec3(-1.0, 1.0, 0.0), Vec3(1.0, 1.0, 0.0), Vec3(-1.0, -1.0, 0.0)})
	{
		const cut::CutRequest request = requestFor({{1.0, 1.0, 0.5}, normal});
		ranks::Ranks one = ranks::Ranks::alone();
		const Figures expected = figuresOf(one, whole, OneSheet(one, whole, request));
		EXPECT_EQ(expected.components, 1u);
		EXPECT_EQ(expected.vertices, std::size_t((2 * kSteps + 1) * (kSteps + 1)));
		EXPECT_NEAR(expected.area, 2.0 * std::sqrt(2.0), 1e-12);
		withMany(fourColumns(unmoved), true, 1,
		         [&](ranks::Ranks& ranks, const grid::BlockSet& own)
		         {
			         expectSame(figuresOf(ranks, own, OneSheet(ranks, own, request)), expected,
			                    fmt::format("{} {}", normal.x, normal.y));
		         });
	}
}

// Cells dealt out at random meet other ranks' in faces, edges and points. The planes run through such edges and points.
TEST(HardBorders, CellsDealtOutAtRandomAreJoinedAsByOne)
{
	constexpr int kCells = 4; // along each axis
	constexpr int kRanks = 4;
	constexpr int kTries = 60;
	std::mt19937 random(7);
	const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
	for (int attempt = 0; attempt < kTries; ++attempt)
	{
		CellListMaker all;
		std::array<CellListMaker, kRanks> of_rank;
		std::array<std::map<std::array<int, 3>, std::array<std::int64_t, 2>>, kRanks> ids; // in `all`, and of the rank
		for (int cell = 0; cell < kCells * kCells * kCells; ++cell)
		{
			const auto rank = static_cast<std::size_t>(cell < kRanks ? cell : upTo(kRanks - 1));
			std::vector<std::int64_t> in_all, own;
			for (const auto& [i, j, k] : {std::array{0, 0, 0},
			                              {1, 0, 0},
			                              {1, 1, 0},
			                              {0, 1, 0},
			                              std::array{0, 0, 1},
			                              {1, 0, 1},
			                              {1, 1, 1},
			                              {0, 1, 1}})
			{
				const std::array at{cell % kCells + i, cell / kCells % kCells + j, cell / (kCells * kCells) + k};
				const Vec3 place = Vec3(at[0], at[1], at[2]) / double(kCells);
				const auto [known, is_new] = ids[rank].try_emplace(at);
				if (is_new)
					known->second = {all.point(place), of_rank[rank].point(place)};
				in_all.push_back(known->second[0]);
				own.push_back(known->second[1]);
			}
			all.cell(grid::kHexahedron, in_all);
			of_rank[rank].cell(grid::kHexahedron, own);
		}
		const Vec3 normal(upTo(4) - 2, upTo(4) - 2, upTo(2) + 1);
		const Vec3 origin = Vec3(upTo(kCells), upTo(kCells), upTo(kCells - 2) + 1) / double(kCells);
		const cut::CutRequest request = requestFor({origin, normal});
		const grid::BlockSet whole = setOfBlocks({withArrays(all.block("all"))});
		ranks::Ranks one = ranks::Ranks::alone();
		const Figures expected = figuresOf(one, whole, OneSheet(one, whole, request));
		std::vector<grid::Block> blocks;
		for (CellListMaker& maker : of_rank)
			blocks.push_back(withArrays(maker.block("part")));
		withMany(blocks, true, 1,
		         [&](ranks::Ranks& ranks, const grid::BlockSet& own)
		         {
			         expectSame(figuresOf(ranks, own, OneSheet(ranks, own, request)), expected,
			                    fmt::format("try {}: normal {} {} {} through {} {} {}", attempt, normal.x, normal.y,
			                                normal.z, origin.x, origin.y, origin.z));
		         });
	}
}

TEST(HardBorders, RimsOfWindowsAreJoined)
{
	cut::CutRequest request = requestFor(kCuts[0]);
	request.probe.sheets[0].window = probe::Window{-0.61, 0.43, -0.27, 0.31};
	expectJoinedAsByOne(twoBlocks(), request, "window");
	expectJoinedAsByOne({withArrays(latticeBlock(straight, 0.0, false)), withArrays(latticeBlock(straight, 1.0, true))},
	                    request, "lattices");
}

// Two nappes of a cone in two ranks touch in one grid point, around which the polygons of each close.
TEST(HardBorders, CurvedSheetsAreOnePieceWhereTheyTouchInAPoint)
{
	cut::CutRequest request = requestFor({{1.0, 0.5, 0.5}, {1.0, 0.0, 0.0}});
	request.probe.sheets[0].form = surface::ImplicitSurface::parse("x*x + y*y - z*z").value();
	Figures expected;
	withOneAndWithMany(
	    {Kind::lattice, straight, 2},
	    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	    {
		    expected = figuresOf(ranks, own, OneSheet(ranks, own, request));
		    EXPECT_EQ(expected.components, 1u);
	    },
	    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	    { expectSame(figuresOf(ranks, own, OneSheet(ranks, own, request)), expected, "cone"); });
}

TEST(HardBorders, VerticesWithOtherValuesStayTwo)
{
	std::vector<grid::Block> blocks = twoBlocks();
	blocks[0] = withArray(blocks[0], "side", [](const Vec3&) { return 1.0; });
	blocks[1] = withArray(blocks[1], "side", [](const Vec3&) { return 2.0; });
	expectJoinedAsByOne(blocks, "other values");
	blocks = twoBlocks();
	blocks[0] = withArray(blocks[0], "left", [](const Vec3& p) { return p.y; });
	blocks[1] = withArray(blocks[1], "right", [](const Vec3& p) { return p.y; });
	expectJoinedAsByOne(blocks, "other names");
}

// The values at the cut are zero but for rounding, which the ends of the edges tell.
TEST(HardBorders, ValuesThatRoundingHasPartedAreOne)
{
	std::vector<grid::Block> blocks = twoBlocks();
	blocks[0] = withArray(blocks[0], "steep", [](const Vec3& p) { return 1e6 * (p.z - 0.375); });
	blocks[1] = withArray(blocks[1], "steep", [](const Vec3& p) { return 1e6 * (p.z - 0.375) + 1e-9; });
	const cut::CutRequest request = requestFor({{1.0, 0.5, 0.375}, {0.0, 0.0, 1.0}});
	expectJoinedAsByOne(blocks, request, "steep");
	withMany(blocks, false, 1,
	         [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	         {
		         const OneSheet sheet(ranks, own, request);
		         EXPECT_EQ(sumOf(ranks, sheet.borders.vertices_elsewhere), kSteps + 1u);
	         });
}

TEST(HardBorders, PlacesThatRoundingHasPartedAreJoined)
{
	for (const auto& move : {movedByRounding, movedALittle})
	{
		expectJoinedAsByOne({movedBlock(0.0, unmoved), movedBlock(1.0, move)}, "two");
		expectJoinedAsByOne({movedBlock(0.0, unmoved), movedBlock(1.0, move), movedBlock(2.0, unmoved)}, "three");
		expectJoinedAsByOne(fourColumns(move), "columns");
	}
}

// Single precision far from the origin: the coordinates of one place differ in their last bit.
TEST(HardBorders, PlacesInSinglePrecisionAreJoined)
{
	const auto floatBlock = [](double u0, float away)
	{
		constexpr std::uint32_t n = kSteps + 1;
		std::vector<float> xyz;
		for (std::uint32_t k = 0; k < n; ++k)
			for (std::uint32_t j = 0; j < n; ++j)
				for (std::uint32_t i = 0; i < n; ++i)
				{
					const auto y = static_cast<float>(100.0 + 0.1 * j);
					xyz.push_back(static_cast<float>(u0 + 0.25 * i));
					xyz.push_back(std::nextafter(y, y + away));
					xyz.push_back(static_cast<float>(0.25 * k));
				}
		grid::Block block;
		block.name = "floats";
		block.grid = grid::CurvilinearGrid({n, n, n}, grid::Points(Array<float>(std::move(xyz))));
		grid::finishBlock(block);
		return withArray(std::move(block), "hills", [](const Vec3& p) { return p.z; });
	};
	expectJoinedAsByOne({floatBlock(0.0, 0.0f), floatBlock(1.0, 1.0f)},
	                    requestFor({{1.0, 100.2, 0.3}, {0.1, 0.2, 1.0}}), "floats");
}

// The edges of one run against those of the other.
TEST(HardBorders, TurnedLatticesAreJoined)
{
	for (const Place place : {straight, warped})
		expectJoinedAsByOne({withArrays(latticeBlock(place, 0.0, false)), withArrays(latticeBlock(place, 1.0, true))},
		                    "turned");
}

TEST(HardBorders, NegativeZeroIsThePlaceOfZero)
{
	const auto negated = [](const Vec3& p) { return Vec3(p.x, p.y == 0.0 ? -0.0 : p.y, p.z == 0.0 ? -0.0 : p.z); };
	const std::vector<grid::Block> blocks{movedBlock(0.0, unmoved), movedBlock(1.0, negated)};
	expectJoinedAsByOne(blocks, "negative zero");
	expectJoinedAsByOne(blocks, requestFor({{1.0, 0.0, 0.5}, {0.0, 1.0, 0.0}}), "in the plane of zero");
}

// Each of four borders has 4 + 1 vertices, and one is common to all: 4 x 4 + 1 places, 3 + 4 x 4 vertices too many. If
// rounding has parted one column, the three others know each other there, and the first of them knows it. One vertex
// more is two then: at x = 0 the wind along y is nothing in one block, and a little in the other.
TEST(HardBorders, AnEdgeOfFourRanksHasOneVertex)
{
	for (const bool is_parted : {false, true})
	{
		std::mutex mutex;
		std::map<std::uint64_t, std::map<int, Vec3>> places;
		withMany(is_parted ? fourColumns(movedByRounding) : fourColumns(unmoved), false, 1,
		         [&](ranks::Ranks& ranks, const grid::BlockSet& own)
		         {
			         const OneSheet sheet(ranks, own, requestFor({{1.0, 1.0, 0.3}, {0.0, 0.0, 1.0}}));
			         EXPECT_EQ(sumOf(ranks, sheet.borders.vertices_elsewhere), is_parted ? 18u : 19u);
			         EXPECT_EQ(sheet.borders.components, 1u);
			         const int rank = ranks.team()->rank();
			         const std::lock_guard lock(mutex);
			         for (const ranks::SharedVertex& shared : sheet.borders.shared)
			         {
				         const bool is_new =
				             places[shared.id].emplace(rank, sheet.mesh.positions[shared.vertex]).second;
				         EXPECT_TRUE(is_new) << shared.id;
				         EXPECT_FALSE(shared.ranks.empty());
				         EXPECT_FALSE(std::ranges::binary_search(shared.ranks, rank));
			         }
		         });
		std::set<std::pair<int, int>> at_edge;
		for (const auto& [id, of_ranks] : places)
			for (const auto& [rank, at] : of_ranks)
				for (const auto& [other, there] : of_ranks)
				{
					EXPECT_LT(glm::distance(at, there), 1e-8) << id;
					if (rank < other && glm::distance(at, Vec3(1.0, 1.0, 0.3)) < 1e-8)
						at_edge.emplace(rank, other);
				}
		EXPECT_EQ(at_edge.size(), is_parted ? 4u : 6u);
	}
}

// Two triangles on a square hang, although all of their corners are its corners.
TEST(HardBorders, TrianglesOnASquareHang)
{
	CellListMaker cube;
	for (const double z : {0.0, 1.0})
		for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0)})
			cube.point({x, y, z});
	cube.cell(grid::kHexahedron, {0, 1, 2, 3, 4, 5, 6, 7});
	CellListMaker wedges;
	for (const double x : {1.0, 2.0})
		for (const auto& [y, z] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0)})
			wedges.point({x, y, z});
	wedges.cell(grid::kWedge, {0, 1, 2, 4, 5, 6});
	wedges.cell(grid::kWedge, {0, 2, 3, 4, 6, 7});
	withMany({withArrays(cube.block("cube")), withArrays(wedges.block("wedges"))}, false, 1,
	         [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	         { EXPECT_FALSE(ranks::boundaryEdgesOfAll(*ranks.team(), ranks.share(), own)); });
}

// Each vertex has the polygons around it that one process has there, and their values.
TEST(HardBorders, PolygonsAroundAreThoseOfOneProcess)
{
	const auto centerOf = [](const mesh::SheetMesh& mesh, std::size_t polygon)
	{
		Vec3 center(0.0);
		for (const std::uint32_t v : mesh.polygon(polygon))
			center += mesh.positions[v];
		return center / static_cast<double>(mesh.polygon(polygon).size());
	};
	const auto around = [](const mesh::SheetMesh& mesh)
	{
		std::vector<std::size_t> polygons(mesh.positions.size());
		for (std::size_t p = 0; p < mesh.polygons(); ++p)
			for (const std::uint32_t v : mesh.polygon(p))
				++polygons[v];
		return polygons;
	};
	const cut::CutRequest request = requestFor({{1.0, 1.0, 0.3}, {0.01, 0.02, 1.0}});
	mesh::SheetMesh whole;
	std::vector<std::size_t> expected;
	withOneAndWithMany(
	    fourColumns(unmoved),
	    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	    {
		    whole = OneSheet(ranks, own, request).mesh;
		    expected = around(whole);
	    },
	    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	    {
		    const OneSheet sheet(ranks, own, request);
		    mesh::SheetMesh mesh = sheet.mesh;
		    std::vector<double> values;
		    for (std::size_t p = 0; p < mesh.polygons(); ++p)
			    values.push_back(centerOf(mesh, p).x);
		    const std::size_t added = ranks::addPolygonsAround(*ranks.team(), sheet.borders, mesh, values);
		    EXPECT_EQ(added, mesh.polygons() - sheet.mesh.polygons());
		    EXPECT_EQ(added, 9u); // 4 beside each of two borders, one across the edge
		    ASSERT_EQ(values.size(), mesh.polygons());
		    for (std::size_t p = 0; p < values.size(); ++p)
			    EXPECT_NEAR(values[p], centerOf(mesh, p).x, 1e-12);
		    const std::vector<std::size_t> found = around(mesh);
		    for (std::size_t v = 0; v < sheet.mesh.positions.size(); ++v)
		    {
			    std::size_t at = 0;
			    for (std::size_t w = 1; w < whole.positions.size(); ++w)
				    if (glm::distance(whole.positions[w], mesh.positions[v]) <
				        glm::distance(whole.positions[at], mesh.positions[v]))
					    at = w;
			    EXPECT_EQ(found[v], expected[at]);
		    }
	    });
}

} // namespace vp::test
