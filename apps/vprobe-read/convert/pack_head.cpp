#include "pack_head.h"

#include "grid/farthest_points.h"
#include "hdf5_output.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::reader::convert
{

namespace
{

void writeCounts(const PackPartitions& partitions, bool has_polyhedra, hid_t root)
{
	const auto write = [&](const char* name, std::int64_t PackPartitions::Counts::*count)
	{
		std::vector<std::int64_t> counts;
		for (const PackPartitions::Counts& partition : partitions.partitions())
			counts.push_back(partition.*count);
		writeValues(root, name, H5T_NATIVE_INT64, {counts.size()}, counts.data());
	};
	write("NumberOfPoints", &PackPartitions::Counts::points);
	write("NumberOfCells", &PackPartitions::Counts::cells);
	write("NumberOfConnectivityIds", &PackPartitions::Counts::ids);
	if (!has_polyhedra)
		return;
	write("NumberOfFaces", &PackPartitions::Counts::faces);
	write("NumberOfPolyhedronToFaceIds", &PackPartitions::Counts::faces);
	write("NumberOfFaceConnectivityIds", &PackPartitions::Counts::face_ids);
}

void writeParts(const PackDivision& division, hid_t own)
{
	std::vector<std::int64_t> points, cells;
	for (std::size_t part = 0; part < division.parts(); ++part)
	{
		points.push_back(static_cast<std::int64_t>(division.points(part).size()));
		cells.push_back(static_cast<std::int64_t>(division.cells(part).size()));
	}
	writeValues(own, "PartPoints", H5T_NATIVE_INT64, {points.size()}, points.data());
	writeValues(own, "PartCells", H5T_NATIVE_INT64, {cells.size()}, cells.data());
}

vtkIdType pointsOfNoCell(vtkUnstructuredGrid* grid, const PackDivision& division)
{
	std::vector<bool> has_cell(static_cast<std::size_t>(grid->GetNumberOfPoints()));
	for (std::size_t part = 0; part < division.parts(); ++part)
		for (const std::uint32_t point : division.points(part))
			has_cell[point] = true;
	return std::ranges::count(has_cell, false);
}

// A box for each run of cells, and how many ids and faces it has.
void writeRuns(const PackDivision& division, hid_t own)
{
	static_assert(sizeof(PackBox) == 6 * sizeof(double));
	std::vector<PackBox> boxes;
	for (std::size_t part = 0; part < division.parts(); ++part)
		for (const PackRun& run : division.runs(part))
			boxes.push_back(run.box);
	writeValues(own, "Boxes", H5T_NATIVE_DOUBLE, {boxes.size(), 6}, boxes.data());
	const auto write = [&](const char* name, std::uint32_t PackRun::*count)
	{
		std::vector<std::uint32_t> counts;
		for (std::size_t part = 0; part < division.parts(); ++part)
			for (const PackRun& run : division.runs(part))
				counts.push_back(run.*count);
		writeValues(own, name, H5T_NATIVE_UINT32, {counts.size()}, counts.data());
	};
	write("NumberOfConnectivityIds", &PackRun::ids);
	if (!division.polyhedra().hasPolyhedra())
		return;
	write("NumberOfFaces", &PackRun::faces);
	write("NumberOfFaceConnectivityIds", &PackRun::face_ids);
}

// A camera is set so that it sees all of them.
void writeFarthestPoints(vtkUnstructuredGrid* grid, const PackDivision& division, hid_t own)
{
	Box bounds;
	for (std::size_t part = 0; part < division.parts(); ++part)
		for (const PackRun& run : division.runs(part))
			if (const PackBox& box = run.box; box.lo[0] <= box.hi[0])
				bounds.include(Box{{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}});
	grid::FarthestPoints farthest(bounds.center());
	farthest.include(bounds, static_cast<std::size_t>(grid->GetNumberOfPoints()),
	                 [&division](std::size_t point)
	                 {
		                 const std::array<double, 3> at = division.place(static_cast<std::uint32_t>(point));
		                 return Vec3(at[0], at[1], at[2]);
	                 });
	const std::vector<Vec3> points = farthest.points();
	writeValues(own, "FarthestPoints", H5T_NATIVE_DOUBLE, {points.size(), 3}, points.data());
}

} // namespace

void writePackHead(vtkUnstructuredGrid* grid, const PackDivision& division, const PackPartitions& partitions,
                   hid_t root, hid_t own)
{
	const auto count = [](vtkIdType number) { return std::array<std::int64_t, 1>{number}; };
	writeAttribute(own, "NumberOfPoints", H5T_NATIVE_INT64, count(grid->GetNumberOfPoints()));
	writeAttribute(own, "NumberOfCells", H5T_NATIVE_INT64, count(grid->GetNumberOfCells()));
	writeAttribute(own, "PointsOfNoCell", H5T_NATIVE_INT64, count(pointsOfNoCell(grid, division)));
	writeAttribute(own, "CellsOfRun", H5T_NATIVE_INT64, count(static_cast<vtkIdType>(division.cellsOfRun())));
	const PackDivision::LeftOut& left_out = division.leftOut();
	writeAttribute(own, "FlatCells", H5T_NATIVE_INT64, count(left_out.flat));
	writeAttribute(own, "HiddenCells", H5T_NATIVE_INT64, count(left_out.hidden));
	writeAttribute(own, "CellsWithoutPlace", H5T_NATIVE_INT64, count(left_out.unplaced));
	if (division.areAlike())
		writeAttribute(own, "CellType", H5T_NATIVE_INT64, count(division.types()[0]));
	writeCounts(partitions, division.polyhedra().hasPolyhedra(), root);
	writeParts(division, own);
	writeRuns(division, own);
	writeFarthestPoints(grid, division, own);
}

} // namespace vp::reader::convert
