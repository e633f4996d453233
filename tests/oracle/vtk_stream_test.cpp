// Particle traces of published data sets beside vtkStreamTracer's, where both stay in the grid.

#include "locate/place.h"
#include "read/read.h"
#include "vectors/tracer.h"
#include "vectors/vector_array.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamTracer.h>
#include <vtkUnstructuredGrid.h>

#include <cstdlib>
#include <filesystem>
#include <random>

namespace vp::test
{

namespace
{

constexpr int kVtkTypes[] = {VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON};

// The cells of a block, whatever its kind, with its vectors as "w".
vtkNew<vtkUnstructuredGrid> asVtk(const grid::Block& block, const vectors::BlockVectors& vectors)
{
	vtkNew<vtkUnstructuredGrid> made;
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	vtkNew<vtkDoubleArray> array;
	array->SetName("w");
	array->SetNumberOfComponents(3);
	std::visit(
	    [&](const auto& grid)
	    {
		    for (PointId p = 0; p < grid.pointCount(); ++p)
		    {
			    const Vec3 place = grid.point(p);
			    const Vec3 vector = vectors.at(grid.sourcePoint(p));
			    points->InsertNextPoint(&place.x);
			    array->InsertNextTuple(&vector.x);
		    }
		    made->SetPoints(points);
		    for (CellId c = 0; c < grid.cellCount(); ++c)
		    {
			    std::vector<vtkIdType> ids;
			    for (const PointId p : grid.cellPoints(c))
				    ids.push_back(p);
			    made->InsertNextCell(kVtkTypes[static_cast<int>(grid.shape(c))], static_cast<vtkIdType>(ids.size()),
			                         ids.data());
		    }
	    },
	    block.grid);
	made->GetPointData()->AddArray(array);
	return made;
}

// Middles of cells here and there, where something moves.
std::vector<vectors::Launch> launchesIn(const grid::Block& block, const vectors::BlockVectors& vectors)
{
	std::vector<vectors::Launch> launches;
	std::mt19937 random(5);
	std::visit(
	    [&](const auto& grid)
	    {
		    std::uniform_int_distribution<CellId> any(0, static_cast<CellId>(grid.cellCount() - 1));
		    while (launches.size() < 60)
		    {
			    const CellId cell = any(random);
			    double least = HUGE_VAL;
			    for (const PointId p : grid.cellPoints(cell))
				    least = std::min(least, glm::length(vectors.at(grid.sourcePoint(p))));
			    if (least > 0.0)
				    launches.push_back({grid::cellCenter(grid, cell), 0, cell, 0});
		    }
	    },
	    block.grid);
	return launches;
}

double speedAt(const grid::BlockSet& blocks, const Vec3& point, const vectors::BlockVectors& vectors)
{
	locate::PlaceFinder finder(blocks);
	const locate::CellWeights& weights = finder.find(point).weights;
	Vec3 vector(0.0);
	for (std::size_t i = 0; i < weights.points.size(); ++i)
		vector += weights.weights[i] * std::visit([&](const auto& grid)
		                                          { return vectors.at(grid.sourcePoint(weights.points[i])); },
		                                          blocks.blocks[0].grid);
	return glm::length(vector);
}

vtkSmartPointer<vtkPolyData> tracedByVtk(vtkUnstructuredGrid* grid, const Vec3& from, double speed, double length)
{
	vtkNew<vtkStreamTracer> tracer;
	tracer->SetInputData(grid);
	tracer->SetStartPosition(from.x, from.y, from.z);
	tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "w");
	tracer->SetIntegratorTypeToRungeKutta45();
	tracer->SetIntegrationDirectionToForward();
	tracer->SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
	tracer->SetInitialIntegrationStep(0.005);
	tracer->SetMinimumIntegrationStep(1e-4);
	tracer->SetMaximumIntegrationStep(0.01);
	tracer->SetMaximumError(1e-9);
	tracer->SetMaximumNumberOfSteps(100'000);
	// If vectors converge, VTK's steps, which have a least length, go back and forth.
	tracer->SetTerminalSpeed(0.1 * speed);
	tracer->SetMaximumPropagation(length);
	tracer->SetComputeVorticity(false);
	tracer->Update();
	return tracer->GetOutput();
}

// A path by the way along it. Steps of VTK's are even in length, and the times that it tells with them are off by part
// of one, so that places at equal times would differ in proportion to its steps.
class Way
{
public:
	void add(const Vec3& place)
	{
		length_.push_back(places_.empty() ? 0.0 : length_.back() + glm::length(place - places_.back()));
		places_.push_back(place);
	}
	double length() const { return length_.back(); }
	Vec3 at(double length) const
	{
		const auto next = std::ranges::upper_bound(length_, length) - length_.begin();
		if (next == std::ssize(length_))
			return places_.back();
		const double part = (length - length_[next - 1]) / (length_[next] - length_[next - 1]);
		return glm::mix(places_[next - 1], places_[next], part);
	}

private:
	std::vector<Vec3> places_;
	std::vector<double> length_;
};

Way wayOf(vtkPolyData* path)
{
	Way way;
	for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
	{
		Vec3 place;
		path->GetPoint(i, &place.x);
		way.add(place);
	}
	return way;
}

Way wayOf(const vectors::Traces& traces)
{
	Way way;
	for (const Vec3& place : traces.path(0))
		way.add(place);
	return way;
}

// The farthest that two particles are apart when they have come as far, over how far they have come.
double worstDeviation(const Way& a, const Way& b)
{
	const double both = std::min(a.length(), b.length());
	constexpr int kPlaces = 100;
	double worst = 0.0;
	for (int i = 1; i <= kPlaces; ++i)
	{
		const double length = both * i / kPlaces;
		worst = std::max(worst, glm::length(a.at(length) - b.at(length)) / length);
	}
	return worst;
}

void compareTraces(const char* file, const char* array)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	const std::string path = (std::filesystem::path(data) / file).string();
	if (!std::filesystem::exists(path))
		GTEST_SKIP() << path << " is not there";
	const grid::BlockSet blocks = read::readInputs({path}, {}, nullptr).value();
	const grid::FieldChoice choice = vectors::chooseVectors(blocks, array).value();
	const grid::Block& block = blocks.blocks[0];
	const vectors::BlockVectors values(choice.in(block));
	const vtkNew<vtkUnstructuredGrid> grid = asVtk(block, values);
	int compared = 0;
	for (const vectors::Launch& launch : launchesIn(block, values))
	{
		const auto traced =
		    tracedByVtk(grid, launch.position, speedAt(blocks, launch.position, values), 0.3 * block.bounds.diagonal());
		const vtkIdType last = traced->GetNumberOfPoints() - 1;
		const Way theirs = wayOf(traced);
		if (last < 10)
			continue;
		vectors::TraceOptions options;
		options.steps = 1000.0;
		options.dt = traced->GetPointData()->GetArray("IntegrationTime")->GetTuple1(last) / options.steps;
		const vectors::Traces traces = vectors::trace(blocks, choice, std::span(&launch, 1), options).value();
		const Way ours = wayOf(traces);
		++compared;
		EXPECT_LT(worstDeviation(ours, theirs), 0.01) << launch.cell;
		// VTK ends a little before the boundary.
		EXPECT_GT(ours.length(), 0.97 * theirs.length()) << launch.cell;
	}
	EXPECT_GT(compared, 40);
}

} // namespace

TEST(VtkStreamTracer, Bluntfin)
{
	compareTraces("structured/bluntfin/bluntfinxyz.bin", "");
}

TEST(VtkStreamTracer, DiskOutRef)
{
	compareTraces("unstructured/disk_out_ref/disk_out_ref.ex2", "");
}

TEST(VtkStreamTracer, Carotid)
{
	compareTraces("uniform/carotid/carotid.vtk", "");
}

} // namespace vp::test
