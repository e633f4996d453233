// Curved cells and odd ones come as linear cells: none of the volume is lost, neighbors fit, and every part knows its
// cell.
#include "curved_samples.h"
#include "grid/measure.h"
#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

using namespace vp;

namespace
{

Result<grid::BlockSet> readGrid(vtkUnstructuredGrid* grid, double refine = 0.0)
{
	const TemporaryFolder folder;
	writeGrid(grid, folder / "grid.vtu");
	return read::readInputs({folder / "grid.vtu"}, {{}, "", refine}, nullptr);
}

const grid::UnstructuredGrid& cellsOfSet(const grid::BlockSet& set)
{
	return std::get<grid::UnstructuredGrid>(set.blocks[0].grid);
}

const grid::Field& fieldOf(const grid::BlockSet& set, std::string_view name)
{
	for (const grid::Field& field : set.blocks[0].fields)
		if (field.name == name)
			return field;
	throw std::runtime_error("no array " + std::string(name));
}

// The volume of the parts of each cell; none of them inside out. The coordinates of VTK's quadratic wedges turn against
// the order of their points, so that all wedges of a mesh may read negative.
std::vector<double> volumes(const grid::BlockSet& set)
{
	const grid::UnstructuredGrid& grid = cellsOfSet(set);
	std::vector<double> sums(grid.sourceCellCount());
	grid::CellFaces faces;
	const bool wedges = grid.cellCount() > 0 && grid.shape(0) == grid::CellShape::wedge;
	const double sign = wedges && grid::signedVolume(grid, 0, faces) < 0.0 ? -1.0 : 1.0;
	for (std::size_t c = 0; c < grid.cellCount(); ++c)
	{
		const double volume = sign * grid::signedVolume(grid, static_cast<CellId>(c), faces);
		EXPECT_GT(volume, 0.0) << "cell " << c;
		sums.at(grid.sourceCell(static_cast<CellId>(c))) += volume;
	}
	return sums;
}

// Wherever a point lies, f is what it is there.
void expectLinearField(const grid::BlockSet& set)
{
	const grid::UnstructuredGrid& grid = cellsOfSet(set);
	const grid::Field& f = fieldOf(set, "f");
	const grid::Field& n = fieldOf(set, "n");
	ASSERT_EQ(f.tuples(), grid.pointCount());
	ASSERT_EQ(n.type, grid::NumberType::int32);
	for (std::size_t p = 0; p < grid.pointCount(); ++p)
	{
		const std::size_t source = grid.sourcePoint(static_cast<PointId>(p));
		const double expected = sampleValue(grid.point(static_cast<PointId>(p)));
		EXPECT_NEAR(f.value(source, 0), expected, 1e-9);
		EXPECT_EQ(n.value(source, 0), std::round(n.value(source, 0)));
	}
}

// Every face without a neighbor lies in a side of the box, and they cover its sides.
void expectConforming(const grid::BlockSet& set)
{
	const grid::UnstructuredGrid& grid = cellsOfSet(set);
	grid::CellFaces faces;
	double area = 0.0;
	for (const auto& [cell, f] : set.blocks[0].boundary.faces)
	{
		grid.cellFaces(cell, faces);
		const auto face = faces[static_cast<int>(f)];
		bool in_side = false;
		for (int axis = 0; axis < 3; ++axis)
			for (const double side : {0.0, kCurvedBox[axis]})
				in_side |= std::all_of(face.begin(), face.end(),
				                       [&](PointId p) { return std::abs(grid.point(p)[axis] - side) < 1e-9; });
		EXPECT_TRUE(in_side) << "face " << f << " of cell " << cell;
		area += glm::length(grid::polygonArea(face.size(), [&](std::size_t i) { return grid.point(face[i]); }));
	}
	const Vec3 b = kCurvedBox;
	EXPECT_NEAR(area, 2.0 * (b.x * b.y + b.y * b.z + b.z * b.x), 1e-9);
}

Vec3 bent(Vec3 at)
{
	return at + 0.05 * Vec3(at.y * at.y, at.x * at.z, at.x * at.y);
}

class Curved : public testing::TestWithParam<CurvedKind>
{
};

} // namespace

TEST_P(Curved, CellKeepsItsVolume)
{
	const auto source = curvedCell(GetParam());
	const auto set = readGrid(source);
	ASSERT_TRUE(set) << set.error().message;
	grid::validate(set->blocks[0]);
	ASSERT_EQ(cellsOfSet(*set).sourceCellCount(), 1u);
	const std::string name = GetParam().name;
	const double expected = name.find("Tetra") != name.npos     ? 1.0 / 6.0
	                        : name.find("Pyramid") != name.npos ? 1.0 / 3.0
	                        : name.find("Wedge") != name.npos   ? 0.5
	                                                            : 1.0;
	EXPECT_NEAR(volumes(*set)[0], expected, 1e-12);
	expectLinearField(*set);
}

