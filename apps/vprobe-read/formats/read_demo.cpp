// The built-in data sets, for convert: all else makes them where it needs them.
#include "grid/demo/demo.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cstring>

namespace vp::reader::formats
{

namespace
{

using grid::NumberType;

// Makes VTK's data set of a grid, with points and cells in the order of its source.
struct DemoMaker
{
	vtkSmartPointer<vtkDataSet> operator()(const grid::UniformGrid& grid) const
	{
		const auto n = grid.points();
		const Vec3 origin = grid.point(0);
		const Vec3 next = grid.point(grid.pointId(1, 1, 1));
		vtkNew<vtkImageData> image;
		image->SetDimensions(static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]));
		image->SetOrigin(origin.x, origin.y, origin.z);
		image->SetSpacing(next.x - origin.x, next.y - origin.y, next.z - origin.z);
		return image.Get();
	}
	vtkSmartPointer<vtkDataSet> operator()(const grid::RectilinearGrid& grid) const
	{
		vtkNew<vtkRectilinearGrid> made;
		std::array<int, 3> points;
		for (int a = 0; a < 3; ++a)
			points[static_cast<std::size_t>(a)] = static_cast<int>(grid.points()[static_cast<std::size_t>(a)]);
		made->SetDimensions(points.data());
		for (int a = 0; a < 3; ++a)
		{
			vtkNew<vtkDoubleArray> places;
			for (const double place : grid.axis(a).span())
				places->InsertNextValue(place);
			a == 0   ? made->SetXCoordinates(places)
			: a == 1 ? made->SetYCoordinates(places)
			         : made->SetZCoordinates(places);
		}
		return made.Get();
	}
	vtkSmartPointer<vtkDataSet> operator()(const grid::CurvilinearGrid& grid) const
	{
		vtkNew<vtkStructuredGrid> made;
		const auto n = grid.sourceLattice().points();
		made->SetDimensions(static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]));
		made->SetPoints(pointsOf(grid));
		return made.Get();
	}
	vtkSmartPointer<vtkDataSet> operator()(const grid::UnstructuredGrid& grid) const
	{
		constexpr std::array<int, 4> types = {VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON};
		vtkNew<vtkUnstructuredGrid> made;
		made->SetPoints(pointsOf(grid));
		made->AllocateEstimate(static_cast<vtkIdType>(grid.cellCount()), 8);
		for (std::size_t c = 0; c < grid.cellCount(); ++c)
		{
			const grid::CellPoints points = grid.cellPoints(static_cast<CellId>(c));
			std::array<vtkIdType, 8> ids;
			for (int i = 0; i < points.size; ++i)
				ids[static_cast<std::size_t>(i)] = points.id[static_cast<std::size_t>(i)];
			// Shapes stand in the order of their points.
			const std::size_t shape = points.size == 4 ? 0 : points.size == 5 ? 1 : points.size == 6 ? 2 : 3;
			made->InsertNextCell(types[shape], points.size, ids.data());
		}
		return made.Get();
	}

private:
	template <class Grid>
	static vtkSmartPointer<vtkPoints> pointsOf(const Grid& grid)
	{
		const auto points = vtkSmartPointer<vtkPoints>::New();
		points->SetDataType(grid.coordinates().isDouble() ? VTK_DOUBLE : VTK_FLOAT);
		points->SetNumberOfPoints(static_cast<vtkIdType>(grid.pointCount()));
		for (std::size_t p = 0; p < grid.pointCount(); ++p)
		{
			const auto id = static_cast<PointId>(p);
			const Vec3 at = grid.point(id);
			points->SetPoint(static_cast<vtkIdType>(grid.sourcePoint(id)), at.x, at.y, at.z);
		}
		return points;
	}
};

vtkSmartPointer<vtkDataArray> arrayOf(const grid::Field& field)
{
	const int type = field.type == NumberType::float32   ? VTK_FLOAT
	                 : field.type == NumberType::float64 ? VTK_DOUBLE
	                                                     : VTK_VOID;
	if (type == VTK_VOID)
		throw Refusal("its array " + field.name + " is of a type that is not written");
	const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
	array->SetName(field.name.c_str());
	array->SetNumberOfComponents(field.components);
	array->SetNumberOfTuples(static_cast<vtkIdType>(field.tuples()));
	std::memcpy(array->GetVoidPointer(0), field.bytes.data(), field.bytes.size());
	return array;
}

} // namespace

void readDemo(const Request& request, manifest::Writer& manifest)
{
	const std::string name = request.file.substr(kDemoPrefix.size());
	const Result<grid::BlockSet> set = grid::parseDemo(name, false);
	if (!set)
	{
		std::string reason = set.error().message; // which begins with the input
		if (const std::string start = request.file + ": "; reason.starts_with(start))
			reason.erase(0, start.size());
		throw Refusal(reason);
	}
	for (const grid::Block& block : set->blocks)
	{
		const vtkSmartPointer<vtkDataSet> data = std::visit(DemoMaker(), block.grid);
		for (const grid::Field& field : block.fields)
			if (field.association == grid::Association::point)
				data->GetPointData()->AddArray(arrayOf(field));
			else
				data->GetCellData()->AddArray(arrayOf(field));
		manifest.add(data);
	}
}

} // namespace vp::reader::formats
