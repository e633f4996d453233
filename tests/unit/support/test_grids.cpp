#include "test_grids.h"

#include "grid/demo/demo.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

namespace vp::test
{

using namespace vp::grid;

namespace
{

constexpr double kTurn = 2.0 * std::numbers::pi;

enum VtkType : std::uint8_t
{
	kTriangle = 5,
	kTetra = 10,
	kVoxel = 11,
	kHexahedron = 12,
	kWedge = 13,
	kPolyhedron = 42
};

Block finished(std::string name, AnyGrid grid)
{
	Block block;
	block.name = std::move(name);
	block.grid = std::move(grid);
	addTestFields(block);
	finishBlock(block);
	return block;
}

Block demoGrid(const char* name, int n)
{
	Result<BlockSet> set = makeDemo(name, n);
	Block block = std::move(set->blocks[0]);
	addTestFields(block);
	return block;
}

template <class PointAt>
Block curvilinear(std::string name, std::array<std::uint32_t, 3> points, PointAt&& point_at)
{
	std::vector<double> xyz;
	for (std::uint32_t k = 0; k < points[2]; ++k)
		for (std::uint32_t j = 0; j < points[1]; ++j)
			for (std::uint32_t i = 0; i < points[0]; ++i)
			{
				const Vec3 p = point_at(i, j, k);
				xyz.insert(xyz.end(), {p.x, p.y, p.z});
			}
	return finished(std::move(name), CurvilinearGrid(points, Points(Array<double>(std::move(xyz)))));
}

// A third of a cylinder: all points at i = 0 lie on its axis.
Block collapsedAxis()
{
	return curvilinear("collapsed_axis", {4, 6, 4},
	                   [](int i, int j, int k)
	                   {
		                   const double angle = kTurn / 3.0 * j / 5.0;
		                   return Vec3(i * std::cos(angle), i * std::sin(angle), 0.8 * k);
	                   });
}

Block leftHanded()
{
	return curvilinear("left_handed", {5, 6, 7},
	                   [](int i, int j, int k)
	                   { return Vec3(-0.5 * i - 0.02 * j * j, 0.4 * j + 0.03 * i * k, 0.3 * k + 0.02 * i * j); });
}

Block warpedCurvilinear()
{
	std::mt19937 random(7);
	std::uniform_real_distribution<double> jitter(-0.35, 0.35);
	return curvilinear("warped_curvilinear", {7, 7, 7},
	                   [&](int i, int j, int k)
	                   {
		                   // One after the other: compilers evaluate arguments in different orders.
		                   const double z = k + jitter(random);
		                   const double y = j + jitter(random);
		                   return Vec3(i + jitter(random), y, z);
	                   });
}

using LatticeIds = std::vector<std::int64_t>;

// Points (0..n)^3, moved by `place`.
template <class Place>
LatticeIds addLattice(CellListMaker& maker, int n, Place&& place)
{
	LatticeIds ids;
	for (int k = 0; k <= n; ++k)
		for (int j = 0; j <= n; ++j)
			for (int i = 0; i <= n; ++i)
				ids.push_back(maker.point(place(i, j, k)));
	return ids;
}

std::vector<std::int64_t> cornersAt(const LatticeIds& ids, int n, int i, int j, int k)
{
	const auto at = [&](int di, int dj, int dk) { return ids[((k + dk) * (n + 1) + j + dj) * (n + 1) + i + di]; };
	return {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)};
}

template <class Visit>
void forLattice(int n, Visit&& visit)
{
	for (int k = 0; k < n; ++k)
		for (int j = 0; j < n; ++j)
			for (int i = 0; i < n; ++i)
				visit(i, j, k);
}

std::vector<std::vector<std::int64_t>> facesOfHexahedron(const std::vector<std::int64_t>& ids)
{
	const ShapeTopology& shape = topology(CellShape::hexahedron);
	std::vector<std::vector<std::int64_t>> faces;
	for (int f = 0; f < shape.faces; ++f)
	{
		faces.emplace_back();
		for (const std::uint8_t corner : shape.facePoints(f))
			faces.back().push_back(ids[corner]);
	}
	return faces;
}

// Around an axis: below hexahedra whose -i side is the axis, so that ids repeat, above them real wedges.
Block collapsedHexahedra()
{
	constexpr int sectors = 6;
	CellListMaker maker;
	std::array<std::int64_t, 3> axis;
	std::array<std::array<std::int64_t, sectors>, 3> rim;
	for (int k = 0; k < 3; ++k)
	{
		axis[k] = maker.point({0.0, 0.0, k});
		for (int j = 0; j < sectors; ++j)
			rim[k][j] = maker.point({2.0 * std::cos(kTurn * j / sectors), 2.0 * std::sin(kTurn * j / sectors), k});
	}
	for (int j = 0; j < sectors; ++j)
	{
		const int next = (j + 1) % sectors;
		maker.cell(kHexahedron, {axis[0], rim[0][j], rim[0][next], axis[0], axis[1], rim[1][j], rim[1][next], axis[1]});
	}
	for (int j = 0; j < sectors; ++j)
	{
		const int next = (j + 1) % sectors;
		maker.cell(kWedge, {axis[1], rim[1][next], rim[1][j], axis[2], rim[2][next], rim[2][j]});
	}
	return maker.block("collapsed_hexahedra");
}

// Some hexahedra list their points mirrored.
Block inverted()
{
	constexpr int n = 4;
	CellListMaker maker;
	const LatticeIds ids = addLattice(maker, n, [](int i, int j, int k) { return Vec3(i, j, 0.5 * k); });
	forLattice(n,
	           [&](int i, int j, int k)
	           {
		           std::vector<std::int64_t> c = cornersAt(ids, n, i, j, k);
		           if ((i + 2 * j + 3 * k) % 7 == 0)
			           c = {c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3]};
		           maker.cell(kHexahedron, c);
	           });
	return maker.block("inverted");
}

