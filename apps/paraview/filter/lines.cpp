#include "parts.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace vprobe_paraview
{

namespace
{

using vprobe::Vector3;

// The array of a setting ("point:NAME"), as one number for each point.
vtkSmartPointer<vtkDoubleArray> shownValues(vtkPolyData& sheet, const Settings& settings)
{
	const std::string name = settings.array.substr(settings.array.find(':') + 1);
	vtkDataArray* array = sheet.GetPointData()->GetArray(name.c_str());
	if (!array)
		return nullptr;
	auto values = vtkSmartPointer<vtkDoubleArray>::New();
	values->SetName("vprobe:shown");
	values->SetNumberOfTuples(array->GetNumberOfTuples());
	const int components = array->GetNumberOfComponents();
	for (vtkIdType p = 0; p < array->GetNumberOfTuples(); ++p)
	{
		double value = 0.0;
		if (components == 1 || settings.component >= 0)
			value = array->GetComponent(p, std::max(settings.component, 0));
		else
		{
			for (int c = 0; c < components; ++c)
				value += array->GetComponent(p, c) * array->GetComponent(p, c);
			value = std::sqrt(value);
		}
		values->SetValue(p, value);
	}
	return values;
}

} // namespace

vtkSmartPointer<vtkPolyData> contourLines(vtkPolyData& sheet, const Settings& settings)
{
	auto lines = vtkSmartPointer<vtkPolyData>::New();
	if (sheet.GetNumberOfCells() == 0)
		return lines;
	const vtkSmartPointer<vtkDoubleArray> shown = shownValues(sheet, settings);
	if (!shown)
		throw Refused(
		    "Contour Lines need a point array; choose one under Array, or apply Cell Data to Point Data first");
	vtkNew<vtkPolyData> with_values;
	with_values->ShallowCopy(&sheet);
	with_values->GetPointData()->AddArray(shown);
	vtkNew<vtkContourFilter> filter;
	filter->SetInputData(with_values);
	filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "vprobe:shown");
	filter->SetComputeNormals(false);
	filter->SetComputeScalars(false);
	for (std::size_t i = 0; i < settings.line_values.size(); ++i)
		filter->SetValue(static_cast<int>(i), settings.line_values[i]);
	filter->Update();
	lines->ShallowCopy(filter->GetOutput());
	lines->GetPointData()->RemoveArray("vprobe:shown");
	return lines;
}

namespace
{

// Lines that grow, and of each point where it is.
struct Paths
{
	std::vector<Vector3> points;
	std::vector<Vector3> sampled; // where their values are taken
	std::vector<double> times;
	std::vector<std::vector<vtkIdType>> lines;
	std::vector<int> sheets; // of the lines

