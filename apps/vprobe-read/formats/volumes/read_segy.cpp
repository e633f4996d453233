// SEG-Y, revisions 0 to 2, by a parser of our own: VTK's knows neither missing traces nor traces in another order.
#include "segy_file.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::reader::volumes
{

namespace
{

// Numbers of lines, ascending and each once.
class LineNumbers
{
public:
	LineNumbers(const SegyFile& file, int SegyTrace::*line)
	{
		for (std::size_t t = 0; t < file.traceCount(); ++t)
			numbers_.push_back(file.trace(t).*line);
		std::sort(numbers_.begin(), numbers_.end());
		numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
	}
	std::size_t count() const { return numbers_.size(); }
	const std::vector<int>& numbers() const { return numbers_; }
	std::size_t indexOf(int number) const
	{
		return static_cast<std::size_t>(std::lower_bound(numbers_.begin(), numbers_.end(), number) - numbers_.begin());
	}

private:
	std::vector<int> numbers_;
};

// The traces by crossline, which runs fastest, and inline. kNoTrace where the file has none.
constexpr std::size_t kNoTrace = ~std::size_t(0);

struct SegySurvey
{
	std::size_t inlines;
	std::size_t crosslines;
	std::vector<std::size_t> traces;
	std::size_t missing = 0;
	std::vector<int> inline_numbers{};
	std::vector<int> crossline_numbers{};

	// By the numbers of its lines.
	std::array<double, 2> numbersOf(std::size_t n) const
	{
		return {double(inline_numbers[n / crosslines]), double(crossline_numbers[n % crosslines])};
	}
};

SegySurvey arrangeTraces(const SegyFile& file)
{
	const LineNumbers inlines(file, &SegyTrace::in_line);
	const LineNumbers crosslines(file, &SegyTrace::cross_line);
	if (inlines.count() < 2 || crosslines.count() < 2)
		throw Refusal("nothing to slice: its traces are all of one line");
	// Numbers that are no grid would fill the memory.
	if (inlines.count() > 16 * file.traceCount() / crosslines.count())
		throw Refusal("the numbers of its inlines and crosslines (bytes 189 and 193 of a trace) make no grid");
	SegySurvey survey{inlines.count(), crosslines.count(), {}};
	survey.traces.assign(survey.inlines * survey.crosslines, kNoTrace);
	for (std::size_t t = 0; t < file.traceCount(); ++t)
	{
		const SegyTrace trace = file.trace(t);
		std::size_t& place =
		    survey.traces[inlines.indexOf(trace.in_line) * survey.crosslines + crosslines.indexOf(trace.cross_line)];
		if (place != kNoTrace)
			throw Refusal(fmt::format("several traces at inline {}, crossline {}; stack them first", trace.in_line,
			                          trace.cross_line));
		place = t;
	}
	survey.missing = survey.traces.size() - file.traceCount();
	survey.inline_numbers = inlines.numbers();
	survey.crossline_numbers = crosslines.numbers();
	return survey;
}

// Where traces that are missing would be: the plane that fits the others best.
class SegyPlane
{
public:
	SegyPlane(const SegyFile& file, const SegySurvey& survey)
	{
		glm::dmat3 sums(0.0);
		glm::dvec3 x(0.0), y(0.0);
		for (std::size_t n = 0; n < survey.traces.size(); ++n)
			if (survey.traces[n] != kNoTrace)
			{
				const SegyTrace trace = file.trace(survey.traces[n]);
				const glm::dvec3 line = lineOf(n, survey);
				sums += glm::outerProduct(line, line);
				x += trace.x * line;
				y += trace.y * line;
			}
		const glm::dmat3 inverse = glm::inverse(sums);
		x_ = inverse * x;
		y_ = inverse * y;
	}
	// Whether the traces lie on a line, or in one place: so it is where a file has no coordinates.
	bool isFlat() const
	{
		const double area = x_.y * y_.z - x_.z * y_.y;
		return !(std::abs(area) > 1e-9 * std::hypot(x_.y, y_.y) * std::hypot(x_.z, y_.z));
	}
	std::array<double, 2> at(std::size_t n, const SegySurvey& survey) const
	{
		const glm::dvec3 line = lineOf(n, survey);
		return {glm::dot(x_, line), glm::dot(y_, line)};
	}

private:
	static glm::dvec3 lineOf(std::size_t n, const SegySurvey& survey)
	{
		return {1.0, n % survey.crosslines, n / survey.crosslines};
	}

	glm::dvec3 x_;
	glm::dvec3 y_;
};

vtkSmartPointer<vtkStructuredGrid> segyGrid(const SegyFile& file, const SegySurvey& survey, const SegyPlane& plane)
{
	const bool by_numbers = plane.isFlat();
	vtkNew<vtkPoints> points;
	const auto values =
	    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(file.isDouble() ? VTK_DOUBLE : VTK_FLOAT));
	vtkNew<vtkUnsignedCharArray> marks;
	const auto columns = static_cast<vtkIdType>(survey.traces.size());
	const auto samples = static_cast<vtkIdType>(file.sampleCount());
	points->SetDataTypeToDouble();
	points->SetNumberOfPoints(columns * samples);
	values->SetName("trace");
	values->SetNumberOfTuples(columns * samples);
	marks->SetName(vtkDataSetAttributes::GhostArrayName());
	marks->SetNumberOfTuples(columns * samples);
	for (vtkIdType column = 0; column < columns; ++column)
	{
		const std::size_t index = survey.traces[static_cast<std::size_t>(column)];
		const bool is_here = index != kNoTrace;
		const SegyTrace trace = is_here ? file.trace(index) : SegyTrace{};
		const std::array<double, 2> place = by_numbers ? survey.numbersOf(static_cast<std::size_t>(column))
		                                    : is_here  ? std::array{trace.x, trace.y}
		                                               : plane.at(static_cast<std::size_t>(column), survey);
		for (vtkIdType k = 0; k < samples; ++k)
		{
			// The time of the last sample is the least z: down in the ground.
			const vtkIdType point = (samples - 1 - k) * columns + column;
			const double depth = trace.delay + file.interval() * static_cast<double>(k);
			points->SetPoint(point, place[0], place[1], 0.0 - depth);
			values->SetTuple1(point, is_here ? file.sample(index, static_cast<std::size_t>(k))
			                                 : std::numeric_limits<double>::quiet_NaN());
			marks->SetValue(point, is_here ? 0 : vtkDataSetAttributes::HIDDENPOINT);
		}
	}
	auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
	grid->SetDimensions(static_cast<int>(survey.crosslines), static_cast<int>(survey.inlines),
	                    static_cast<int>(samples));
	grid->SetPoints(points);
	grid->GetPointData()->SetScalars(values);
	if (survey.missing > 0)
		grid->GetPointData()->AddArray(marks);
	return grid;
}

} // namespace

void readSegy(const Request& request, manifest::Writer& manifest)
{
	const MappedText mapped(request.file);
	const SegyFile file(mapped.text());
	const SegySurvey survey = arrangeTraces(file);
	if (survey.missing > 0)
		manifest.warn(fmt::format("{} of {} traces are missing; the cells about them are left out", survey.missing,
		                          survey.traces.size()));
	const SegyPlane plane(file, survey);
	if (plane.isFlat())
		manifest.warn(
		    "its traces have no coordinates (bytes 181 and 73), or all on one line; x is the inline and y the "
		    "crossline");
	if (!file.note().empty())
		manifest.warn(file.note());
	manifest.add(segyGrid(file, survey, plane));
}

} // namespace vp::reader::volumes