// Hexagonal prisms, one on the other, in a ring of hexahedra.
Block hexagonalPrisms()
{
	CellListMaker maker;
	std::array<std::array<std::array<std::int64_t, 6>, 2>, 3> at;
	for (int k = 0; k < 3; ++k)
		for (int ring = 0; ring < 2; ++ring)
			for (int j = 0; j < 6; ++j)
				at[k][ring][j] = maker.point(
				    {(1.0 + ring) * std::cos(kTurn * j / 6.0), (1.0 + ring) * std::sin(kTurn * j / 6.0), k});
	for (int k = 0; k < 2; ++k)
	{
		std::vector<std::vector<std::int64_t>> faces(2);
		for (int j = 0; j < 6; ++j)
		{
			const int next = (j + 1) % 6;
			faces[0].insert(faces[0].begin(), at[k][0][j]);
			faces[1].push_back(at[k + 1][0][j]);
			faces.push_back({at[k][0][j], at[k][0][next], at[k + 1][0][next], at[k + 1][0][j]});
			maker.cell(kHexahedron, {at[k][0][j], at[k][1][j], at[k][1][next], at[k][0][next], at[k + 1][0][j],
			                         at[k + 1][1][j], at[k + 1][1][next], at[k + 1][0][next]});
		}
		maker.polyhedron(faces);
	}
	return maker.block("hexagonal_prisms");
}

// A warped box of hexahedra, every third of them given by its faces, with a voxel among them and two triangles beside.
Block mixedPolyhedra()
{
	constexpr int n = 4;
	std::mt19937 random(11);
	std::uniform_real_distribution<double> jitter(-0.2, 0.2);
	CellListMaker maker;
	const auto place = [&](int i, int j, int k)
	{
		const bool fixed = i < 2 && j < 2 && k < 2;
		return Vec3(i, j, k) + (fixed ? Vec3(0.0) : Vec3(jitter(random), jitter(random), jitter(random)));
	};
	const LatticeIds ids = addLattice(maker, n, place);
	maker.cell(kTriangle, {ids[0], ids[1], ids[2]});
	forLattice(n,
	           [&](int i, int j, int k)
	           {
		           const std::vector<std::int64_t> c = cornersAt(ids, n, i, j, k);
		           if (i + j + k == 0)
			           maker.cell(kVoxel, {c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]});
		           else if ((i + j + k) % 3 == 0)
			           maker.polyhedron(facesOfHexahedron(c));
		           else
			           maker.cell(kHexahedron, c);
	           });
	maker.cell(kTriangle, {ids[0], ids[2], ids[1]});
	maker.point({50.0, 50.0, 50.0}); // no cell uses it
	return maker.block("mixed_polyhedra");
}

