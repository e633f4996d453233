#pragma once

#include "grid/cell_places.h"
#include "grid/grid.h"
#include "grid/structured.h"
#include "locate/cell_polynomial.h"
#include "locate/fan_weights.h"
#include "vectors/cell_across.h"
#include "vectors/elsewhere.h"
#include "vectors/lattice_axes.h"
#include "vectors/vector_array.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace vp::vectors
{

// Vectors of a block at one time or at two; between two they change linearly.
using TimedVectors = std::span<const BlockVectors>;

// A cell as tetrahedra (fan_weights.h): of any shape, and where Newton's method fails.
struct CellFan
{
	bool loaded = false;
	grid::CellFaces faces;
	std::vector<PointId> points; // each point once, in an order that depends on the cell alone
	Vec3 center;                 // mean of the points, from the cell's origin
	Vec3 size;                   // size of the points' box
	grid::CellPlaces places;     // only for a polyhedron
	bool is_concave = false;     // the center does not see all of a polyhedron's surface, or it has holes
	// Only for lattices, whose cell may belong to another piece. Faces and points are numbered in the cell.
	std::array<Vec3, 8> corners;
	std::array<std::array<Vec3, 8>, 2> vectors;

	Vec3 point(PointId corner) const { return corners[corner]; }
};

// A cell with the vectors in it, ready to be asked for many places.
struct CellField
{
	CellId cell = kNoCell;
	grid::CellShape shape;
	bool affine;                   // then a place is found at once
	Vec3 origin;                   // the cell's first point
	locate::CellPolynomial places; // from there; of a table shape
	std::array<Vec3, 3> inverse;   // where affine
	std::array<locate::CellPolynomial, 2> vectors;
	CellFan fan;

	Vec3 vectorAt(const Vec3& u, int time) const { return vectors[time].at(shape, u); }
};

// Reads cells of one block. With others elsewhere (a lattice in pieces) also those of other pieces that are known.
// Their numbers here begin behind those of the block.
template <grid::Grid G>
class CellLoader
{
public:
	CellLoader(const G& grid, TimedVectors vectors, std::uint32_t block, const Elsewhere* elsewhere)
	    : grid_(grid), vectors_(vectors), block_(block), elsewhere_(kIsLattice<G> ? elsewhere : nullptr)
	{
	}

	bool onCells() const { return vectors_[0].onCells(); }
	bool hasElsewhere() const { return kIsLattice<G> && elsewhere_; }
	bool isFar(CellId cell) const { return hasElsewhere() && cell >= grid_.cellCount(); }
	LatticeAxes axes() const { return axesOf(grid_); }

	mesh::BlockCell idOf(CellId cell) const { return isFar(cell) ? far(cell).id : mesh::BlockCell{block_, cell}; }
	// Throws MissingCell if it is of another block and not known.
	CellId numberOf(const mesh::BlockCell& cell) const
	{
		if (cell.block == block_)
			return cell.cell;
		if (const std::optional<std::uint32_t> number = elsewhere_->numberOf(cell))
			return static_cast<CellId>(grid_.cellCount()) + *number;
		throw MissingCell{cell};
	}

	// Returns the cell across a face, kNoCell on the boundary.
	CellId across(CellId cell, int face, const Vec3& place) const
	{
		if (!hasElsewhere())
			return cellAcross(grid_, cell, face, place);
		if (isFar(cell))
		{
			const mesh::BlockCell& next = far(cell).across[sourceFace(axes(), face)];
			return next.cell == kNoCell ? kNoCell : numberOf(next);
		}
		if (const CellId next = cellAcross(grid_, cell, face, place); next != kNoCell)
			return next;
		const std::optional<mesh::BlockCell> next = elsewhere_->borders().inSameLattice({block_, cell}, face);
		return next ? numberOf(*next) : kNoCell;
	}

	void load(CellId cell, CellField& into) const
	{
		into.cell = cell;
		into.affine = false;
		into.fan.loaded = false;
		into.shape = isFar(cell) ? grid::CellShape::hexahedron : grid_.shape(cell);
		if (into.shape == grid::CellShape::polyhedron)
			return loadFan(into);
		const grid::CellPoints ids = isFar(cell) ? grid::CellPoints{{}, 8} : grid_.cellPoints(cell);
		std::array<Vec3, grid::kMaxShapePoints> corner{};
		readCorners(cell, ids, corner);
		into.origin = corner[0];
		for (int i = ids.size; i-- > 0;)
			corner[i] -= corner[0];
		into.places = locate::cellPolynomial(into.shape, {corner.data(), std::size_t(ids.size)});
		if (into.places.isAffine())
		{
			into.inverse = locate::inverseOf({into.places.x, into.places.y, into.places.z});
			into.affine = std::isfinite(into.inverse[0].x + into.inverse[1].y + into.inverse[2].z);
		}
		for (std::size_t time = 0; time < vectors_.size(); ++time)
			loadVectors(cell, ids, time, into);
	}

	void loadFan(CellField& into) const
	{
		CellFan& fan = into.fan;
		if constexpr (kIsLattice<G>)
			takeLatticeCell(into.cell, fan);
		else
			takePoints(into.cell, fan);
		if (into.shape == grid::CellShape::polyhedron)
			into.origin = fanPoints(fan).point(fan.points.front());
		Box box;
		fan.center = Vec3(0.0);
		for (const PointId p : fan.points)
		{
			const Vec3 place = fanPoints(fan).point(p) - into.origin;
			fan.center += place / static_cast<double>(fan.points.size());
			box.include(place);
		}
		fan.size = box.size();
		fan.loaded = true;
		fan.is_concave = false;
		if constexpr (!kIsLattice<G>)
			if (into.shape == grid::CellShape::polyhedron)
			{
				fan.places.fetch(grid_, into.cell);
				fan.is_concave = !grid::isStarAbout(fan.places, into.origin + fan.center);
			}
	}

	// Returns the object that knows the places of a fan's points.
	const auto& fanPoints(const CellFan& fan) const
	{
		if constexpr (kIsLattice<G>)
			return fan;
		else
			return grid_;
	}

	// Returns the vector at a place in a part of the fan.
	Vec3 fanVector(const CellField& field, const locate::FanPart& part, int time) const
	{
		if (onCells())
			return cellVector(field.cell, time);
		const auto of = [&](PointId p)
		{
			if constexpr (kIsLattice<G>)
				return field.fan.vectors[time][p];
			else
				return vectors_[time].at(grid_.sourcePoint(p));
		};
		const auto mean = [&](std::span<const PointId> points)
		{
			Vec3 sum(0.0);
			for (const PointId p : points)
				sum += of(p);
			return sum / static_cast<double>(points.size());
		};
		const std::span<const PointId> face = field.fan.faces[part.face];
		return part.weight[0] * mean(field.fan.points) + part.weight[1] * mean(face) +
		       part.weight[2] * of(face[part.edge]) + part.weight[3] * of(face[(part.edge + 1) % face.size()]);
	}

private:
	const FarCell& far(CellId cell) const { return elsewhere_->cell(cell - static_cast<CellId>(grid_.cellCount())); }

	void readCorners(CellId cell, const grid::CellPoints& ids, std::array<Vec3, grid::kMaxShapePoints>& corner) const
	{
		if (isFar(cell))
			for (int v = 0; v < 8; ++v)
				corner[v] = far(cell).corners[sourceCorner(axes(), v)];
		else if constexpr (std::same_as<G, grid::UniformGrid> || std::same_as<G, grid::RectilinearGrid>)
		{
			// Its points' subscripts follow from the cell's, without a division for each.
			const auto [i, j, k] = grid_.cellIndex(cell);
			constexpr std::array<std::array<unsigned, 3>, 8> kStep{
			    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
			for (int v = 0; v < 8; ++v)
				corner[v] = grid_.pointAt(i + kStep[v][0], j + kStep[v][1], k + kStep[v][2]);
		}
		else
			for (int v = 0; v < ids.size; ++v)
				corner[v] = grid_.point(ids.id[v]);
	}

	Vec3 cellVector(CellId cell, std::size_t time) const
	{
		return isFar(cell) ? far(cell).vectors[time][0] : vectors_[time].at(grid_.sourceCell(cell));
	}

	// Reads the vectors at a cell's points from a point array.
	template <class Corners>
	void readVectors(CellId cell, const grid::CellPoints& ids, std::size_t time, Corners& corner) const
	{
		for (int v = 0; v < ids.size; ++v)
			corner[v] = isFar(cell) ? far(cell).vectors[time][sourceCorner(axes(), v)]
			                        : vectors_[time].at(grid_.sourcePoint(ids.id[v]));
	}

	void loadVectors(CellId cell, const grid::CellPoints& ids, std::size_t time, CellField& into) const
	{
		if (onCells())
		{
			into.vectors[time] = {};
			into.vectors[time].constant = cellVector(cell, time);
			return;
		}
		std::array<Vec3, grid::kMaxShapePoints> corner{};
		readVectors(cell, ids, time, corner);
		into.vectors[time] = locate::cellPolynomial(into.shape, {corner.data(), std::size_t(ids.size)});
	}

	void takePoints(CellId cell, CellFan& fan) const
	{
		grid_.cellFaces(cell, fan.faces);
		fan.points.clear();
		for (const PointId p : fan.faces.points)
			if (std::ranges::find(fan.points, p) == fan.points.end())
				fan.points.push_back(p);
	}

	void takeLatticeCell(CellId cell, CellFan& fan) const
	{
		grid::shapeFaces(grid::CellShape::hexahedron, {{0, 1, 2, 3, 4, 5, 6, 7}, 8}, fan.faces);
		fan.points = {0, 1, 3, 2, 4, 5, 7, 6}; // as the lattice numbers them
		const grid::CellPoints ids = isFar(cell) ? grid::CellPoints{{}, 8} : grid_.cellPoints(cell);
		std::array<Vec3, grid::kMaxShapePoints> corner{};
		readCorners(cell, ids, corner);
		std::copy_n(corner.begin(), 8, fan.corners.begin());
		for (std::size_t time = 0; time < vectors_.size() && !onCells(); ++time)
			readVectors(cell, ids, time, fan.vectors[time]);
	}

	const G& grid_;
	TimedVectors vectors_;
	std::uint32_t block_;
	const Elsewhere* elsewhere_;
};

} // namespace vp::vectors
