// Where cells meet several smaller ones, the sheet goes on: one piece, no gap, no T-junction. Each side keeps its
// values.
#include "closed_sheet.h"
#include "curved_samples.h"
#include "hyper_tree_samples.h"
#include "numbered_cells.h"

#include "mesh/mesh_values.h"
#include "read/read.h"
#include "sample_files.h"

#include <fmt/format.h>

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include <cmath>

namespace vp::test
{

namespace
{

using PointValue = std::function<double(Vec3 place, int level)>;

double linear(Vec3 p, int)
{
	return 1.0 + p.x + 2.0 * p.y - 3.0 * p.z;
}

// A cube of three levels: 6^3 cells, 1 wide, of which the middle ones are parted in two along each axis, twice.
class AmrCube
{
public:
	explicit AmrCube(const PointValue& value)
	{
		std::string index = R"(<VTKFile type="vtkOverlappingAMR" version="1.1" byte_order="LittleEndian">
<vtkOverlappingAMR origin="0 0 0" grid_description="XYZ">
)";
		for (int level = 0; level < 3; ++level)
		{
			const double spacing = std::ldexp(1.0, -level);
			const int first = level == 0 ? 0 : level == 1 ? 4 : 10; // cells of this level
			const int last = level == 0 ? 5 : level == 1 ? 9 : 13;
			writeBox(level, spacing, first, last, value);
			index += fmt::format("<Block level=\"{0}\" spacing=\"{1} {1} {1}\"><DataSet index=\"0\" "
			                     "amr_box=\"{2} {3} {2} {3} {2} {3}\" file=\"box{0}.vti\"/></Block>\n",
			                     level, spacing, first, last);
		}
		writeContents(folder_ / "cube.vthb", index + "</vtkOverlappingAMR></VTKFile>\n");
	}
	// 6^3 - 3^3 + 6^3 - 2^3 + 4^3
	static constexpr std::size_t kCells = 461;

	grid::BlockSet read() const { return std::move(*read::readInputs({folder_ / "cube.vthb"}, {}, nullptr)); }

private:
	void writeBox(int level, double spacing, int first, int last, const PointValue& value) const
	{
		vtkNew<vtkImageData> image;
		const int points = last - first + 2;
		image->SetDimensions(points, points, points);
		image->SetOrigin(first * spacing, first * spacing, first * spacing);
		image->SetSpacing(spacing, spacing, spacing);
		vtkNew<vtkDoubleArray> f;
		f->SetName("f");
		for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
		{
			Vec3 at;
			image->GetPoint(p, &at.x);
			f->InsertNextValue(value(at, level));
		}
		image->GetPointData()->AddArray(f);
		vtkNew<vtkDoubleArray> g;
		g->SetName("level");
		for (vtkIdType c = 0; c < image->GetNumberOfCells(); ++c)
			g->InsertNextValue(level);
		image->GetCellData()->AddArray(g);
		vtkNew<vtkXMLImageDataWriter> writer;
		writer->SetFileName((folder_ / fmt::format("box{}.vti", level)).c_str());
		writer->SetInputData(image);
		writer->Write();
	}

	TemporaryFolder folder_;
};

// One hexahedron beside 3 x 3 small ones that share no points with it, both at a large distance from the origin.
CubeMesh threeToOne()
{
	CubeMesh mesh = cubeOf(linearCells()[2], 3);
	movePoints(mesh, [](Vec3 p) { return Vec3(1.0 + p.x, p.y, p.z); });
	const CubeMesh large = cubeOf(linearCells()[2], 1);
	for (std::vector<std::size_t> cell : large.cells)
	{
		for (std::size_t& id : cell)
			id += mesh.points.size();
		mesh.cells.push_back(cell);
	}
	mesh.points.insert(mesh.points.end(), large.points.begin(), large.points.end());
	mesh.values.resize(mesh.points.size());
	setValues(mesh, [](Vec3 p) { return linear(p, 0); });
	return mesh;
}

std::size_t cutCells(const Whole& whole)
{
	std::size_t count = 0;
	for (const find::BlockCut& cut : whole.cut.sheets[0].cuts)
		count += cut.cutCells();
	return count;
}

// Through both level boundaries, from side to side in z.
const std::vector<TestPlane> kPlanes = {{{3, 3, 2.82}, {0.21, -0.13, 1}}, {{3, 3, 3.06}, {0, 0, 1}},
                                        {{3, 3, 2.625}, {0.3, 0.1, 1}},   {{3, 3, 3}, {0, 0, 1}},
                                        {{3, 3, 2}, {0, 0, 1}},           {{3, 3, 2.5}, {0, 0, 1}}};

Box amrBox()
{
	Box box;
	box.include(Vec3(0.0));
	box.include(Vec3(6.0));
	return box;
}

} // namespace

