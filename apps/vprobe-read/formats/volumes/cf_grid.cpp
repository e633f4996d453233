#include "cf_grid.h"

#include "cf_heights.h"
#include "cf_values.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/length_units.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::reader::volumes
{

namespace
{

bool isFinite(double place)
{
	return std::isfinite(place);
}

int intOf(std::size_t length)
{
	if (length > std::size_t(std::numeric_limits<int>::max()) - 1)
		throw damaged("a dimension is longer than can be");
	return static_cast<int>(length);
}

// Down is negative.
void turnUp(const hdf5::NetcdfFile& file, int variable, std::vector<double>& places)
{
	if (file.text(variable, "positive") == "down")
		for (double& place : places)
			place = 0.0 - place;
}

std::vector<double> placesAlong(const hdf5::NetcdfFile& file, const CfDimension& axis)
{
	std::vector<double> places;
	if (axis.coordinate < 0)
	{
		for (std::size_t i = 0; i < axis.length; ++i)
			places.push_back(static_cast<double>(i));
		return places;
	}
	places = cfNumbers(file, axis.coordinate);
	turnUp(file, axis.coordinate, places);
	if (isLongitude(file, axis.coordinate))
		unwrapLongitudes(places, places.size());
	return places;
}

void refuseFolded(const std::vector<double>& places, const std::string& name)
{
	double direction = 0.0, last = NAN;
	for (const double place : places)
	{
		if (!std::isfinite(place))
			continue;
		const double step = place - last;
		if (step == 0.0 || step * direction < 0.0)
			throw Refusal(fmt::format("the coordinates of its axis {} neither rise nor fall throughout; sort them, for "
			                          "instance with xarray's sortby",
			                          name));
		if (!std::isnan(step))
			direction = step;
		last = place;
	}
}

// The same places as an origin and a distance give, but for the last bits.
bool isEven(const std::vector<double>& places)
{
	const double step = places[1] - places[0];
	for (std::size_t i = 1; i < places.size(); ++i)
	{
		const double off = std::abs(places[0] + static_cast<double>(i) * step - places[i]);
		if (!(off <= 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(places[0]), std::abs(places[i]))))
			return false;
	}
	return step > 0.0;
}

vtkSmartPointer<vtkDoubleArray> arrayOfPlaces(const std::vector<double>& places)
{
	auto array = vtkSmartPointer<vtkDoubleArray>::New();
	array->SetNumberOfValues(static_cast<vtkIdType>(places.size()));
	std::ranges::copy(places, array->GetPointer(0));
	return array;
}

using Axes = std::array<std::vector<double>, 3>;

vtkSmartPointer<vtkDataSet> straightGrid(const Axes& axes)
{
	const int sides[3] = {intOf(axes[0].size()), intOf(axes[1].size()), intOf(axes[2].size())};
	if (std::ranges::all_of(axes, isEven))
	{
		auto image = vtkSmartPointer<vtkImageData>::New();
		image->SetDimensions(sides);
		image->SetOrigin(axes[0][0], axes[1][0], axes[2][0]);
		image->SetSpacing(axes[0][1] - axes[0][0], axes[1][1] - axes[1][0], axes[2][1] - axes[2][0]);
		return image;
	}
	auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
	grid->SetDimensions(sides);
	grid->SetXCoordinates(arrayOfPlaces(axes[0]));
	grid->SetYCoordinates(arrayOfPlaces(axes[1]));
	grid->SetZCoordinates(arrayOfPlaces(axes[2]));
	return grid;
}

// Places in a plane, rows along x; and which of them may be corners of a cell.
struct Plane
{
	std::size_t width = 0;
	std::vector<double> x, y;
	std::vector<bool> is_sound;
};

// `heights`: of the layers, or of all points.
vtkSmartPointer<vtkDataSet> bentGrid(const Plane& plane, const std::vector<double>& heights, std::size_t layers)
{
	const std::size_t rows = plane.x.size() / plane.width;
	auto points = vtkSmartPointer<vtkPoints>::New();
	points->SetDataTypeToDouble();
	points->SetNumberOfPoints(static_cast<vtkIdType>(plane.x.size() * layers));
	vtkIdType p = 0;
	for (std::size_t k = 0; k < layers; ++k)
		for (std::size_t i = 0; i < plane.x.size(); ++i)
		{
			const double z = heights[heights.size() == layers ? k : static_cast<std::size_t>(p)];
			points->SetPoint(p++, plane.x[i], plane.y[i], z);
		}
	auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
	grid->SetDimensions(intOf(plane.width), intOf(rows), intOf(layers));
	grid->SetPoints(points);
	if (std::ranges::all_of(plane.is_sound, [](bool sound) { return sound; }))
		return grid;
	vtkNew<vtkUnsignedCharArray> marks;
	marks->SetName(vtkDataSetAttributes::GhostArrayName());
	for (std::size_t k = 0; k + 1 < layers; ++k)
		for (std::size_t j = 0; j + 1 < rows; ++j)
			for (std::size_t i = 0; i + 1 < plane.width; ++i)
			{
				const std::size_t low = i + plane.width * j, high = low + plane.width;
				const bool is_sound =
				    plane.is_sound[low] && plane.is_sound[low + 1] && plane.is_sound[high] && plane.is_sound[high + 1];
				marks->InsertNextValue(is_sound ? 0 : vtkDataSetAttributes::HIDDENCELL);
			}
	grid->GetCellData()->AddArray(marks);
	return grid;
}

// Corners of cells that the file lists for each cell, as the points of a grid: in either sense around the cell. Nothing
// where cells do not share their corners.
std::vector<double> sharedCorners(const std::vector<double>& corners, std::size_t width, std::size_t rows, bool is_left,
                                  bool turns)
{
	constexpr int right[4] = {0, 1, 3, 2}; // for the corners at (0, 0), (1, 0), (0, 1), (1, 1)
	constexpr int left[4] = {0, 3, 1, 2};
	std::vector<double> points((width + 1) * (rows + 1), NAN);
	double widest = 0.0;
	for (const double corner : corners)
		if (std::isfinite(corner))
			widest = std::max(widest, std::abs(corner));
	for (std::size_t j = 0; j < rows; ++j)
		for (std::size_t i = 0; i < width; ++i)
			for (std::size_t c = 0; c < 4; ++c)
			{
				const int from = is_left ? left[c] : right[c];
				const double corner = corners[(j * width + i) * 4 + static_cast<std::size_t>(from)];
				double& point = points[(j + c / 2) * (width + 1) + i + c % 2];
				const double off = std::abs(turns ? std::remainder(corner - point, 360.0) : corner - point);
				if (off > 1e-5 * widest)
					return {};
				if (std::isnan(point))
					point = corner;
			}
	return points;
}

int boundsOf(const hdf5::NetcdfFile& file, int variable)
{
	const std::string name = file.text(variable, "bounds");
	return name.empty() ? -1 : file.variable(name.c_str());
}

std::optional<Plane> planeOfCorners(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step)
{
	const int x = boundsOf(file, volumes.x_places), y = boundsOf(file, volumes.y_places);
	const auto isOfFour = [&](int variable)
	{
		if (variable < 0 || cfTypeOf(file, variable) == 0)
			return false;
		const auto sides = file.dimensions(variable);
		return sides.size() >= 3 && sides.back().second == 4 && sides.back().first != volumes.axes[0].name &&
		       sides.back().first != volumes.axes[1].name;
	};
	if (!isOfFour(x) || !isOfFour(y))
		return std::nullopt;
	const std::vector<double> of_x = cfPlane(file, volumes, x, step, 4), of_y = cfPlane(file, volumes, y, step, 4);
	const std::size_t width = volumes.axes[0].length, rows = volumes.axes[1].length;
	const bool turns = isLongitude(file, volumes.x_places);
	for (const bool is_left : {false, true})
	{
		Plane plane{width + 1,
		            sharedCorners(of_x, width, rows, is_left, turns),
		            sharedCorners(of_y, width, rows, is_left, false),
		            {}};
		if (!plane.x.empty() && !plane.y.empty())
			return plane;
	}
	return std::nullopt;
}

// Between layers, and as far beyond the outer ones; or where the file says.
std::vector<double> bordersAlong(const hdf5::NetcdfFile& file, const CfDimension& axis,
                                 const std::vector<double>& places)
{
	const std::size_t n = places.size();
	std::vector<double> borders(n + 1);
	borders[0] = 1.5 * places[0] - 0.5 * places[1];
	borders[n] = 1.5 * places[n - 1] - 0.5 * places[n - 2];
	for (std::size_t i = 1; i < n; ++i)
		borders[i] = 0.5 * (places[i - 1] + places[i]);
	const int variable = axis.coordinate < 0 ? -1 : boundsOf(file, axis.coordinate);
	if (variable < 0 || cfTypeOf(file, variable) == 0)
		return borders;
	std::vector<double> pairs = cfNumbers(file, variable);
	if (pairs.size() != 2 * n)
		return borders;
	turnUp(file, axis.coordinate, pairs);
	if ((pairs[0] < pairs[1]) != (places[0] < places[1]))
		for (std::size_t i = 0; i < n; ++i)
			std::swap(pairs[2 * i], pairs[2 * i + 1]);
	for (std::size_t i = 0; i + 1 < n; ++i)
		if (!(std::abs(pairs[2 * i + 1] - pairs[2 * i + 2]) <= 1e-5 * std::abs(pairs[2 * i + 1] - pairs[2 * i])))
			return borders;
	for (std::size_t i = 0; i < n; ++i)
		borders[i] = pairs[2 * i];
	borders[n] = pairs[2 * n - 1];
	return borders;
}

} // namespace