// A unit cube with four cells of half its edge against its +x side.
Block twoToOne()
{
	CellListMaker maker;
	const auto box = [&](const Vec3& lo, double edge)
	{
		std::vector<std::int64_t> ids;
		for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1),
		                           Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)})
			ids.push_back(maker.point(lo + edge * corner));
		return ids;
	};
	maker.cell(kHexahedron, box({0, 0, 0}, 1.0));
	std::array<std::array<std::array<std::int64_t, 3>, 3>, 2> fine;
	for (int i = 0; i < 2; ++i)
		for (int j = 0; j < 3; ++j)
			for (int k = 0; k < 3; ++k)
				fine[i][j][k] = maker.point({1.0 + 0.5 * i, 0.5 * j, 0.5 * k});
	std::vector<FaceLink> links;
	for (int k = 0; k < 2; ++k)
		for (int j = 0; j < 2; ++j)
		{
			maker.cell(kHexahedron,
			           {fine[0][j][k], fine[1][j][k], fine[1][j + 1][k], fine[0][j + 1][k], fine[0][j][k + 1],
			            fine[1][j][k + 1], fine[1][j + 1][k + 1], fine[0][j + 1][k + 1]});
			links.push_back({0, 1, maker.cells() - 1, 0});
		}
	return maker.block("two_to_one", std::move(links));
}

// Three tetrahedra on one triangle, and one more that shares only an edge with them.
Block threeOnAFace()
{
	CellListMaker maker;
	const std::int64_t a = maker.point({0, 0, 0});
	const std::int64_t b = maker.point({1, 0, 0});
	const std::int64_t c = maker.point({0, 1, 0});
	const std::int64_t above = maker.point({0.2, 0.2, 1});
	const std::int64_t further = maker.point({0.4, 0.2, 1.5});
	const std::int64_t below = maker.point({0.3, 0.3, -1});
	maker.cell(kTetra, {a, b, c, above});
	maker.cell(kTetra, {a, b, c, further});
	maker.cell(kTetra, {a, c, b, below});
	maker.cell(kTetra, {a, b, maker.point({0.5, -1, 0.5}), maker.point({0.5, -1, -0.5})});
	return maker.block("three_on_a_face");
}

Block warpedHexahedra()
{
	constexpr int n = 6;
	std::mt19937 random(3);
	std::uniform_real_distribution<double> jitter(-0.4, 0.4);
	CellListMaker maker;
	const LatticeIds ids = addLattice(maker, n,
	                                  [&](int i, int j, int k)
	                                  { return Vec3(i + jitter(random), j + jitter(random), k + jitter(random)); });
	forLattice(n, [&](int i, int j, int k) { maker.cell(kHexahedron, cornersAt(ids, n, i, j, k)); });
	return maker.block("warped_hexahedra");
}

Block renamed(Block block, const char* name)
{
	block.name = name;
	return block;
}

