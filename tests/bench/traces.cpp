#include "traces.h"

#include "cut/cutter.h"
#include "grids.h"
#include "vectors/tracer.h"
#include "vectors/vector_array.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamTracer.h>

#include <cmath>
#include <string>
#include <vector>

namespace vp::bench
{

namespace
{

constexpr std::size_t kParticles = 10'000;
constexpr int kSteps = 200;
constexpr double kTimeStep = 0.01;
constexpr double kCellStep = 0.3;

const std::vector<vectors::Launch>& launchesOn(const std::string& name)
{
	static std::string of;
	static std::vector<vectors::Launch> launches;
	if (of == name)
		return launches;
	of = name;
	launches.clear();
	cut::Cutter cutter(gridNamed(name));
	cut::CutRequest request;
	request.in_generations = true;
	constexpr double kLongitude = 0.3;
	request.probe.sheets = {
	    probe::makeSheet(Vec3(0.0), Vec3(-std::sin(kLongitude), std::cos(kLongitude), 0.0), Vec3(0.0, 0.0, 1.0))};
	const cut::Cut cut = std::move(*cutter.cut(std::move(request)));
	const mesh::SheetMesh mesh = cut.mesh(cutter.blocks(), 0);
	for (int along = 150; launches.size() < kParticles; along += 10)
		launches = vectors::launchLattice(mesh, cut.sheets[0].sheet, {along, 0.0}).launches;
	launches.resize(kParticles);
	return launches;
}

} // namespace

void ourTraces(benchmark::State& state, const std::string& name)
{
	const grid::BlockSet& blocks = gridNamed(name);
	const std::vector<vectors::Launch>& launches = launchesOn(name);
	vectors::TraceOptions options;
	options.steps = kSteps;
	options.dt = kTimeStep;
	std::size_t points = 0;
	for (auto _ : state)
		points = vectors::trace(blocks, *vectors::chooseVectors(blocks, "v"), launches, options)->points.size();
	state.counters["points"] = static_cast<double>(points);
}

void vtkTraces(benchmark::State& state, const std::string& name)
{
	vtkDataSet* grid = vtkNamed(name);
	if (!grid->GetPointData()->GetArray("v"))
	{
		const grid::Block& block = gridNamed(name).blocks[0];
		const grid::FieldChoice choice = *vectors::chooseVectors(gridNamed(name), "v");
		const vectors::BlockVectors vectors(choice.in(block));
		vtkNew<vtkFloatArray> array;
		array->SetName("v");
		array->SetNumberOfComponents(3);
		array->SetNumberOfTuples(grid->GetNumberOfPoints());
		for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
		{
			const Vec3 v = vectors.at(static_cast<std::size_t>(p));
			array->SetTuple3(p, v.x, v.y, v.z);
		}
		grid->GetPointData()->AddArray(array);
	}
	vtkNew<vtkPoints> places;
	places->SetDataTypeToDouble();
	for (const vectors::Launch& launch : launchesOn(name))
		places->InsertNextPoint(launch.position.x, launch.position.y, launch.position.z);
	vtkNew<vtkPolyData> seeds;
	seeds->SetPoints(places);
	vtkNew<vtkPoints> first;
	first->InsertNextPoint(places->GetPoint(0));
	vtkNew<vtkPolyData> one;
	one->SetPoints(first);
	vtkNew<vtkStreamTracer> tracer;
	tracer->SetInputData(grid);
	tracer->SetSourceData(one);
	tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "v");
	tracer->SetIntegratorTypeToRungeKutta45();
	tracer->SetIntegrationDirectionToForward();
	tracer->SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
	tracer->SetInitialIntegrationStep(kCellStep);
	tracer->SetMaximumIntegrationStep(kCellStep);
	tracer->SetMaximumNumberOfSteps(kSteps);
	tracer->SetMaximumPropagation(1e6);
	tracer->SetComputeVorticity(false);
	tracer->Update(); // builds its search structure, which the grid keeps
	tracer->SetSourceData(seeds);
	for (auto _ : state)
	{
		tracer->Modified();
		tracer->Update();
	}
	state.counters["points"] = static_cast<double>(tracer->GetOutput()->GetNumberOfPoints());
}

} // namespace vp::bench