std::vector<double> cfPlane(const hdf5::NetcdfFile& file, const CfVolumes& volumes, int variable, std::size_t step,
                            std::size_t corners)
{
	const auto sides = file.dimensions(variable);
	CfSlab slab = CfSlab::of(file, variable);
	bool is_turned = false, has_y = false;
	for (std::size_t i = 0; i < sides.size(); ++i)
	{
		if (volumes.time && sides[i].first == volumes.time->name && sides[i].second > 0)
			slab.fix(i, std::min(step, sides[i].second - 1));
		is_turned = is_turned || (sides[i].first == volumes.axes[0].name && !has_y);
		has_y = has_y || sides[i].first == volumes.axes[1].name;
	}
	const std::vector<double> stored = cfNumbers(file, variable, slab);
	const std::size_t width = volumes.axes[0].length, rows = volumes.axes[1].length;
	if (stored.size() != width * rows * corners)
		throw damaged(fmt::format("{} places for {} columns and {} rows", stored.size(), width, rows));
	if (!is_turned)
		return stored;
	std::vector<double> turned(stored.size());
	for (std::size_t j = 0; j < rows; ++j)
		for (std::size_t i = 0; i < width; ++i)
			for (std::size_t c = 0; c < corners; ++c)
				turned[(j * width + i) * corners + c] = stored[(i * rows + j) * corners + c];
	return turned;
}

