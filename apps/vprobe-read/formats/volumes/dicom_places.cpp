#include "dicom_places.h"

#include "vprobe-read/base/refusal.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vp::reader::volumes
{

namespace
{

using Vector = std::array<double, 3>;

constexpr double kUneven = 0.01; // a part of the distance between two slices

// From the first frame to the last one, which need not be as far apart as they are thick, nor lie straight behind each
// other.
struct LineOfFrames
{
	Vector first;
	Vector step; // from frame to frame, if they are evenly far apart
	double distance;
};

LineOfFrames lineOf(const std::vector<DicomFrame>& frames)
{
	LineOfFrames line{frames.front().origin, {}, 0.0};
	for (std::size_t a = 0; a < 3; ++a)
		line.step[a] = (frames.back().origin[a] - line.first[a]) / static_cast<double>(frames.size() - 1);
	line.distance = std::hypot(line.step[0], line.step[1], line.step[2]);
	return line;
}

double distanceFrom(const Vector& place, const LineOfFrames& line, double steps)
{
	double squares = 0.0;
	for (std::size_t a = 0; a < 3; ++a)
		squares += std::pow(place[a] - line.first[a] - steps * line.step[a], 2);
	return std::sqrt(squares);
}

// Which frame is first off its place; none: past the last one.
std::size_t firstUneven(const std::vector<DicomFrame>& frames, const LineOfFrames& line)
{
	std::size_t f = 0;
	while (f < frames.size() && distanceFrom(frames[f].origin, line, static_cast<double>(f)) <= kUneven * line.distance)
		++f;
	return f;
}

void refuseOffLine(const std::vector<DicomFrame>& frames, const LineOfFrames& line)
{
	const double depth = frames.back().depth() - frames.front().depth();
	for (const DicomFrame& frame : frames)
	{
		const double steps = (frame.depth() - frames.front().depth()) / depth * static_cast<double>(frames.size() - 1);
		if (distanceFrom(frame.origin, line, steps) > kUneven * line.distance)
			throw Refusal("its frames do not lie behind each other on a straight line");
	}
}

vtkSmartPointer<vtkDataSet> evenGrid(const DicomFrame& first, const LineOfFrames& line)
{
	std::array<double, 9> direction;
	for (std::size_t row = 0; row < 3; ++row)
	{
		direction[3 * row] = first.axes[row];
		direction[3 * row + 1] = first.axes[3 + row];
		direction[3 * row + 2] = line.step[row] / line.distance;
	}
	auto image = vtkSmartPointer<vtkImageData>::New();
	image->SetOrigin(line.first.data());
	image->SetSpacing(first.spacing[0], first.spacing[1], line.distance);
	image->SetDirectionMatrix(direction.data());
	return image;
}

bool isAlongAxes(const DicomFrame& first, const LineOfFrames& line)
{
	return first.axes == std::array<double, 6>{1, 0, 0, 0, 1, 0} && line.step[0] == 0.0 && line.step[1] == 0.0;
}

vtkSmartPointer<vtkDataSet> rectilinearGrid(const std::vector<DicomFrame>& frames)
{
	const DicomFrame& first = frames[0];
	std::array<vtkNew<vtkDoubleArray>, 3> places;
	const std::array<std::uint32_t, 2> sides = {first.form.columns, first.form.rows};
	for (std::size_t a = 0; a < 2; ++a)
		for (std::uint32_t i = 0; i < sides[a]; ++i)
			places[a]->InsertNextValue(first.origin[a] + i * first.spacing[a]);
	for (const DicomFrame& frame : frames)
		places[2]->InsertNextValue(frame.origin[2]);
	auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
	grid->SetXCoordinates(places[0]);
	grid->SetYCoordinates(places[1]);
	grid->SetZCoordinates(places[2]);
	return grid;
}

vtkSmartPointer<vtkDataSet> curvilinearGrid(const std::vector<DicomFrame>& frames)
{
	const DicomFrame& first = frames[0];
	vtkNew<vtkDoubleArray> places;
	places->SetNumberOfComponents(3);
	places->SetNumberOfTuples(static_cast<vtkIdType>(frames.size() * first.form.columns * first.form.rows));
	vtkIdType point = 0;
	for (const DicomFrame& frame : frames)
		for (std::uint32_t j = 0; j < first.form.rows; ++j)
			for (std::uint32_t i = 0; i < first.form.columns; ++i, ++point)
				for (std::size_t a = 0; a < 3; ++a)
					places->SetComponent(point, static_cast<int>(a),
					                     frame.origin[a] + i * first.spacing[0] * first.axes[a] +
					                         j * first.spacing[1] * first.axes[3 + a]);
	vtkNew<vtkPoints> points;
	points->SetData(places);
	auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
	grid->SetPoints(points);
	return grid;
}

template <class Grid>
void setSides(vtkDataSet* grid, const std::array<int, 3>& sides)
{
	if (auto* of_kind = Grid::SafeDownCast(grid))
		of_kind->SetDimensions(sides[0], sides[1], sides[2]);
}

} // namespace

vtkSmartPointer<vtkDataSet> gridOfFrames(const std::vector<DicomFrame>& frames)
{
	const DicomFrame& first = frames[0];
	const LineOfFrames line = lineOf(frames);
	for (const double spacing : {first.spacing[0], first.spacing[1], line.distance})
		if (!std::isfinite(spacing) || spacing <= 0.0)
			throw damaged("its spacings make no grid");
	const std::size_t uneven = firstUneven(frames, line);
	const bool is_of_files = frames.front().file != frames.back().file;
	if (uneven < frames.size() && is_of_files)
		throw Refusal(fmt::format("{} is not as far from its neighbors as the other slices; a slice is missing, or the "
		                          "series has several parts",
		                          std::filesystem::path(frames[uneven].file).filename().string()));
	vtkSmartPointer<vtkDataSet> grid;
	if (uneven == frames.size())
		grid = evenGrid(first, line);
	else
	{
		refuseOffLine(frames, line);
		grid = isAlongAxes(first, line) ? rectilinearGrid(frames) : curvilinearGrid(frames);
	}
	const std::array<int, 3> sides = {static_cast<int>(first.form.columns), static_cast<int>(first.form.rows),
	                                  static_cast<int>(frames.size())};
	setSides<vtkImageData>(grid, sides);
	setSides<vtkRectilinearGrid>(grid, sides);
	setSides<vtkStructuredGrid>(grid, sides);
	return grid;
}

} // namespace vp::reader::volumes