std::vector<Block> makeAll()
{
	std::vector<Block> all;
	all.push_back(demoGrid("blob", 8));
	all.push_back(demoGrid("graded", 7));
	all.push_back(demoGrid("shell", 9));
	all.push_back(demoGrid("hexes", 7));
	all.push_back(demoGrid("tets", 5));
	all.push_back(demoGrid("mixed", 6));
	all.push_back(leftHanded());
	all.push_back(warpedCurvilinear());
	all.push_back(collapsedAxis());
	all.push_back(collapsedHexahedra());
	all.push_back(inverted());
	all.push_back(hexagonalPrisms());
	all.push_back(mixedPolyhedra());
	all.push_back(twoToOne());
	all.push_back(threeOnAFace());
	all.push_back(warpedHexahedra());
	all.push_back(renamed(explicitHexahedra(6, [](int i, int j, int) { return j < 2 || i < 2 || i >= 4; }), "u_shape"));
	all.push_back(renamed(explicitHexahedra(6, [](int i, int, int) { return i < 2 || i >= 4; }), "two_pieces"));
	all.push_back(demoGrid("layer", 6));
	return all;
}

} // namespace

void addTestFields(Block& block, std::size_t source_cells)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    std::vector<double> linear(grid.pointCount());
		    for (std::size_t p = 0; p < grid.pointCount(); ++p)
			    linear[grid.sourcePoint(static_cast<PointId>(p))] = linearAt(grid.point(static_cast<PointId>(p)));
		    std::vector<std::int64_t> id(source_cells ? source_cells : grid.cellCount());
		    for (std::size_t c = 0; c < id.size(); ++c)
			    id[c] = static_cast<std::int64_t>(c);
		    block.fields.push_back(makeField("linear", Association::point, 1, std::move(linear)));
		    block.fields.push_back(makeField("id", Association::cell, 1, std::move(id)));
	    },
	    block.grid);
}

double linearAt(const Vec3& p)
{
	return 2.0 * p.x - 3.0 * p.y + 0.5 * p.z + 1.0;
}

std::int64_t CellListMaker::point(const Vec3& p)
{
	xyz_.insert(xyz_.end(), {p.x, p.y, p.z});
	return static_cast<std::int64_t>(xyz_.size() / 3 - 1);
}

void CellListMaker::cell(std::uint8_t vtk_type, const std::vector<std::int64_t>& ids)
{
	types_.push_back(vtk_type);
	ids_.insert(ids_.end(), ids.begin(), ids.end());
	offsets_.push_back(static_cast<std::int64_t>(ids_.size()));
	face_offsets_.push_back(static_cast<std::int64_t>(face_stream_.size()));
}

void CellListMaker::polyhedron(const std::vector<std::vector<std::int64_t>>& faces)
{
	face_stream_.push_back(static_cast<std::int64_t>(faces.size()));
	for (const std::vector<std::int64_t>& face : faces)
	{
		face_stream_.push_back(static_cast<std::int64_t>(face.size()));
		face_stream_.insert(face_stream_.end(), face.begin(), face.end());
	}
	cell(kPolyhedron, {});
}

CellList CellListMaker::list() const
{
	CellList cells;
	cells.types = types_;
	cells.offsets = offsets_;
	cells.connectivity = ids_;
	if (!face_stream_.empty())
	{
		cells.face_offsets = face_offsets_;
		cells.face_stream = face_stream_;
	}
	return cells;
}

Block CellListMaker::block(std::string name, std::vector<FaceLink> links) const
{
	Block made;
	made.name = std::move(name);
	made.grid = UnstructuredGrid::build(points(), list(), std::move(links));
	addTestFields(made, types_.size());
	finishBlock(made);
	return made;
}

Block explicitHexahedra(int n, bool (*keep)(int i, int j, int k))
{
	CellListMaker maker;
	const LatticeIds ids = addLattice(maker, n, [&](int i, int j, int k) { return Vec3(i, j, k) / double(n); });
	forLattice(n,
	           [&](int i, int j, int k)
	           {
		           if (keep(i, j, k))
			           maker.cell(kHexahedron, cornersAt(ids, n, i, j, k));
	           });
	return maker.block("hexahedra");
}

const std::vector<Block>& allGrids()
{
	static const std::vector<Block> all = makeAll();
	return all;
}

const Block& gridNamed(std::string_view name)
{
	for (const Block& block : allGrids())
		if (block.name == name)
			return block;
	std::fprintf(stderr, "no test grid %.*s\n", static_cast<int>(name.size()), name.data());
	std::abort();
}

} // namespace vp::test