namespace
{

vtkSmartPointer<vtkDataSet> gridOfPlaces(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step,
                                         const std::vector<double>* of_columns, bool& has_cells)
{
	std::vector<double> heights = of_columns ? *of_columns : placesAlong(file, volumes.axes[2]);
	const std::size_t layers = volumes.axes[2].length;
	if (!of_columns)
		refuseFolded(heights, volumes.axes[2].name);
	if (volumes.x_places >= 0)
	{
		std::optional<Plane> plane = of_columns ? std::nullopt : planeOfCorners(file, volumes, step);
		has_cells = plane.has_value();
		if (plane)
			heights = bordersAlong(file, volumes.axes[2], heights);
		else
			plane = Plane{volumes.axes[0].length,
			              cfPlane(file, volumes, volumes.x_places, step, 1),
			              cfPlane(file, volumes, volumes.y_places, step, 1),
			              {}};
		if (isLongitude(file, volumes.x_places))
			plane->is_sound = unwrapLongitudes(plane->x, plane->width);
		return bentGrid(*plane, heights, has_cells ? heights.size() : layers);
	}
	Axes axes = {placesAlong(file, volumes.axes[0]), placesAlong(file, volumes.axes[1]), std::move(heights)};
	for (std::size_t axis = 0; axis < 2; ++axis)
		refuseFolded(axes[axis], volumes.axes[axis].name);
	if (!of_columns && std::ranges::all_of(axes, [](const auto& axis) { return std::ranges::all_of(axis, isFinite); }))
		return straightGrid(axes);
	Plane plane{axes[0].size(), {}, {}, {}};
	for (const double y : axes[1])
		for (const double x : axes[0])
		{
			plane.x.push_back(x);
			plane.y.push_back(y);
		}
	return bentGrid(plane, axes[2], layers);
}

void multiply(vtkDataArray* places, int component, double factor)
{
	for (vtkIdType i = 0; i < places->GetNumberOfTuples(); ++i)
		places->SetComponent(i, component, factor * places->GetComponent(i, component));
}

void multiplyAxes(vtkDataSet* data, const std::array<double, 3>& factors)
{
	for (int axis = 0; axis < 3; ++axis)
	{
		const double factor = factors[static_cast<std::size_t>(axis)];
		if (factor == 1.0)
			continue;
		if (auto* image = vtkImageData::SafeDownCast(data))
		{
			std::array<double, 3> origin, spacing;
			image->GetOrigin(origin.data());
			image->GetSpacing(spacing.data());
			origin[static_cast<std::size_t>(axis)] *= factor;
			spacing[static_cast<std::size_t>(axis)] *= factor;
			image->SetOrigin(origin.data());
			image->SetSpacing(spacing.data());
		}
		else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
			multiply(axis == 0   ? grid->GetXCoordinates()
			         : axis == 1 ? grid->GetYCoordinates()
			                     : grid->GetZCoordinates(),
			         0, factor);
		else
			multiply(vtkStructuredGrid::SafeDownCast(data)->GetPoints()->GetData(), axis, factor);
	}
}

// Lengths of one unit along all axes.
void takeUnits(const hdf5::NetcdfFile& file, const CfVolumes& volumes, const CfHeights* heights, CfGrid& grid)
{
	const std::array<int, 3> variables = {volumes.x_places >= 0 ? volumes.x_places : volumes.axes[0].coordinate,
	                                      volumes.y_places >= 0 ? volumes.y_places : volumes.axes[1].coordinate,
	                                      volumes.axes[2].coordinate};
	std::array<std::string, 3> units;
	for (std::size_t axis = 0; axis < 3; ++axis)
		units[axis] = variables[axis] < 0 ? "" : file.text(variables[axis], "units");
	if (heights)
		units[2] = heights->units;
	const text::OneLengthUnit one = text::oneLengthUnit(units);
	if (one.differ && std::ranges::none_of(units, [](const std::string& unit) { return unit.empty(); }))
		grid.notes.push_back(text::unitsDiffer(units));
	if (!one.differ && text::metersOf(one.sign))
		grid.length_units = one.sign;
	multiplyAxes(grid.data, one.factors);
}

} // namespace

CfGrid cfGrid(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step)
{
	CfGrid grid;
	const std::optional<CfHeights> heights = cfHeights(file, volumes, step);
	grid.data = gridOfPlaces(file, volumes, step, heights ? &heights->places : nullptr, grid.has_cell_values);
	takeUnits(file, volumes, heights ? &*heights : nullptr, grid);
	if (const std::string formula = unknownFormula(file, volumes); !formula.empty())
		grid.notes.push_back(fmt::format("its heights by {} are not computed; z is {}", formula, volumes.axes[2].name));
	return grid;
}

} // namespace vp::reader::volumes
