#include "grids.h"

#include "grid/demo/demo.h"
#include "probe/path.h"
#include "vtk_cuts.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

namespace vp::bench
{

namespace
{

struct Grid
{
	std::string name;
	grid::BlockSet blocks;
	vtkSmartPointer<vtkDataSet> vtk;
};

// The points of a curvilinear grid with axis `first` running fastest, and the others after it in turn.
grid::CurvilinearGrid withFirstAxis(const grid::CurvilinearGrid& grid, int first)
{
	const std::array<std::uint32_t, 3> points = {grid.points()[first], grid.points()[(first + 1) % 3],
	                                             grid.points()[(first + 2) % 3]};
	std::vector<float> xyz;
	xyz.reserve(3 * grid.pointCount());
	std::array<std::uint32_t, 3> at{};
	for (at[2] = 0; at[2] < points[2]; ++at[2])
		for (at[1] = 0; at[1] < points[1]; ++at[1])
			for (at[0] = 0; at[0] < points[0]; ++at[0])
			{
				std::array<std::uint32_t, 3> of{};
				for (int a = 0; a < 3; ++a)
					of[(first + a) % 3] = at[a];
				const Vec3 p = grid.pointAt(of[0], of[1], of[2]);
				for (int axis = 0; axis < 3; ++axis)
					xyz.push_back(static_cast<float>(p[axis]));
			}
	return {points, grid::Points(Array<float>(std::move(xyz)))};
}

grid::BlockSet makeGrid(const std::string& name, bool builds_neighbors)
{
	const std::size_t space = name.find(' ');
	grid::BlockSet made = std::move(*grid::parseDemo(name.substr(0, space), builds_neighbors));
	if (space == std::string::npos)
		return made;
	grid::Block& block = made.blocks[0];
	if (name.ends_with(" shuffled"))
	{
		const ReadCells read = readCells(std::get<grid::UnstructuredGrid>(block.grid), true);
		block.grid = grid::UnstructuredGrid::build(read.points, read.cells);
		grid::finishBlock(block);
		return made;
	}
	block.grid = withFirstAxis(std::get<grid::CurvilinearGrid>(block.grid), name[space + 1] - 'i');
	block.fields.clear(); // they are in the old order
	grid::finishBlock(block);
	return made;
}

// Keeps only one grid of each kind at a time.
Grid& keep(const std::string& name, bool builds_neighbors = true)
{
	static std::array<Grid, 2> grids;
	Grid& grid = grids[builds_neighbors];
	if (grid.name != name)
	{
		grids = {}; // before the next one is made
		grid = {name, makeGrid(name, builds_neighbors), nullptr};
	}
	return grid;
}

vtkDataSet* vtkOf(Grid& grid)
{
	if (!grid.vtk)
		grid.vtk = asVtk(grid.blocks.blocks[0]);
	return grid.vtk;
}

} // namespace

const grid::BlockSet& listedNamed(const std::string& name)
{
	return keep(name, false).blocks;
}

vtkDataSet* vtkListedNamed(const std::string& name)
{
	return vtkOf(keep(name, false));
}

const grid::BlockSet& gridNamed(const std::string& name)
{
	return keep(name).blocks;
}

vtkDataSet* vtkNamed(const std::string& name)
{
	return vtkOf(keep(name));
}

ReadCells readCells(const grid::UnstructuredGrid& grid, bool shuffled)
{
	std::vector<CellId> order(grid.cellCount());
	std::iota(order.begin(), order.end(), 0u);
	if (shuffled)
		std::shuffle(order.begin(), order.end(), std::mt19937(1));
	std::vector<std::uint8_t> types;
	std::vector<std::int64_t> offsets{0};
	std::vector<std::int64_t> connectivity;
	types.reserve(order.size());
	offsets.reserve(order.size() + 1);
	for (const CellId c : order)
	{
		types.push_back(vtkType(grid.shape(c)));
		for (const PointId p : grid.cellPoints(c))
			connectivity.push_back(p);
		offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
	}
	ReadCells read;
	read.points = grid.coordinates();
	read.cells.types = std::move(types);
	read.cells.offsets = std::move(offsets);
	read.cells.connectivity = std::move(connectivity);
	return read;
}

std::vector<probe::Frame> sweepOf(const Box& bounds)
{
	probe::Path path;
	path.kind = probe::PathKind::profile;
	return probe::poses(path, {}, bounds, probe::kProfilePlanes);
}

} // namespace vp::bench