TEST_P(Curved, MeshIsConforming)
{
	const auto source = curvedMesh(GetParam());
	const auto cells = static_cast<std::size_t>(source->GetNumberOfCells());
	const int levels = GetParam().type == VTK_CONVEX_POINT_SET || GetParam().points > 30 ? 1 : 3;
	std::size_t last = 0;
	for (int level = 0; level < levels; ++level)
	{
		SCOPED_TRACE(level);
		const auto set = readGrid(source, level);
		ASSERT_TRUE(set) << set.error().message;
		grid::validate(set->blocks[0]);
		EXPECT_EQ(set->sourceCellCount(), cells);
		EXPECT_EQ(set->sourcePointCount(), static_cast<std::size_t>(source->GetNumberOfPoints()));
		EXPECT_GT(set->cellCount(), last);
		EXPECT_EQ(cellsOfSet(*set).splitsCells(), set->cellCount() > cells);
		last = set->cellCount();
		expectConforming(*set);
		expectLinearField(*set);
		// All cells are of a size; the array of ids is as long as the file's.
		const double volume = kCurvedBox.x * kCurvedBox.y * kCurvedBox.z / static_cast<double>(cells);
		for (const double part : volumes(*set))
			EXPECT_NEAR(part, volume, 1e-9);
		EXPECT_EQ(fieldOf(*set, "id").tuples(), cells);
	}
}

TEST_P(Curved, BentMeshIsConforming)
{
	if (GetParam().type == VTK_CONVEX_POINT_SET)
		GTEST_SKIP() << "its faces are flat";
	for (const int level : {0, 1})
	{
		const auto flat = readGrid(curvedMesh(GetParam()), level);
		const auto set = readGrid(curvedMesh(GetParam(), bent), level);
		ASSERT_TRUE(flat);
		ASSERT_TRUE(set) << set.error().message;
		grid::validate(set->blocks[0]);
		EXPECT_EQ(set->cellCount(), flat->cellCount());
		EXPECT_EQ(set->pointCount(), flat->pointCount());
		EXPECT_EQ(set->blocks[0].boundary.faces.size(), flat->blocks[0].boundary.faces.size());
		// The shape functions of the coordinates are those of f.
		if (GetParam().type < VTK_BEZIER_CURVE)
			expectLinearField(*set);
		volumes(*set);
	}
}

INSTANTIATE_TEST_SUITE_P(Read, Curved, testing::ValuesIn(curvedKinds()),
                         [](const testing::TestParamInfo<CurvedKind>& info) { return std::string(info.param.name); });

TEST(Linearize, NewPointsFollowTheCurve)
{
	// One 20-node hexahedron whose points lie on x = (y - 1/2)^2 more than they would: a parabola its shape functions
	// hold.
	const auto source = curvedCell({"", VTK_QUADRATIC_HEXAHEDRON, 20});
	for (vtkIdType p = 0; p < source->GetNumberOfPoints(); ++p)
	{
		Vec3 at;
		source->GetPoint(p, &at.x);
		at.x += (at.y - 0.5) * (at.y - 0.5);
		source->GetPoints()->SetPoint(p, &at.x);
	}
	const auto set = readGrid(source, 2);
	ASSERT_TRUE(set);
	double least = 1.0;
	for (std::size_t p = 0; p < set->pointCount(); ++p)
	{
		const Vec3 at = cellsOfSet(*set).point(static_cast<PointId>(p));
		const double across = at.x - (at.y - 0.5) * (at.y - 0.5);
		EXPECT_NEAR(across * 8.0, std::round(across * 8.0), 1e-12);
		least = std::min(least, across);
	}
	EXPECT_NEAR(least, 0.0, 1e-12);
	EXPECT_EQ(set->cellCount(), 512u);
	EXPECT_EQ(set->pointCount(), 729u);
}

TEST(Linearize, BezierPointsAreHandles)
{
	const auto source = curvedCell({"", VTK_BEZIER_HEXAHEDRON, 27});
	// Point 8 is the handle between points 0 and 1.
	source->GetPoints()->SetPoint(8, 0.5, -0.4, 0.0);
	const auto set = readGrid(source);
	ASSERT_TRUE(set);
	bool found = false;
	for (std::size_t p = 0; p < set->pointCount(); ++p)
	{
		const auto point = static_cast<PointId>(p);
		const Vec3 at = cellsOfSet(*set).point(point);
		if (cellsOfSet(*set).sourcePoint(point) != 8)
			continue;
		found = true;
		EXPECT_NEAR(at.x, 0.5, 1e-12);
		EXPECT_NEAR(at.y, -0.2, 1e-12);
	}
	EXPECT_TRUE(found);
}

