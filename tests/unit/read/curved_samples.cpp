#include "curved_samples.h"

#include "sample_files.h"
#include "unit_cube.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cmath>
#include <map>
#include <numeric>

using vp::Vec3;

namespace
{

ParentShape shapeOf(std::uint8_t type)
{
	switch (type)
	{
	case VTK_QUADRATIC_TETRA:
	case VTK_LAGRANGE_TETRAHEDRON:
	case VTK_BEZIER_TETRAHEDRON:
		return ParentShape::tetrahedron;
	case VTK_QUADRATIC_WEDGE:
	case VTK_QUADRATIC_LINEAR_WEDGE:
	case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
	case VTK_LAGRANGE_WEDGE:
	case VTK_BEZIER_WEDGE:
		return ParentShape::wedge;
	case VTK_QUADRATIC_PYRAMID:
	case VTK_TRIQUADRATIC_PYRAMID:
		return ParentShape::pyramid;
	default:
		return ParentShape::hexahedron;
	}
}

void setDegrees(vtkUnstructuredGrid* grid, const CurvedKind& kind)
{
	if (kind.degrees[0] == 0)
		return;
	vtkNew<vtkDoubleArray> degrees;
	degrees->SetName("HigherOrderDegrees");
	degrees->SetNumberOfComponents(3);
	for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
		degrees->InsertNextTuple3(kind.degrees[0], kind.degrees[1], kind.degrees[2]);
	grid->GetCellData()->SetHigherOrderDegrees(degrees);
}

void insertCell(vtkUnstructuredGrid* grid, const CurvedKind& kind)
{
	std::vector<vtkIdType> ids(static_cast<std::size_t>(kind.points));
	std::iota(ids.begin(), ids.end(), 0);
	grid->InsertNextCell(kind.type, kind.points, ids.data());
}

// Returns the places of a cell's points in a cube, half a cube, a pyramid on the unit square with its top at (1/2, 1/2,
// 1), or a corner of the cube.
std::vector<Vec3> referencePoints(const CurvedKind& kind)
{
	vtkNew<vtkUnstructuredGrid> grid;
	vtkNew<vtkPoints> points;
	points->SetNumberOfPoints(kind.points);
	for (vtkIdType p = 0; p < kind.points; ++p)
		points->SetPoint(p, 0.0, 0.0, 0.0);
	grid->SetPoints(points);
	grid->Allocate(1);
	if (kind.type == VTK_CONVEX_POINT_SET)
		return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
	insertCell(grid, kind);
	setDegrees(grid, kind);
	const double* at = grid->GetCell(0)->GetParametricCoords();
	std::vector<Vec3> places;
	for (int p = 0; p < kind.points; ++p, at += 3)
	{
		Vec3 place(at[0], at[1], at[2]);
		if (kind.type == VTK_QUADRATIC_PYRAMID)
			place = Vec3(place.x * (1 - place.z) + 0.5 * place.z, place.y * (1 - place.z) + 0.5 * place.z, place.z);
		if (kind.type == VTK_TRIQUADRATIC_PYRAMID)
			place.z = 2.0 * place.z - 1.0;
		places.push_back(place);
	}
	return places;
}

void addArrays(vtkUnstructuredGrid* grid)
{
	vtkNew<vtkDoubleArray> f;
	f->SetName("f");
	vtkNew<vtkIntArray> n;
	n->SetName("n");
	for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
	{
		Vec3 at;
		grid->GetPoint(p, &at.x);
		f->InsertNextValue(sampleValue(at));
		n->InsertNextValue(static_cast<int>(std::lround(sampleValue(at))));
	}
	grid->GetPointData()->AddArray(f);
	grid->GetPointData()->AddArray(n);
	vtkNew<vtkIntArray> id;
	id->SetName("id");
	for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
		id->InsertNextValue(static_cast<int>(c));
	grid->GetCellData()->AddArray(id);
}

} // namespace

std::ostream& operator<<(std::ostream& out, const CurvedKind& kind)
{
	return out << kind.name;
}

