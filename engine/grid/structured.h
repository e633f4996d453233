#pragma once

#include "base/array.h"
#include "grid/grid.h"
#include "grid/points.h"

#include <array>
#include <cassert>

namespace vp::grid
{

// The connectivity of an image, a rectilinear or a curvilinear grid: cells (i, j, k) of a lattice, where i runs
// fastest. Faces are numbered as in VTK: -i, +i, -j, +j, -k, +k. With fewer than two points along an axis there is no
// cell.
class Lattice
{
public:
	Lattice() = default;
	explicit Lattice(std::array<std::uint32_t, 3> points);

	std::array<std::uint32_t, 3> points() const { return points_; } // along i, j, k
	std::array<std::uint32_t, 3> cells() const { return cells_; }
	std::size_t cellCount() const { return std::size_t(cells_[0]) * cells_[1] * cells_[2]; }
	std::size_t pointCount() const { return std::size_t(points_[0]) * points_[1] * points_[2]; }
	std::size_t usedPointCount() const { return pointCount(); } // all belong to a cell, where there is one

	std::array<std::uint32_t, 3> cellIndex(CellId c) const
	{
		const std::uint32_t row = c / cells_[0];
		return {c - row * cells_[0], row % cells_[1], row / cells_[1]};
	}
	std::array<std::uint32_t, 3> pointIndex(PointId p) const
	{
		const std::uint32_t row = p / points_[0];
		return {p - row * points_[0], row % points_[1], row / points_[1]};
	}
	CellId cell(std::uint32_t i, std::uint32_t j, std::uint32_t k) const { return (k * cells_[1] + j) * cells_[0] + i; }
	PointId pointId(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
	{
		return (k * points_[1] + j) * points_[0] + i;
	}

	CellShape shape(CellId) const { return CellShape::hexahedron; }
	int faceCount(CellId) const { return 6; }
	CellPoints cellPoints(CellId c) const
	{
		const auto [i, j, k] = cellIndex(c);
		const PointId p = pointId(i, j, k);
		const PointId row = points_[0];
		const PointId layer = points_[0] * points_[1];
		return {{p, p + 1, p + 1 + row, p + row, p + layer, p + 1 + layer, p + 1 + row + layer, p + row + layer}, 8};
	}
	void cellFaces(CellId c, CellFaces& faces) const
	{
		faces.clear();
		shapeFaces(CellShape::hexahedron, cellPoints(c), faces);
	}
	// Returns the cell across face f, kNoCell on the boundary.
	CellId neighbor(CellId c, int f) const
	{
		const auto index = cellIndex(c);
		const int axis = f / 2;
		const bool up = f % 2;
		if (up ? index[axis] + 1 == cells_[axis] : index[axis] == 0)
			return kNoCell;
		return up ? c + stride_[axis] : c - stride_[axis];
	}
	template <class Visit>
	void forEachNeighbor(CellId c, int f, Visit&& visit) const
	{
		if (const CellId n = neighbor(c, f); n != kNoCell)
			visit(n);
	}
	std::size_t sourcePoint(PointId p) const { return p; }
	std::size_t sourceCell(CellId c) const { return c; }

private:
	std::array<std::uint32_t, 3> points_{0, 0, 0};
	std::array<std::uint32_t, 3> cells_{0, 0, 0};
	std::array<std::uint32_t, 3> stride_{0, 0, 0}; // between cells along each axis
};

// Image: points at origin + (i, j, k) * spacing.
class UniformGrid : public Lattice
{
public:
	UniformGrid() = default;
	UniformGrid(std::array<std::uint32_t, 3> points, Vec3 origin, Vec3 spacing)
	    : Lattice(points), origin_(origin), spacing_(spacing)
	{
	}
	Vec3 point(PointId p) const
	{
		const auto [i, j, k] = pointIndex(p);
		return pointAt(i, j, k);
	}
	Vec3 pointAt(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
	{
		return {coordinate(0, i), coordinate(1, j), coordinate(2, k)};
	}
	double coordinate(int axis, std::uint32_t index) const { return origin_[axis] + index * spacing_[axis]; }

private:
	Vec3 origin_{0.0};
	Vec3 spacing_{1.0};
};

// Points at (x[i], y[j], z[k]).
class RectilinearGrid : public Lattice
{
public:
	RectilinearGrid() = default;
	RectilinearGrid(Array<double> x, Array<double> y, Array<double> z)
	    : Lattice({static_cast<std::uint32_t>(x.size()), static_cast<std::uint32_t>(y.size()),
	               static_cast<std::uint32_t>(z.size())}),
	      axis_{std::move(x), std::move(y), std::move(z)}
	{
	}
	Vec3 point(PointId p) const
	{
		const auto [i, j, k] = pointIndex(p);
		return pointAt(i, j, k);
	}
	Vec3 pointAt(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
	{
		return {axis_[0][i], axis_[1][j], axis_[2][k]};
	}
	double coordinate(int axis, std::uint32_t index) const { return axis_[axis][index]; }
	const Array<double>& axis(int number) const { return axis_[number]; }

private:
	std::array<Array<double>, 3> axis_;
};

// Points anywhere, in lattice order. The axes may have another order than in the source (lattice_axes.h). sourcePoint()
// and sourceCell() return the numbers of the source.
class CurvilinearGrid : public Lattice
{
public:
	CurvilinearGrid() = default;
	// axes[a]: the axis of the source that runs along axis a. The order is cyclic, so that cells keep their
	// orientation.
	CurvilinearGrid(std::array<std::uint32_t, 3> points, Points coordinates,
	                std::array<std::uint8_t, 3> axes = {0, 1, 2});

	std::array<std::uint8_t, 3> axes() const { return axes_; }
	Lattice sourceLattice() const;
	std::size_t sourcePoint(PointId p) const
	{
		return axes_[0] == 0 ? p : sourceNumber(pointIndex(p), source_point_strides_);
	}
	std::size_t sourceCell(CellId c) const
	{
		return axes_[0] == 0 ? c : sourceNumber(cellIndex(c), source_cell_strides_);
	}
	Vec3 point(PointId p) const { return points_[p]; }
	Vec3 pointAt(std::uint32_t i, std::uint32_t j, std::uint32_t k) const { return points_[pointId(i, j, k)]; }
	const Points& coordinates() const { return points_; }
	void prefetch(PointId from, PointId to) const { points_.prefetch(from, to); }

private:
	static std::size_t sourceNumber(const std::array<std::uint32_t, 3>& index,
	                                const std::array<std::uint32_t, 3>& strides)
	{
		return index[0] * strides[0] + index[1] * strides[1] + index[2] * strides[2];
	}

	Points points_;
	std::array<std::uint8_t, 3> axes_{0, 1, 2};
	std::array<std::uint32_t, 3> source_point_strides_{0, 0, 0}; // in the source's numbers, per axis here
	std::array<std::uint32_t, 3> source_cell_strides_{0, 0, 0};
};

static_assert(Grid<UniformGrid> && Grid<RectilinearGrid> && Grid<CurvilinearGrid>);

} // namespace vp::grid