TEST(Linearize, PrismsBecomePolyhedra)
{
	for (const int sides : {5, 6})
	{
		vtkNew<vtkUnstructuredGrid> source;
		vtkNew<vtkPoints> points;
		for (int layer = 0; layer < 3; ++layer)
			for (int i = 0; i < sides; ++i)
				points->InsertNextPoint(std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides), layer);
		source->SetPoints(points);
		source->Allocate(2);
		for (int layer = 0; layer < 2; ++layer)
		{
			std::vector<vtkIdType> ids;
			for (int i = 0; i < 2 * sides; ++i)
				ids.push_back(layer * sides + i);
			source->InsertNextCell(sides == 5 ? VTK_PENTAGONAL_PRISM : VTK_HEXAGONAL_PRISM, 2 * sides, ids.data());
		}
		const auto set = readGrid(source);
		ASSERT_TRUE(set) << set.error().message;
		grid::validate(set->blocks[0]);
		EXPECT_EQ(set->cellCount(), 2u);
		EXPECT_FALSE(cellsOfSet(*set).splitsCells());
		EXPECT_EQ(set->blocks[0].boundary.faces.size(), std::size_t(2 + 2 * sides));
		for (const double volume : volumes(*set))
			EXPECT_NEAR(volume, 0.5 * sides * std::sin(2 * M_PI / sides), 1e-6);
	}
}

TEST(Linearize, FlatAndHiddenCellsAreCountedOnce)
{
	const auto source = curvedMesh({"", VTK_QUADRATIC_HEXAHEDRON, 20});
	const std::array<vtkIdType, 3> triangle = {0, 1, 2};
	source->InsertNextCell(VTK_TRIANGLE, 3, triangle.data());
	vtkNew<vtkUnsignedCharArray> ghosts;
	ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
	for (int c = 0; c < 9; ++c)
		ghosts->InsertNextValue(c == 3 ? vtkDataSetAttributes::HIDDENCELL : 0);
	source->GetCellData()->RemoveArray("id");
	source->GetCellData()->AddArray(ghosts);
	const auto set = readGrid(source);
	ASSERT_TRUE(set) << set.error().message;
	grid::validate(set->blocks[0]);
	EXPECT_EQ(set->left_out, 1u);
	EXPECT_EQ(set->sourceCellCount(), 7u);
	EXPECT_EQ(set->cellCount(), 56u);
	for (std::size_t c = 0; c < set->cellCount(); ++c)
		EXPECT_NE(cellsOfSet(*set).sourceCell(static_cast<CellId>(c)), 3u);
}

TEST(Linearize, LinearCellsStayAsTheyAre)
{
	const auto source = curvedMesh({"", VTK_HEXAHEDRON, 8});
	const auto set = readGrid(source, 2);
	ASSERT_TRUE(set);
	EXPECT_EQ(set->cellCount(), 8u);
	EXPECT_EQ(set->pointCount(), 27u);
}

TEST(Linearize, DamagedAndEndlessCellsAreRefused)
{
	const auto refusalOf = [](const CurvedKind& kind, vtkIdType points, vtkIdType first, double refine)
	{
		const auto source = curvedMesh(kind);
		std::vector<vtkIdType> ids;
		for (vtkIdType i = 0; i < points; ++i)
			ids.push_back(first + i);
		source->InsertNextCell(kind.type, points, ids.data());
		source->GetCellData()->RemoveArray("id");
		const auto set = readGrid(source, refine);
		return set ? std::string() : set.error().message;
	};
	const CurvedKind quadratic{"", VTK_QUADRATIC_HEXAHEDRON, 20};
	const CurvedKind lagrange{"", VTK_LAGRANGE_HEXAHEDRON, 27};
	EXPECT_NE(refusalOf(quadratic, 19, 0, 0).find("lists 19 points"), std::string::npos);
	EXPECT_NE(refusalOf(quadratic, 20, 1000, 0).find("lists point"), std::string::npos);
	EXPECT_NE(refusalOf(lagrange, 26, 0, 0).find("lists 26 points"), std::string::npos);
	EXPECT_EQ(refusalOf(lagrange, 8, 0, 0), ""); // a cell of degree 1 among others of degree 2

	CurvedKind large{"", VTK_LAGRANGE_HEXAHEDRON, 9 * 9 * 9};
	EXPECT_NE(refusalOf(large, large.points, 0, 6).find("give a lower level"), std::string::npos);
}