const std::vector<CurvedKind>& curvedKinds()
{
	static const std::vector<CurvedKind> kinds = {
	    {"QuadraticTetra", VTK_QUADRATIC_TETRA, 10},
	    {"QuadraticHexahedron", VTK_QUADRATIC_HEXAHEDRON, 20},
	    {"QuadraticWedge", VTK_QUADRATIC_WEDGE, 15},
	    {"QuadraticPyramid", VTK_QUADRATIC_PYRAMID, 13},
	    {"TriQuadraticHexahedron", VTK_TRIQUADRATIC_HEXAHEDRON, 27},
	    {"QuadraticLinearWedge", VTK_QUADRATIC_LINEAR_WEDGE, 12},
	    {"BiQuadraticQuadraticWedge", VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18},
	    {"BiQuadraticQuadraticHexahedron", VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24},
	    {"TriQuadraticPyramid", VTK_TRIQUADRATIC_PYRAMID, 19},
	    {"LagrangeTetra2", VTK_LAGRANGE_TETRAHEDRON, 10},
	    {"LagrangeTetra15", VTK_LAGRANGE_TETRAHEDRON, 15},
	    {"LagrangeTetra4", VTK_LAGRANGE_TETRAHEDRON, 35},
	    {"LagrangeHexahedron1", VTK_LAGRANGE_HEXAHEDRON, 8},
	    {"LagrangeHexahedron3", VTK_LAGRANGE_HEXAHEDRON, 64},
	    {"LagrangeHexahedron243", VTK_LAGRANGE_HEXAHEDRON, 3 * 5 * 4, {2, 4, 3}},
	    {"LagrangeWedge2", VTK_LAGRANGE_WEDGE, 18},
	    {"LagrangeWedge21", VTK_LAGRANGE_WEDGE, 21},
	    {"LagrangeWedge332", VTK_LAGRANGE_WEDGE, 30, {3, 3, 2}},
	    {"BezierTetra3", VTK_BEZIER_TETRAHEDRON, 20},
	    {"BezierHexahedron2", VTK_BEZIER_HEXAHEDRON, 27},
	    {"BezierWedge2", VTK_BEZIER_WEDGE, 18},
	    {"ConvexPointSet", VTK_CONVEX_POINT_SET, 8},
	};
	return kinds;
}

vtkSmartPointer<vtkUnstructuredGrid> curvedMesh(const CurvedKind& kind, const std::function<Vec3(Vec3)>& shape)
{
	const std::vector<Vec3> reference = referencePoints(kind);
	const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	points->SetDataType(VTK_DOUBLE);
	std::map<std::array<long, 3>, vtkIdType> known;
	grid->Allocate(1);
	for (int block = 0; block < 8; ++block)
		for (const CellFrame& frame : unitCubeCells(shapeOf(kind.type)))
		{
			const Vec3 corner(block % 2, block / 2 % 2, block / 4);
			std::vector<vtkIdType> ids;
			for (const Vec3& r : reference)
			{
				const Vec3 at = corner + frame[0] + r.x * frame[1] + r.y * frame[2] + r.z * frame[3];
				// Degrees up to 4, and middles of triangles and tetrahedra, all lie on this lattice.
				const std::array<long, 3> place = {std::lround(at.x * 5040), std::lround(at.y * 5040),
				                                   std::lround(at.z * 5040)};
				const auto [found, is_new] = known.try_emplace(place, points->GetNumberOfPoints());
				if (is_new)
				{
					Vec3 moved = 0.5 * at * kCurvedBox;
					if (shape)
						moved = shape(moved);
					points->InsertNextPoint(&moved.x);
				}
				ids.push_back(found->second);
			}
			grid->InsertNextCell(kind.type, static_cast<vtkIdType>(ids.size()), ids.data());
		}
	grid->SetPoints(points);
	addArrays(grid);
	setDegrees(grid, kind);
	return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> curvedCell(const CurvedKind& kind)
{
	const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	points->SetDataType(VTK_DOUBLE);
	for (const Vec3& at : referencePoints(kind))
		points->InsertNextPoint(&at.x);
	grid->SetPoints(points);
	grid->Allocate(1);
	insertCell(grid, kind);
	addArrays(grid);
	setDegrees(grid, kind);
	return grid;
}

void writeGrid(vtkUnstructuredGrid* grid, const std::string& path)
{
	vtkNew<vtkXMLUnstructuredGridWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(grid);
	writer->Write();
}
