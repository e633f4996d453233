// A small simulation on several ranks: hexahedra that stay where they are, with a new field at each step. Catalyst runs
// a script on them, step by step. usage: steps SCRIPT STEPS
#include <vtkCPDataDescription.h>
#include <vtkCPInputDataDescription.h>
#include <vtkCPProcessor.h>
#include <vtkCPPythonPipeline.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPythonInterpreter.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{

constexpr int kCells = 24; // along an edge of a rank's cube

// The cube of a rank, beside those of the others.
vtkSmartPointer<vtkUnstructuredGrid> cubeOf(int rank)
{
	constexpr int n = kCells + 1;
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	for (int k = 0; k < n; ++k)
		for (int j = 0; j < n; ++j)
			for (int i = 0; i < n; ++i)
				points->InsertNextPoint(rank + double(i) / kCells, double(j) / kCells, double(k) / kCells);
	grid->SetPoints(points);
	for (vtkIdType k = 0; k < kCells; ++k)
		for (vtkIdType j = 0; j < kCells; ++j)
			for (vtkIdType i = 0; i < kCells; ++i)
			{
				const vtkIdType low = (k * n + j) * n + i, high = low + n * n;
				const vtkIdType corners[] = {low,  low + 1,  low + n + 1,  low + n,
				                             high, high + 1, high + n + 1, high + n};
				grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
			}
	return grid;
}

void setField(vtkUnstructuredGrid& grid, double time)
{
	vtkNew<vtkDoubleArray> heat;
	heat->SetName("heat");
	for (vtkIdType p = 0; p < grid.GetNumberOfPoints(); ++p)
	{
		const double* at = grid.GetPoint(p);
		heat->InsertNextValue(std::sin(3.0 * at[0] - time) + at[1] * at[2]);
	}
	grid.GetPointData()->SetScalars(heat);
}

bool run(const char* script, int steps)
{
	int rank = 0;
	MPI_Comm_rank(MPI_COMM_WORLD, &rank);
	// Debian's VTK puts the system's Python packages first. Those that PYTHONPATH names have to be found before them.
	vtkPythonInterpreter::RunSimpleString(
	    "import os, sys; sys.path[:0] = os.environ.get('PYTHONPATH', '').split(':'); import vtkmodules, paraview");
	vtkNew<vtkCPProcessor> processor;
	if (!processor->Initialize())
		return false;
	const vtkSmartPointer<vtkCPPythonPipeline> pipeline = vtkCPPythonPipeline::CreateAndInitializePipeline(script, 2);
	if (!pipeline)
		return false;
	processor->AddPipeline(pipeline);
	const vtkSmartPointer<vtkUnstructuredGrid> grid = cubeOf(rank);
	bool is_well = true;
	for (int step = 0; step < steps; ++step)
	{
		const double time = 0.2 * step;
		vtkNew<vtkCPDataDescription> data;
		data->AddInput("cubes");
		data->SetTimeData(time, static_cast<vtkIdType>(step));
		data->ForceOutputOn();
		if (!processor->RequestDataDescription(data))
			continue;
		setField(*grid, time);
		data->GetInputDescriptionByName("cubes")->SetGrid(grid);
		is_well = processor->CoProcess(data) && is_well;
	}
	processor->Finalize();
	return is_well;
}

} // namespace

int main(int count, char** words)
{
	if (count != 3)
		return std::fprintf(stderr, "usage: steps SCRIPT STEPS\n"), 1;
	MPI_Init(&count, &words);
	const bool is_well = run(words[1], std::atoi(words[2]));
	MPI_Finalize();
	return is_well ? 0 : 1;
}