	vtkIdType add(const Vector3& point, double time) { return add(point, time, point); }
	vtkIdType add(const Vector3& point, double time, const Vector3& place)
	{
		points.push_back(point);
		sampled.push_back(place);
		times.push_back(time);
		return static_cast<vtkIdType>(points.size()) - 1;
	}
};

// The two barbs of an arrow's head, in the plane of the sheet's normal and the arrow.
void addHead(Paths& paths, const std::vector<vtkIdType>& shaft, const Vector3& normal, int sheet)
{
	constexpr double kLength = 0.3, kWidth = 0.12; // of the arrow's
	const auto tip = static_cast<std::size_t>(shaft.back());
	const Vector3 to = paths.points[tip], from = paths.points[static_cast<std::size_t>(shaft.front())];
	Vector3 along{}, side{};
	for (std::size_t a = 0; a < 3; ++a)
		along[a] = to[a] - from[a];
	for (std::size_t a = 0; a < 3; ++a)
		side[a] = normal[(a + 1) % 3] * along[(a + 2) % 3] - normal[(a + 2) % 3] * along[(a + 1) % 3];
	const double width = std::hypot(side[0], side[1], side[2]), length = std::hypot(along[0], along[1], along[2]);
	if (!(width > 1e-3 * length)) // it goes straight through the sheet
		side = {along[1] - along[2], along[2] - along[0], along[0] - along[1]};
	const double size = std::hypot(side[0], side[1], side[2]);
	if (!(size > 0.0))
		return;
	std::vector<vtkIdType> head;
	for (const double sign : {1.0, -1.0})
	{
		Vector3 barb{};
		for (std::size_t a = 0; a < 3; ++a)
			barb[a] = to[a] - kLength * along[a] + sign * kWidth * length / size * side[a];
		head.push_back(paths.add(barb, paths.times[tip], to)); // it may lie outside of the grid
	}
	paths.lines.push_back({head[0], shaft.back(), head[1]});
	paths.sheets.push_back(sheet);
}

Paths launched(const vprobe::Cut& cut, bool has_heads)
{
	Paths paths;
	for (std::size_t s = 0; s < cut.sheetCount(); ++s)
	{
		const vprobe::Traces traces = cut.traces(s);
		for (std::size_t t = 0; t + 1 < traces.offsets.size(); ++t)
		{
			std::vector<vtkIdType> line;
			for (auto p = static_cast<std::size_t>(traces.offsets[t]);
			     p < static_cast<std::size_t>(traces.offsets[t + 1]); ++p)
				line.push_back(paths.add({traces.points[3 * p], traces.points[3 * p + 1], traces.points[3 * p + 2]},
				                         traces.times[p]));
			if (line.size() < 2)
				continue;
			paths.lines.push_back(line);
			paths.sheets.push_back(static_cast<int>(s));
			if (has_heads)
				addHead(paths, line, cut.normal(s), static_cast<int>(s));
		}
	}
	return paths;
}

// Values of the input at the points.
void addSamples(const Paths& paths, const vprobe::Samples& samples, vtkPolyData& part)
{
	const auto count = static_cast<vtkIdType>(paths.points.size());
	for (const vprobe::Samples::Column& column : samples.columns)
	{
		vtkNew<vtkDoubleArray> array;
		array->SetName(column.array.name.c_str());
		array->SetNumberOfComponents(column.array.components);
		array->SetNumberOfTuples(count);
		std::copy(column.values.begin(), column.values.end(), array->GetPointer(0));
		part.GetPointData()->AddArray(array);
	}
}

} // namespace

vtkSmartPointer<vtkPolyData> pathsOf(const vprobe::Cut& cut, const KeptGrid& grid, const Settings& settings)
{
	auto part = vtkSmartPointer<vtkPolyData>::New();
	const bool are_tufts = settings.vectors == Vectors::tufts;
	const Paths paths = launched(cut, are_tufts);
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	points->SetNumberOfPoints(static_cast<vtkIdType>(paths.points.size()));
	vtkNew<vtkDoubleArray> times;
	times->SetName("vprobe:time");
	vtkNew<vtkIntArray> sheets;
	sheets->SetName("vprobe:sheet");
	for (std::size_t p = 0; p < paths.points.size(); ++p)
	{
		points->SetPoint(static_cast<vtkIdType>(p), paths.points[p].data());
		times->InsertNextValue(paths.times[p]);
	}
	vtkNew<vtkCellArray> lines;
	for (std::size_t l = 0; l < paths.lines.size(); ++l)
	{
		lines->InsertNextCell(static_cast<vtkIdType>(paths.lines[l].size()), paths.lines[l].data());
		sheets->InsertNextValue(paths.sheets[l]);
	}
	part->SetPoints(points);
	part->SetLines(lines);
	part->GetPointData()->AddArray(times);
	part->GetCellData()->AddArray(sheets);
	if (paths.points.empty() || !grid.data())
		return part;
	const vprobe::Result<vprobe::Samples> samples = grid.data()->sample(paths.sampled);
	if (!samples)
		throw Refused(samples.error().message);
	addSamples(paths, *samples, *part);
	return part;
}

} // namespace vprobe_paraview
