#pragma once

#include "grid/block.h"

#include <string_view>
#include <vector>

namespace vp::test
{

// One finished block of every kind of grid and of every hard place, small enough for brute force. Each has a point
// field "linear" (float64, linearAt() of the point) and a cell field "id" (int64, the source number of the cell); the
// demos have s and v before these. Built once.
const std::vector<grid::Block>& allGrids();

// By name; aborts on one that does not exist.
const grid::Block& gridNamed(std::string_view name);

// 2x - 3y + z/2 + 1
double linearAt(const Vec3& p);

// The fields "linear" and "id". source_cells: of the file, where it has other cells too; 0: the grid's own.
void addTestFields(grid::Block& block, std::size_t source_cells = 0);

// A hexahedral lattice of n x n x n cells over the unit cube as explicit cells, where `keep(i, j, k)` holds.
grid::Block explicitHexahedra(int n, bool (*keep)(int i, int j, int k));

// The points of a cell list, and its cells, as they are written.
class CellListMaker
{
public:
	std::int64_t point(const Vec3& p);
	void cell(std::uint8_t vtk_type, const std::vector<std::int64_t>& ids);
	void polyhedron(const std::vector<std::vector<std::int64_t>>& faces);

	grid::Points points() const { return grid::Points(Array<double>(xyz_)); }
	grid::CellList list() const;
	std::size_t cells() const { return types_.size(); }
	// A finished block with the fields "linear" and "id".
	grid::Block block(std::string name, std::vector<grid::FaceLink> links = {}) const;

private:
	std::vector<double> xyz_;
	std::vector<std::uint8_t> types_;
	std::vector<std::int64_t> offsets_{0};
	std::vector<std::int64_t> ids_;
	std::vector<std::int64_t> face_offsets_{0};
	std::vector<std::int64_t> face_stream_;
};

} // namespace vp::test
