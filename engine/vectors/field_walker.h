#pragma once

#include "vectors/cell_field.h"
#include "vectors/concave_way.h"
#include "vectors/particle.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace vp::vectors
{

// The vector at a place.
struct Sample
{
	Vec3 vector;          // from the cell, extrapolated if the place is outside; NaN if nothing is known
	double depth;         // in the cell, in its own coordinates: negative outside
	int face = -1;        // the face that it is nearest to, or farthest beyond
	bool outside = false; // outside the block, or outside the cell if the walker stays in it
};

// Finds the vectors at places in one block that lie near each other, as along a path. The search begins in the cell of
// the last place, with Newton's method. While the place lies beyond a face, it goes on in the cell across. This is
// fence hopping with the cell's own coordinates in place of planes, so it is exact on warped faces. If no face that the
// place lies beyond has a cell across, the place is outside. The last cells are kept, since the stages of a step go
// back and forth.
//
// A cell that is concave or has holes is left where the straight way from the begin of the step leaves it, even if the
// place lies in the cell again: a particle does not jump over a hole.
//
// Not thread safe. It refers to the grid and its vectors. It allocates only for polyhedra and for cells where Newton's
// method fails, and only while buffers grow.
template <grid::Grid G>
class FieldWalker
{
public:
	// A state from which a walk can start again.
	struct Cursor
	{
		CellId cell;
		Vec3 u;
		Vec3 place;
	};

	static constexpr double kHeld = -1e-9; // rounding: a cell still contains a place that is so far beyond its face

	// stays: takes all places in the cell of the last one, for arrays on cells.
	FieldWalker(const CellLoader<G>& loader, bool stays) : loader_(loader), stays_(stays) {}

	// Goes on where a walk has been, in another walker or in another process.
	void resume(CellId cell, const CellStand& stand)
	{
		moveTo(cell);
		begin_.reset();
		u_ = fromSource(loader_.axes(), stand.u);
		place_ = stand.place;
		part_.reset();
		if (stand.in_parts)
			part_.emplace();
		predicts_ = false;
	}
	CellStand stand() const { return {toSource(loader_.axes(), u_), place_, part_.has_value()}; }
	void startIn(CellId cell)
	{
		moveTo(cell);
		begin_.reset();
		u_ = startOf(here().shape);
		predicts_ = false;
	}
	Cursor cursor() const { return {here().cell, u_, place_}; }
	void restore(const Cursor& cursor)
	{
		moveTo(cursor.cell);
		u_ = cursor.u;
		place_ = cursor.place;
		begin_ = cursor.place;
		begin_cell_ = isConcave() ? cursor.cell : kNoCell;
	}
	CellId cell() const { return here().cell; }

	// between: 0 at the first of two times, 1 at the second.
	Sample at(const Vec3& place, double between)
	{
		if (predictsIn(here()))
			u_ += locate::applied(inverse_, place - place_);
		place_ = place;
		if (begin_ && begin_cell_ != kNoCell)
			moveTo(begin_cell_);
		double begun = 0.0; // the share of the way from the beginning that is done
		CellId before = kNoCell;
		double depth_before = 0.0;
		for (int hop = 0;; ++hop)
		{
			settle();
			if (part_ && part_->face < 0)
				return {Vec3(std::numeric_limits<double>::quiet_NaN()), -1.0, -1, true}; // no volume
			if (isConcave())
			{
				const bool begins_here = begun == 0.0 && (!begin_ || here().cell == begin_cell_);
				const auto left = whereLeft(here().fan.places, begin_.value_or(place), place, begun, begins_here);
				if (!left)
					return sample({part_->face, std::max(part_->depth(), 0.0)}, between, false);
				const CellId next = stays_ || hop == kMaxHops ? kNoCell : across(left->face);
				if (next == kNoCell)
					return sample({left->face, -1.0}, between, true);
				const bool goes_on = left->part > begun + kNoWay;
				if (!goes_on && next == before)
					return sample({part_->face, 0.0}, between, false); // both sides of a warped face disown it
				before = goes_on ? kNoCell : here().cell;
				depth_before = -1.0;
				begun = left->part;
				cross({next, left->face});
				continue;
			}
			const Nearest nearest = nearestFace();
			const bool held = nearest.depth >= kHeld;
			if (held || stays_ || hop == kMaxHops)
				return sample(nearest, between, !held);
			const std::optional<Crossing> way = wayOut(nearest);
			if (!way)
				return sample(nearest, between, true);
			if (way->cell == before)
			{
				// Both sides of a warped face disown it, as cells of different shapes may: the nearer one has it.
				if (depth_before <= nearest.depth)
					return sample(nearest, between, false);
				cross(*way);
				settle();
				return sample(nearestFace(), between, false);
			}
			before = here().cell;
			depth_before = nearest.depth;
			cross(*way);
		}
	}

	// Returns the depth of the last place behind a face of its cell. Returns nothing if the cell is taken as
	// tetrahedra.
	std::optional<double> depthBehind(int face) const
	{
		if (part_)
			return std::nullopt;
		return locate::faceDepths(here().shape, u_).of[face];
	}

	// The precision of places: up to rounding, or what a step needs.
	void beExact(bool exact) { exact_ = exact; }

	// Returns the map from steps in space to steps in the coordinates of the cell, at the last place. From then on it
	// predicts where to look for places first.
	const std::array<Vec3, 3>& measureCell()
	{
		inverse_ = inverseHere();
		inverse_cell_ = here().cell;
		predicts_ = !part_;
		return inverse_;
	}

	// Returns the cell across a face of the present cell, kNoCell on the boundary.
	CellId across(int face) const { return loader_.across(here().cell, face, place_); }

private:
	static constexpr int kMaxHops = 64;     // steps are kept as short as a cell
	static constexpr double kNoWay = 1e-12; // share of a step
	static constexpr int kKept = 4;         // number of cells kept; a step near an edge passes through as many

	struct Nearest
	{
		int face;
		double depth;
	};
	struct Crossing
	{
		CellId cell;
		int face;
	};

	CellField& here() { return kept_[at_]; }
	const CellField& here() const { return kept_[at_]; }
	// Cells side by side in a lattice are much alike.
	bool predictsIn(const CellField& cell) const { return predicts_ && (kIsLattice<G> || cell.cell == inverse_cell_); }
	bool isConcave() const
	{
		return here().shape == grid::CellShape::polyhedron && here().fan.loaded && here().fan.is_concave;
	}
	static Vec3 startOf(grid::CellShape shape)
	{
		return shape == grid::CellShape::polyhedron ? Vec3(0.5) : locate::middleOf(shape);
	}

	void moveTo(CellId cell)
	{
		for (int i = 0; i < kKept; ++i)
			if (kept_[i].cell == cell)
			{
				at_ = i;
				return;
			}
		at_ = next_;
		next_ = (next_ + 1) % kKept;
		loader_.load(cell, kept_[at_]);
	}

	// Finds the place in the present cell.
	void settle()
	{
		CellField& cell = here();
		const Vec3 place = place_ - cell.origin;
		part_.reset();
		if (cell.affine)
			u_ = locate::applied(cell.inverse, place);
		else if (cell.shape == grid::CellShape::polyhedron || !findInShape(cell, place))
		{
			if (!cell.fan.loaded)
				loader_.loadFan(cell);
			part_ =
			    locate::deepestPart(loader_.fanPoints(cell.fan), cell.fan.faces, cell.origin, cell.fan.center, place);
			u_ = startOf(cell.shape);
		}
	}
	bool findInShape(const CellField& cell, const Vec3& place)
	{
		if (predictsIn(cell) && !exact_ && findNear(cell, place))
			return true;
		if (locate::findPlace(cell.places, cell.shape, place, u_))
			return true;
		u_ = startOf(cell.shape);
		return locate::findPlace(cell.places, cell.shape, place, u_);
	}

	// From a guess that is near: with one slope for all steps, and each leaves a part of the error as small as the
	// slopes differ in the cell.
	bool findNear(const CellField& cell, const Vec3& place)
	{
		constexpr int kMaxSteps = 3;
		constexpr double kSmall = 2e-5; // share of the cell; the error that remains is a small part of it
		Vec3 u = u_;
		for (int step = 0; step < kMaxSteps; ++step)
		{
			const Vec3 move = locate::applied(inverse_, place - cell.places.at(cell.shape, u));
			u += move;
			if (std::abs(move.x) + std::abs(move.y) + std::abs(move.z) < kSmall)
			{
				u_ = u;
				return true;
			}
		}
		return false;
	}

	Nearest nearestFace() const
	{
		if (part_)
			return {part_->face, part_->depth()};
		if constexpr (kIsLattice<G>)
		{
			const Vec3 off = glm::abs(u_ - 0.5);
			if (const double depth = 0.5 - std::max({off.x, off.y, off.z}); depth >= 0.0)
				return {-1, depth}; // which face matters outside only
		}
		const locate::FaceDepths depths = locate::faceDepths(here().shape, u_);
		const auto least = std::ranges::min_element(depths.of);
		return {static_cast<int>(least - depths.of.begin()), *least};
	}

	// Goes across the face that the place is farthest beyond, among the faces with a cell across.
	std::optional<Crossing> wayOut(const Nearest& nearest) const
	{
		if (const CellId next = across(nearest.face); next != kNoCell)
			return Crossing{next, nearest.face};
		if (part_)
			return std::nullopt;
		locate::FaceDepths depths = locate::faceDepths(here().shape, u_);
		depths.of[nearest.face] = 0.0;
		for (;;)
		{
			const auto least = std::ranges::min_element(depths.of);
			if (!(*least < kHeld))
				return std::nullopt;
			*least = 0.0;
			const int face = static_cast<int>(least - depths.of.begin());
			if (const CellId next = across(face); next != kNoCell)
				return Crossing{next, face};
		}
	}

	void cross(const Crossing& way)
	{
		moveTo(way.cell);
		if constexpr (kIsLattice<G>)
			u_[way.face / 2] += way.face % 2 ? -1.0 : 1.0;
		else
			u_ = startOf(here().shape);
	}

	Sample sample(const Nearest& nearest, double between, bool outside) const
	{
		Vec3 vector = vectorAt(0);
		if (between != 0.0)
			vector += between * (vectorAt(1) - vector);
		return {vector, nearest.depth, nearest.face, outside};
	}
	Vec3 vectorAt(int time) const
	{
		return part_ ? loader_.fanVector(here(), *part_, time) : here().vectorAt(u_, time);
	}

	std::array<Vec3, 3> inverseHere() const
	{
		const CellField& cell = here();
		if (cell.affine)
			return cell.inverse;
		if (!part_)
		{
			const auto inverse = locate::inverseOf(cell.places.slopesAt(cell.shape, u_));
			if (std::isfinite(inverse[0].x + inverse[1].y + inverse[2].z))
				return inverse;
		}
		const Vec3 size = glm::max(fanSize(cell), Vec3(std::numeric_limits<double>::min()));
		return {Vec3(1.0 / size.x, 0.0, 0.0), Vec3(0.0, 1.0 / size.y, 0.0), Vec3(0.0, 0.0, 1.0 / size.z)};
	}

	Vec3 fanSize(const CellField& cell) const
	{
		if (cell.fan.loaded)
			return cell.fan.size;
		CellField scratch = cell;
		loader_.loadFan(scratch);
		return scratch.fan.size;
	}

	const CellLoader<G>& loader_;
	bool stays_;
	std::array<CellField, kKept> kept_;
	int at_ = 0;
	int next_ = 0;
	Vec3 u_{0.5};                         // in the present cell
	Vec3 place_{0.0};                     // place of the last call
	std::optional<Vec3> begin_;           // where the step begins
	CellId begin_cell_ = kNoCell;         // the cell there if it is concave
	std::optional<locate::FanPart> part_; // where the present cell is taken as tetrahedra
	bool predicts_ = false;               // by the inverse
	bool exact_ = false;
	CellId inverse_cell_ = kNoCell;
	std::array<Vec3, 3> inverse_{};
};

} // namespace vp::vectors