TEST(Hanging, AmrLevelsAreOneSheet)
{
	const AmrCube cube(linear);
	const grid::BlockSet set = cube.read();
	ASSERT_EQ(set.blocks.size(), 3u);
	EXPECT_EQ(set.cellCount(), AmrCube::kCells);
	// The sides of the two inner boxes have 6 * 9 and 6 * 4 large faces, and four times as many small ones.
	EXPECT_EQ(set.interfaces.seam_faces, 5u * 6u * (9u + 4u));
	EXPECT_EQ(set.interfaces.boundary_faces, 6u * 36u);
	cut::Cutter cutter(set);
	for (const TestPlane& plane : kPlanes)
		for (const mesh::Hanging hanging : {mesh::Hanging::keep, mesh::Hanging::interpolate})
		{
			cut::CutRequest request;
			request.in_generations = true;
			request.hanging = hanging;
			const Whole whole = cutWhole(cutter, plane, request);
			EXPECT_NEAR(whole.figures.area, 36.0 * glm::length(plane.normal), 1e-11);
			EXPECT_NEAR(whole.figures.mean.value(), linear(plane.origin, 0), 1e-11);
			EXPECT_EQ(whole.figures.components, 1u);
			EXPECT_TRUE(whole.mesh.seam_pairs.empty());
			expectClosed(whole.mesh, amrBox());

			// From one seed, the search crosses to all levels.
			request.seeds.mode = seed::SeedMode::hotspot;
			EXPECT_EQ(cutCells(cutWhole(cutter, plane, request)), cutCells(whole));
		}
}

TEST(Hanging, CellDataAreThoseOfEachCell)
{
	const AmrCube cube(linear);
	const grid::BlockSet set = cube.read();
	cut::Cutter cutter(set);
	const Whole whole = cutWhole(cutter, kPlanes[1]); // z = 3.06
	std::vector<double> areas(3);
	for (std::size_t p = 0; p < whole.mesh.polygons(); ++p)
		areas[whole.mesh.polygon_cells[p].block] +=
		    0.5 * glm::length(mesh::doubleArea(whole.mesh, whole.mesh.polygon(p)));
	EXPECT_NEAR(areas[2], 1.0, 1e-12);
	EXPECT_NEAR(areas[1], 9.0 - 1.0, 1e-12);
	EXPECT_NEAR(areas[0], 36.0 - 9.0, 1e-12);
	const auto figures = measure::measure(set, whole.mesh, grid::FieldChoice{"level", grid::Association::cell});
	EXPECT_NEAR(figures.mean.value(), (8.0 + 2.0) / 36.0, 1e-12);
}

// Points of finer levels have values that the coarse ones do not hold.
TEST(Hanging, EachSideKeepsItsValuesUnlessAsked)
{
	const AmrCube cube([](Vec3, int level) { return double(level); });
	const grid::BlockSet set = cube.read();
	cut::Cutter cutter(set);
	const Box box = amrBox();
	for (const mesh::Hanging hanging : {mesh::Hanging::keep, mesh::Hanging::interpolate})
	{
		cut::CutRequest request;
		request.in_generations = true;
		request.hanging = hanging;
		const Whole whole = cutWhole(cutter, kPlanes[0], request);
		expectClosed(whole.mesh, box);
		EXPECT_EQ(whole.figures.components, 1u);
		const bool keeps = hanging == mesh::Hanging::keep;
		EXPECT_EQ(whole.mesh.seam_pairs.empty(), !keeps);
		EXPECT_NEAR(whole.figures.area, 36.0 * glm::length(kPlanes[0].normal), 1e-11);
		if (keeps)
		{
			std::vector<double> areas(3);
			for (std::size_t p = 0; p < whole.mesh.polygons(); ++p)
				areas[whole.mesh.polygon_cells[p].block] +=
				    0.5 * glm::length(mesh::doubleArea(whole.mesh, whole.mesh.polygon(p)));
			EXPECT_NEAR(whole.figures.mean.value(), (areas[1] + 2.0 * areas[2]) / whole.figures.area, 1e-12);
		}
		const auto fields = grid::FieldChoice{"f"}.inEach(set);
		std::vector<std::array<double, 2>> ranges(3, {9.0, -9.0}); // range over the vertices of each level's polygons
		for (std::size_t p = 0; p < whole.mesh.polygons(); ++p)
			for (const std::uint32_t v : whole.mesh.polygon(p))
			{
				const double value = mesh::vertexValue(set, whole.mesh, v, fields, 0);
				auto& [lo, hi] = ranges[whole.mesh.polygon_cells[p].block];
				lo = std::min(lo, value);
				hi = std::max(hi, value);
			}
		EXPECT_EQ(ranges[0], (std::array{0.0, 0.0}));
		EXPECT_EQ(ranges[1], (std::array{keeps ? 1.0 : 0.0, 1.0}));
		EXPECT_EQ(ranges[2], (std::array{keeps ? 2.0 : 1.0, 2.0}));
	}
}

