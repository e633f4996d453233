// Sections converge with the square of the cells' size, whatever the cells: their area where the domain is curved, and
// the mean of a smooth field. The domain is the unit cube with the side x = 1 pushed out by a parabola in y.
#include "numbered_cells.h"

#include "read/read.h"
#include "sample_files.h"
#include "sliced_sheet.h"

#include <gtest/gtest.h>

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLRectilinearGridWriter.h>
#include <vtkXMLStructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>
#include <cmath>

namespace vp::test
{

namespace
{

constexpr double kBulge = 0.6;

Vec3 pushed(Vec3 p)
{
	return Vec3(p.x * (1.0 + kBulge * p.y * (1.0 - p.y)), p.y, p.z);
}

double smooth(Vec3 p)
{
	return std::sin(2.0 * p.x + 0.3) * std::cos(1.5 * p.y) + std::exp(p.z);
}

// From side to side in z.
const TestPlane kPlane{{0.0, 0.0, 0.31}, {-0.23, -0.17, 1.0}};

double heightAt(double x, double y)
{
	return kPlane.origin.z - kPlane.normal.x * x - kPlane.normal.y * y;
}

// By Simpson's rule.
double mean(const std::function<double(double, double)>& value, double bulge)
{
	constexpr int kSteps = 200;
	double sum = 0.0;
	double area = 0.0;
	for (int j = 0; j <= kSteps; ++j)
		for (int i = 0; i <= kSteps; ++i)
		{
			const auto weight = [](int k) { return k == 0 || k == kSteps ? 1.0 : k % 2 ? 4.0 : 2.0; };
			const double y = double(j) / kSteps;
			const double width = 1.0 + bulge * y * (1.0 - y);
			const double part = weight(i) * weight(j) * width;
			sum += part * value(width * i / kSteps, y);
			area += part;
		}
	return sum / area;
}

// The slope of the logarithms, by least squares.
double slope(const std::vector<double>& sizes, const std::vector<double>& errors)
{
	double sx = 0, sy = 0, sxx = 0, sxy = 0;
	const auto count = static_cast<double>(sizes.size());
	for (std::size_t i = 0; i < sizes.size(); ++i)
	{
		const double x = std::log(sizes[i]);
		const double y = std::log(std::abs(errors[i]));
		sx += x, sy += y, sxx += x * x, sxy += x * y;
	}
	return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

struct Measured
{
	double area;
	double mean;
};

Measured measured(const grid::BlockSet& set)
{
	cut::Cutter cutter(set);
	const SlicedSheet sheet = cut(cutter, kPlane);
	const measure::SheetMeasure measure =
	    measure::measure(set, sheet.mesh, grid::FieldChoice{"f", grid::Association::point, 0});
	return {measure.area, measure.mean.value()};
}

void expectSecondOrder(const std::vector<double>& sizes, const std::vector<Measured>& found, bool is_curved)
{
	const double bulge = is_curved ? kBulge : 0.0;
	const double area = (1.0 + bulge / 6.0) * glm::length(kPlane.normal);
	const double expected = mean([](double x, double y) { return smooth({x, y, heightAt(x, y)}); }, bulge);
	std::vector<double> of_area;
	std::vector<double> of_mean;
	for (const Measured& each : found)
	{
		of_area.push_back(each.area - area);
		of_mean.push_back(each.mean - expected);
	}
	if (is_curved)
		EXPECT_NEAR(slope(sizes, of_area), 2.0, 0.1) << testing::PrintToString(of_area);
	else
		EXPECT_LT(std::abs(of_area.back()), 1e-12);
	EXPECT_NEAR(slope(sizes, of_mean), 2.0, 0.1) << testing::PrintToString(of_mean);
}

std::vector<NumberedCell> allCells()
{
	std::vector<NumberedCell> cells = linearCells();
	for (const NumberedCell& cell : quadraticCells())
		cells.push_back(cell);
	for (const int degree : {2, 3, 5, 8})
	{
		cells.push_back(tetrahedronOf(Family::lagrange, degree));
		cells.push_back(wedgeOf(Family::lagrange, degree, degree));
		cells.push_back(hexahedronOf(Family::lagrange, {degree, degree, degree}));
	}
	cells.push_back(wedgeOf(Family::lagrange, 3, 2));
	cells.push_back(hexahedronOf(Family::lagrange, {2, 4, 3}));
	return cells;
}

class Convergence : public testing::TestWithParam<NumberedCell>
{
};

} // namespace

TEST_P(Convergence, IsOfSecondOrder)
{
	const NumberedCell& cell = GetParam();
	const TemporaryFolder folder;
	const std::string path = folder / "cells.vtu";
	std::vector<double> sizes;
	std::vector<Measured> found;
	for (const int intervals : {8, 12, 16, 24})
	{
		CubeMesh mesh = cubeOf(cell, std::max((intervals + cell.intervals) / cell.intervals, int(sizes.size()) + 1));
		movePoints(mesh, pushed);
		setValues(mesh, smooth);
		writeXml(mesh, path);
		const auto set = read::readInputs({path}, {}, nullptr);
		ASSERT_TRUE(set) << set.error().message;
		sizes.push_back(std::cbrt(1.0 / double(mesh.cells.size())));
		found.push_back(measured(*set));
	}
	expectSecondOrder(sizes, found, true);
}

namespace
{

template <class Writer, class Data>
Result<grid::BlockSet> readBack(Data* data, const std::string& ending)
{
	const TemporaryFolder folder;
	const std::string path = folder / ("cells" + ending);
	vtkNew<Writer> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(data);
	writer->Write();
	return read::readInputs({path}, {}, nullptr);
}

void addValues(vtkDataSet* data)
{
	vtkNew<vtkDoubleArray> f;
	f->SetName("f");
	for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
	{
		Vec3 at;
		data->GetPoint(p, &at.x);
		f->InsertNextValue(smooth(at));
	}
	data->GetPointData()->AddArray(f);
}

template <class Make>
void expectSecondOrderOf(Make make, bool is_curved)
{
	std::vector<double> sizes;
	std::vector<Measured> found;
	for (const int n : {8, 12, 16, 24})
	{
		const Result<grid::BlockSet> set = make(n);
		ASSERT_TRUE(set) << set.error().message;
		sizes.push_back(1.0 / n);
		found.push_back(measured(*set));
	}
	expectSecondOrder(sizes, found, is_curved);
}

} // namespace

TEST(LatticeConvergence, OfAnImage)
{
	const auto make = [](int n)
	{
		vtkNew<vtkImageData> image;
		image->SetDimensions(n + 1, n + 1, n + 1);
		image->SetSpacing(1.0 / n, 1.0 / n, 1.0 / n);
		addValues(image);
		return readBack<vtkXMLImageDataWriter>(image.Get(), ".vti");
	};
	expectSecondOrderOf(make, false);
}

TEST(LatticeConvergence, OfRectilinearCells)
{
	const auto make = [](int n)
	{
		vtkNew<vtkRectilinearGrid> grid;
		vtkNew<vtkDoubleArray> at;
		for (int i = 0; i <= n; ++i)
			at->InsertNextValue(std::pow(double(i) / n, 1.3));
		grid->SetDimensions(n + 1, n + 1, n + 1);
		grid->SetXCoordinates(at);
		grid->SetYCoordinates(at);
		grid->SetZCoordinates(at);
		addValues(grid);
		return readBack<vtkXMLRectilinearGridWriter>(grid.Get(), ".vtr");
	};
	expectSecondOrderOf(make, false);
}

TEST(LatticeConvergence, OfCurvilinearCells)
{
	const auto make = [](int n)
	{
		vtkNew<vtkStructuredGrid> grid;
		vtkNew<vtkPoints> points;
		points->SetDataTypeToDouble();
		for (int k = 0; k <= n; ++k)
			for (int j = 0; j <= n; ++j)
				for (int i = 0; i <= n; ++i)
				{
					const Vec3 at = pushed(Vec3(i, j, k) / double(n));
					points->InsertNextPoint(&at.x);
				}
		grid->SetDimensions(n + 1, n + 1, n + 1);
		grid->SetPoints(points);
		addValues(grid);
		return readBack<vtkXMLStructuredGridWriter>(grid.Get(), ".vts");
	};
	expectSecondOrderOf(make, true);
}

TEST(LatticeConvergence, OfPolyhedra)
{
	const auto make = [](int n)
	{
		CubeMesh mesh = cubeOf(linearCells()[2], n);
		movePoints(mesh, pushed);
		vtkNew<vtkUnstructuredGrid> grid;
		vtkNew<vtkPoints> points;
		points->SetDataTypeToDouble();
		for (const Vec3& at : mesh.points)
			points->InsertNextPoint(&at.x);
		grid->SetPoints(points);
		grid->Allocate(1);
		for (const std::vector<std::size_t>& ids : mesh.cells)
		{
			std::vector<vtkIdType> faces;
			for (const auto& face : std::initializer_list<std::array<int, 4>>{
			         {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
			{
				faces.push_back(4);
				for (const int corner : face)
					faces.push_back(static_cast<vtkIdType>(ids[corner]));
			}
			grid->InsertNextCell(VTK_POLYHEDRON, 6, faces.data());
		}
		addValues(grid);
		return readBack<vtkXMLUnstructuredGridWriter>(grid.Get(), ".vtu");
	};
	expectSecondOrderOf(make, true);
}

INSTANTIATE_TEST_SUITE_P(Cells, Convergence, testing::ValuesIn(allCells()),
                         [](const testing::TestParamInfo<NumberedCell>& info) { return info.param.name; });

} // namespace vp::test
