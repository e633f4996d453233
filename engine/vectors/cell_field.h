#pragma once

#include "grid/grid.h"
#include "grid/structured.h"
#include "locate/cell_polynomial.h"
#include "locate/fan_weights.h"
#include "vectors/vector_array.h"

#include <algorithm>
#include <array>
#include <concepts>
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
	std::vector<PointId> points; // each once
	Vec3 center;                 // their mean, from the cell's origin
	Vec3 size;                   // of their box
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

template <grid::Grid G>
constexpr bool kIsLattice = std::derived_from<G, grid::Lattice>;

// Reads cells of one block.
template <grid::Grid G>
class CellLoader
{
public:
	CellLoader(const G& grid, TimedVectors vectors) : grid_(grid), vectors_(vectors) {}

	const G& grid() const { return grid_; }
	bool onCells() const { return vectors_[0].onCells(); }

	void load(CellId cell, CellField& into) const
	{
		into.cell = cell;
		into.shape = grid_.shape(cell);
		into.affine = false;
		into.fan.loaded = false;
		if (into.shape == grid::CellShape::polyhedron)
			return loadFan(into);
		const grid::CellPoints ids = grid_.cellPoints(cell);
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
		grid_.cellFaces(into.cell, fan.faces);
		fan.points = fan.faces.points;
		std::ranges::sort(fan.points);
		fan.points.erase(std::unique(fan.points.begin(), fan.points.end()), fan.points.end());
		if (into.shape == grid::CellShape::polyhedron)
			into.origin = grid_.point(fan.points.front());
		Box box;
		fan.center = Vec3(0.0);
		for (const PointId p : fan.points)
		{
			const Vec3 place = grid_.point(p) - into.origin;
			fan.center += place / static_cast<double>(fan.points.size());
			box.include(place);
		}
		fan.size = box.size();
		fan.loaded = true;
	}

	// Of a place in a part of the fan.
	Vec3 fanVector(const CellField& field, const locate::FanPart& part, int time) const
	{
		const BlockVectors& vectors = vectors_[time];
		if (vectors.onCells())
			return vectors.at(grid_.sourceCell(field.cell));
		const auto mean = [&](std::span<const PointId> points)
		{
			Vec3 sum(0.0);
			for (const PointId p : points)
				sum += vectors.at(grid_.sourcePoint(p));
			return sum / static_cast<double>(points.size());
		};
		const std::span<const PointId> face = field.fan.faces[part.face];
		return part.weight[0] * mean(field.fan.points) + part.weight[1] * mean(face) +
		       part.weight[2] * vectors.at(grid_.sourcePoint(face[part.edge])) +
		       part.weight[3] * vectors.at(grid_.sourcePoint(face[(part.edge + 1) % face.size()]));
	}

private:
	void readCorners(CellId cell, const grid::CellPoints& ids, std::array<Vec3, grid::kMaxShapePoints>& corner) const
	{
		if constexpr (std::same_as<G, grid::UniformGrid> || std::same_as<G, grid::RectilinearGrid>)
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

	void loadVectors(CellId cell, const grid::CellPoints& ids, std::size_t time, CellField& into) const
	{
		const BlockVectors& vectors = vectors_[time];
		if (vectors.onCells())
		{
			into.vectors[time] = {};
			into.vectors[time].constant = vectors.at(grid_.sourceCell(cell));
			return;
		}
		std::array<Vec3, grid::kMaxShapePoints> corner{};
		for (int v = 0; v < ids.size; ++v)
			corner[v] = vectors.at(grid_.sourcePoint(ids.id[v]));
		into.vectors[time] = locate::cellPolynomial(into.shape, {corner.data(), std::size_t(ids.size)});
	}

	const G& grid_;
	TimedVectors vectors_;
};

} // namespace vp::vectors