TEST(Hanging, WindowsHoldTheirPart)
{
	const AmrCube cube(linear);
	const grid::BlockSet set = cube.read();
	cut::Cutter cutter(set);
	for (const mesh::Hanging hanging : {mesh::Hanging::keep, mesh::Hanging::interpolate})
	{
		cut::CutRequest request;
		request.in_generations = true;
		request.hanging = hanging;
		request.probe.sheets = {probe::makeSheet(kPlanes[0].origin, kPlanes[0].normal)};
		request.probe.sheets[0].window = probe::Window{-1.9, 1.9, -1.4, 1.4};
		const cut::Cut cut = std::move(cutter.cut(request).value());
		const mesh::SheetMesh mesh = cut.mesh(set, 0);
		const measure::SheetMeasure figures = measure::measure(set, mesh, grid::FieldChoice{"f"});
		EXPECT_NEAR(figures.area, 3.8 * 2.8, 1e-9);
		EXPECT_NEAR(figures.mean.value(), linear(kPlanes[0].origin, 0), 1e-9);
		EXPECT_EQ(figures.components, 1u);
	}
}

// A sphere about the corner of the finest box, through all levels.
TEST(Hanging, CurvedSheetsAreClosed)
{
	const AmrCube cube(linear);
	const grid::BlockSet set = cube.read();
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = {probe::makeSheet({2.53, 2.47, 2.51}, {0, 0, 1})};
	request.probe.sheets[0].form = surface::ImplicitSurface::parse("sphere:1.1").value();
	const cut::Cut cut = std::move(cutter.cut(request).value());
	const mesh::SheetMesh mesh = cut.mesh(set, 0);
	EXPECT_EQ(measure::measure(set, mesh, {}).components, 1u);
	expectClosed(mesh, amrBox());
}

TEST(Hanging, TreesAreOneSheet)
{
	const TemporaryFolder folder;
	const std::string path = folder / "trees.htg";
	writeTrees(path);
	const auto set = read::readInputs({path}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	Box box;
	box.include(Vec3(0.0));
	box.include(Vec3(3.0, 2.0, 4.0));
	// Quarters of the sides of 24 trees, counted in the smallest faces: nothing but the sides of the box bounds it.
	cut::Cutter cutter(*set);
	for (const TestPlane& plane : {TestPlane{{1.5, 1.0, 2.03}, {0.21, -0.13, 1.0}},
	                               TestPlane{{1.5, 1.0, 2.0}, {0, 0, 1}}, TestPlane{{1.5, 1.0, 1.625}, {0, 0, 1}}})
	{
		const Whole whole = cutWhole(cutter, plane);
		EXPECT_NEAR(whole.figures.area, 6.0 * glm::length(plane.normal), 1e-12);
		EXPECT_EQ(whole.figures.components, 1u);
		expectClosed(whole.mesh, box);
	}
}

TEST(Hanging, CellsThatShareNoPointsAreLinked)
{
	const TemporaryFolder folder;
	const std::string path = folder / "cells.vtu";
	writeXml(threeToOne(), path);
	Box box;
	box.include(Vec3(0.0));
	box.include(Vec3(2.0, 1.0, 1.0));
	for (const bool builds_neighbors : {true, false}) // without neighbors, the mesh finds the seams by itself
	{
		read::ReadOptions options;
		options.builds_neighbors = builds_neighbors;
		const auto set = read::readInputs({path}, options, nullptr);
		ASSERT_TRUE(set) << set.error().message;
		cut::Cutter cutter(*set);
		for (const TestPlane& plane :
		     {TestPlane{{1.0, 0.5, 0.5}, {0.2, 0.1, 1.0}}, TestPlane{{1.0, 0.5, 1.0 / 3.0}, {0, 0, 1}},
		      TestPlane{{1.0, 0.5, 0.5}, {-0.1, 1.0, 0.3}}})
		{
			cut::CutRequest request;
			const Whole whole = cutWhole(cutter, plane, request);
			EXPECT_NEAR(whole.figures.area, 2.0 * glm::length(plane.normal), 1e-12);
			EXPECT_NEAR(whole.figures.mean.value(), linear(plane.origin, 0), 1e-12);
			EXPECT_EQ(whole.figures.components, 1u);
			expectClosed(whole.mesh, box);
		}
	}
}

} // namespace vp::test
