#pragma once

#include "grid/curved/curved_cells.h"
#include "refine/cell_kinds.h"
#include "refine/pyramid.h"
#include "refine/refine_block.h"
#include "refine/sheets.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vp::refine
{

/// A cell that a sheet may meet, with all that refining it needs.
struct NearCell
{
	std::uint32_t cell = 0;
	const CellKind* kind = nullptr;
	std::size_t lattice = 0;        // where its numbers begin
	bool is_flat = false;           // its nodes are where a linear cell has them, or nearly
	std::array<double, 6> second{}; // bounds of the second derivatives: 00, 11, 22, 01, 02, 12
	std::optional<PyramidBend> pyramid;
	std::array<float, grid::kMaxShapeEdges> edge_sizes{};

	/// Returns a bound on how far the cell is from the linear cell between the corners of a tetrahedron that lies in
	/// this box of the cell's coordinates.
	double bendWithin(const Vec3& lo, const Vec3& hi) const;
	/// Returns the size of the edge, the face or the cell that these corners span.
	double sizeOf(unsigned support) const;
};

/// The cells in some boxes that a sheet may meet, those of high degree first.
class NearCells
{
public:
	NearCells(const grid::CurvedCells& curved, const CellKinds& kinds, const Sheets& sheets, double slack,
	          std::span<const ShownArray> shown);

	/// Looks at these cells.
	void add(std::span<const std::uint32_t> cells);

	std::size_t size() const { return order_.size(); }
	const NearCell& operator[](std::size_t i) const { return ranges_[order_[i].range].cells[order_[i].place]; }
	/// Returns how many numbers a point has: three coordinates, and the values as a share of what they may be off.
	std::size_t width() const { return width_; }
	/// Writes the numbers at a place of a cell. weights: room for kMaxLattice.
	void evaluate(std::size_t i, const Vec3& place, double* weights, double* numbers) const;
	/// Writes the values of a node of the file: width() - 3 numbers.
	void valuesOf(std::size_t node, double* values) const;
	std::size_t curvedLookedAt() const { return curved_looked_at_; }
	std::size_t curvedMet() const { return curved_met_; }

private:
	struct Range
	{
		std::vector<NearCell> cells;
		std::vector<double> lattice;
		std::size_t curved_looked_at = 0;
	};
	struct Place
	{
		std::uint32_t range;
		std::uint32_t place;
	};
	struct Scratch
	{
		std::vector<double> nodes;
		std::vector<Vec3> positions; // positions of the lattice
		std::vector<Vec3> control;
	};

	std::size_t stride() const { return width_ + (rational_ ? 1 : 0); }
	void look(std::uint32_t cell, Range& range, Scratch& scratch) const;
	void bound(NearCell& near, std::span<const double> lattice, Scratch& scratch) const;
	void measure(NearCell& near, std::span<const double> lattice) const;
	bool isFlat(const NearCell& near, std::span<const double> lattice) const;

	const grid::CurvedCells& curved_;
	const CellKinds& kinds_;
	const Sheets& sheets_;
	double slack_;
	std::span<const ShownArray> shown_;
	std::size_t width_ = 3;
	bool rational_;
	std::vector<Range> ranges_;
	std::vector<Place> order_;
	std::size_t curved_looked_at_ = 0;
	std::size_t curved_met_ = 0;
};

} // namespace vp::refine
