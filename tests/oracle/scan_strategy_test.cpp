// Published unstructured data sets, where the environment variable VPROBE_DATA names the folder that holds them: a scan
// and a search find the same polygons.
#include "cut/cutter.h"
#include "exhaustive.h"
#include "read/read.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace vp::test
{

namespace
{

/// A polygon by the file's cell and its places, in any order.
struct PolygonOfCell
{
	std::size_t block;
	std::size_t source_cell;
	std::vector<std::array<double, 3>> places;
};

/// Without those that have no area but by rounding, of which one way of numbering keeps some and another drops them.
std::vector<PolygonOfCell> polygonsOf(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh)
{
	std::vector<PolygonOfCell> polygons;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		double longest = 0.0;
		for (const std::uint32_t v : mesh.polygon(p))
			longest = std::max(longest, glm::length(mesh.positions[v] - mesh.positions[mesh.polygon(p)[0]]));
		if (glm::length(mesh::doubleArea(mesh, mesh.polygon(p))) <= 1e-12 * longest * longest)
			continue;
		const mesh::BlockCell& cell = mesh.polygon_cells[p];
		PolygonOfCell& polygon = polygons.emplace_back();
		polygon.block = cell.block;
		polygon.source_cell = std::get<grid::UnstructuredGrid>(blocks.blocks[cell.block].grid).sourceCell(cell.cell);
		for (const std::uint32_t v : mesh.polygon(p))
			polygon.places.push_back({mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z});
	}
	return polygons;
}

/// How far a place of one lies from the nearest place of the other, at most.
double distance(const PolygonOfCell& a, const PolygonOfCell& b)
{
	double most = a.places.size() == b.places.size() ? 0.0 : std::numeric_limits<double>::infinity();
	for (const auto& p : a.places)
	{
		double least = std::numeric_limits<double>::infinity();
		for (const auto& q : b.places)
			least = std::min(least, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
		most = std::max(most, least);
	}
	return most;
}

void expectSamePolygons(std::vector<PolygonOfCell> found, std::vector<PolygonOfCell> expected, double tolerance)
{
	ASSERT_EQ(found.size(), expected.size());
	const auto before = [](const PolygonOfCell& a, const PolygonOfCell& b)
	{ return std::tie(a.block, a.source_cell) < std::tie(b.block, b.source_cell); };
	std::ranges::stable_sort(found, before);
	std::ranges::stable_sort(expected, before);
	std::vector<bool> taken(expected.size());
	std::size_t missing = 0;
	for (const PolygonOfCell& polygon : found)
	{
		const auto [first, last] = std::equal_range(expected.begin(), expected.end(), polygon, before);
		// The nearest: linear parts of a curved cell may have polygons so thin that several are close.
		auto nearest = last;
		double least = tolerance;
		for (auto at = first; at != last; ++at)
			if (const double away = distance(polygon, *at) + distance(*at, polygon);
			    away <= least && !taken[static_cast<std::size_t>(at - expected.begin())])
			{
				least = away;
				nearest = at;
			}
		if (nearest == last)
			++missing;
		else
			taken[static_cast<std::size_t>(nearest - expected.begin())] = true;
	}
	EXPECT_EQ(missing, 0u);
}

class ScannedFile : public testing::TestWithParam<const char*>
{
};

} // namespace

TEST_P(ScannedFile, HasThePolygonsOfASearch)
{
	const char* folder = std::getenv("VPROBE_DATA");
	if (!folder)
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	const std::string path = std::filesystem::path(folder) / GetParam();
	if (!std::filesystem::exists(path))
		GTEST_SKIP() << path << " is not there";
	read::ReadOptions options;
	options.builds_neighbors = false;
	const grid::BlockSet listed = std::move(read::readInputs({path}, options, nullptr).value());
	ASSERT_FALSE(grid::hasNeighbors(listed));
	grid::BlockSet linked = listed;
	grid::buildNeighbors(linked);
	EXPECT_EQ(listed.bounds().lo, linked.bounds().lo);
	EXPECT_EQ(listed.bounds().hi, linked.bounds().hi);
	EXPECT_EQ(listed.sourceCellCount(), linked.sourceCellCount());

	std::vector<TestPlane> planes = randomPlanes(linked.bounds(), 6, 81);
	for (int axis = 0; axis < 3; ++axis)
	{
		planes.push_back({linked.bounds().center(), Vec3(0.0)});
		planes.back().normal[axis] = 1.0;
	}
	cut::Cutter scanner(listed);
	cut::Cutter searcher(linked);
	for (const TestPlane& plane : planes)
	{
		cut::CutRequest request;
		request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
		request.strategy = find::Strategy::scan;
		const cut::Cut scanned = std::move(scanner.cut(request).value());
		request.strategy = find::Strategy::cells;
		const cut::Cut searched = std::move(searcher.cut(request).value());
		const mesh::SheetMesh found = scanned.mesh(listed, 0);
		const mesh::SheetMesh expected = searched.mesh(linked, 0);
		EXPECT_EQ(found.positions.size(), expected.positions.size());
		expectSamePolygons(polygonsOf(listed, found), polygonsOf(linked, expected), 1e-13 * linked.bounds().diagonal());
	}
}

INSTANTIATE_TEST_SUITE_P(
    Data, ScannedFile,
    testing::Values(
        "unstructured/hexa/hexa.vtk", "unstructured/uGridEx/uGridEx.vtk", "unstructured/disk_out_ref/disk_out_ref.ex2",
        "unstructured/post_tets/post.vtk", "unstructured/AngularSector/AngularSector.vtk",
        "unstructured/notch_stress/notch_stress.vtk", "unstructured/box_hybrid/box_hybrid_mesh.vtu",
        "unstructured/PentaHexa/PentaHexa.vtk", "unstructured/multi_element_o1/simple-cube-multi-element-order1.e",
        "higher-order/CylinderQuadratic/CylinderQuadratic.vtk", "higher-order/notch_disp/notch_disp.vtu",
        "higher-order/TriQuadraticHexahedron/TriQuadraticHexahedron.vtu",
        "higher-order/QuadraticPyramid/QuadraticPyramid.vtu", "higher-order/QuadraticWedge/QuadraticWedge.vtu",
        "higher-order/QuadraticTetra/QuadraticTetra.vtu", "higher-order/lagrange_hex_o4/hex_3x3x3_o4.vtk",
        "polyhedral/polyhedron2pieces/polyhedron2pieces.vtu", "polyhedral/pebi3d/pebi3d_with_properties.vtu",
        "polyhedral/ensight_nfaced/TEST_bin.case", "polyhedral/flange/flange.foam", "time/mug/mug.e",
        "time/can_hdf/can_1.hdf", "formats/cavity_foam/case.foam", "formats/elements_ensight/elements.case",
        "topology/manifoldCheck0/manifoldCheck0.vtu", "topology/manifoldCheck1/manifoldCheck1.vtu",
        "topology/manifoldCheck2/manifoldCheck2.vtu"),
    [](const auto& of)
    {
	    std::string name = std::filesystem::path(of.param).stem();
	    std::ranges::replace_if(
	        name, [](unsigned char c) { return !std::isalnum(c); }, '_');
	    return name;
    });

} // namespace vp::test
