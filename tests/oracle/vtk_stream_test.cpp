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
			    points->InsertNextPoint(&grid.point(p).x);
			    array->InsertNextTuple(&vectors.at(grid.sourcePoint(p)).x);
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
				    launches.push_back({grid::cellCentre(grid, cell), 0, cell, 0});
		    }
	    },
	    block.grid);
	return launches;
}

vtkSmartPointer<vtkPolyData> tracedByVtk(vtkUnstructuredGrid* grid, const Vec3& from, double length)
{
	vtkNew<vtkStreamTracer> tracer;
	tracer->SetInputData(grid);
	tracer->SetStartPosition(from.x, from.y, from.z);
	tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "w");
	tracer->SetIntegratorTypeToRungeKutta45();
	tracer->SetIntegrationDirectionToForward();
	tracer->SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
	tracer->SetInitialIntegrationStep(0.02);
	tracer->SetMinimumIntegrationStep(1e-4);
	tracer->SetMaximumIntegrationStep(0.05);
	tracer->SetMaximumError(1e-9);
	tracer->SetMaximumNumberOfSteps(20'000);
	tracer->SetMaximumPropagation(length);
	tracer->SetComputeVorticity(false);
	tracer->Update();
	return tracer->GetOutput();
}

double lengthOf(std::span<const Vec3> path)
{
	double length = 0.0;
	for (std::size_t i = 1; i < path.size(); ++i)
		length += glm::length(path[i] - path[i - 1]);
	return length;
}

// The farthest of our points within VTK's times from VTK's line, over how far the particle has come.
double worstDeviation(const vectors::Traces& ours, vtkPolyData* theirs)
{
	vtkDataArray* times = theirs->GetPointData()->GetArray("IntegrationTime");
	const vtkIdType count = theirs->GetNumberOfPoints();
	vtkIdType at = 0;
	double worst = 0.0;
	double way = 0.0;
	for (std::size_t i = 1; i < ours.points.size(); ++i)
	{
		way += glm::length(ours.points[i] - ours.points[i - 1]);
		while (at + 1 < count && times->GetTuple1(at + 1) < ours.times[i])
			++at;
		if (at + 1 >= count)
			break;
		const double begin = times->GetTuple1(at);
		const double part = (ours.times[i] - begin) / (times->GetTuple1(at + 1) - begin);
		Vec3 a;
		Vec3 b;
		theirs->GetPoint(at, &a.x);
		theirs->GetPoint(at + 1, &b.x);
		worst = std::max(worst, glm::length(glm::mix(a, b, part) - ours.points[i]) / way);
	}
	return worst;
}

void compare(const char* file, const char* array)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA names no folder of data sets";
	const std::string path = (std::filesystem::path(data) / file).string();
	if (!std::filesystem::exists(path))
		GTEST_SKIP() << path << " is not there";
	const grid::BlockSet blocks = read::readInputs({path}, {}, nullptr).value();
	const slice::FieldChoice choice = vectors::chooseVectors(blocks, array).value();
	const grid::Block& block = blocks.blocks[0];
	const vectors::BlockVectors values(choice.in(block));
	const vtkNew<vtkUnstructuredGrid> grid = asVtk(block, values);
	const double length = 0.3 * block.bounds.diagonal();
	int agree = 0;
	int compared = 0;
	for (const vectors::Launch& launch : launchesIn(block, values))
	{
		const auto theirs = tracedByVtk(grid, launch.position, length);
		if (theirs->GetNumberOfPoints() < 10)
			continue;
		const double time =
		    theirs->GetPointData()->GetArray("IntegrationTime")->GetTuple1(theirs->GetNumberOfPoints() - 1);
		vectors::TraceOptions options;
		options.steps = 100.0;
		options.dt = time / options.steps;
		const vectors::Traces ours = vectors::trace(blocks, choice, std::span(&launch, 1), options).value();
		++compared;
		const double worst = worstDeviation(ours, theirs);
		agree += worst < 0.01;
		if (worst >= 0.01)
			std::printf("%s %g: %g of %g, %s, n %zu cell %u at %g %g %g\n", file, worst, lengthOf(ours.path(0)), length,
			            vectors::traceEndWord(ours.ends[0]), ours.points.size(), launch.cell, launch.position.x, launch.position.y, launch.position.z);
	}
	std::printf("%d of %d\n", agree, compared);
	EXPECT_GT(compared, 40);
	EXPECT_EQ(agree, compared);
}

} // namespace

TEST(VtkStreamTracer, Bluntfin)
{
	compare("structured/bluntfin/bluntfinxyz.bin", "");
}

TEST(VtkStreamTracer, DiskOutRef)
{
	compare("unstructured/disk_out_ref/disk_out_ref.ex2", "");
}

TEST(VtkStreamTracer, Carotid)
{
	compare("uniform/carotid/carotid.vtk", "");
}

} // namespace vp::test
