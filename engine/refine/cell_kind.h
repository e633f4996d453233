#pragma once

#include "base/vec.h"
#include "grid/curved/curved_types.h"
#include "refine/factor.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vp::refine
{

/// The most numbers that describe a cell: a hexahedron of the highest degree.
inline constexpr std::size_t kMaxLattice = 11 * 11 * 11;

/// One kind of cell, linear ones too: its shape functions, and how to bound what they make. A place is in the cell's
/// own coordinates: the unit cube, its half below x + y = 1, its corner below x + y + z = 1, or the pyramid over the
/// unit square with its top at (1/2, 1/2, 1).
///
/// Nodes become values of a lattice, and all is computed from those: of Lagrange's polynomials, or of Bernstein's for
/// Bezier cells. Cells that lack nodes of the lattice, as quadratic hexahedra of 20 nodes, get them by their shape
/// functions. The lattice of a pyramid are its nodes.
class CellKind
{
public:
	/// nodes: the number of nodes. degrees: of a type for which grid::hasDegrees() is true.
	CellKind(std::uint8_t type, std::size_t nodes, const std::array<int, 3>& degrees);

	grid::CellShape shape() const { return shape_; }
	bool isBezier() const { return bezier_; }
	bool isPyramid() const { return shape_ == grid::CellShape::pyramid; }
	/// Returns true if the corners of VTK's cell run the other way round than those of the lattice.
	bool isMirrored() const { return mirrored_; }
	std::size_t nodes() const { return nodes_; }
	std::size_t lattice() const { return rows_.size(); }
	/// The highest degree along an axis.
	int degree() const { return degree_; }
	/// Returns the degree along the line between two places: edges may bend both ways if it is above 2.
	int degreeAlong(const Vec3f& a, const Vec3f& b) const;
	/// Returns how often edges are always halved. The middles alone do not tell how a cell bends.
	int leastLevels() const { return least_levels_; }

	/// Corners in VTK's order: their places in the list of nodes, and in the cell's coordinates.
	std::size_t corners() const { return corner_places_.size(); }
	std::size_t cornerNode(std::size_t corner) const { return voxel_ ? grid::kVoxelOrder[corner] : corner; }
	const Vec3& cornerPlace(std::size_t corner) const { return corner_places_[corner]; }
	/// Returns the value of the lattice at a corner.
	std::size_t cornerValue(std::size_t corner) const { return corner_values_[corner]; }
	/// Returns a bit for each corner that a place depends on, if the cell is linear.
	unsigned supportOf(const Vec3f& place) const;

	/// Makes the values at the lattice from those at the nodes, `width` numbers each.
	void toLattice(const double* nodes, std::size_t width, double* lattice) const;
	/// Writes the weights of the lattice at a place: lattice() numbers.
	void weigh(const Vec3& at, double* weights) const;
	/// Writes the weights of the nodes: nodes() numbers. rational: of the nodes; or empty.
	void weighNodes(const Vec3& at, std::span<const double> rational, double* weights) const;
	/// Returns the weights of the corners at a value of the lattice, if the cell were linear.
	std::span<const double> linearWeights(std::size_t value) const
	{
		return std::span(linear_).subspan(value * corners(), corners());
	}

	/// Writes points whose convex hull holds the cell: of Bernstein's polynomials. Of a pyramid those over a cube that
	/// has collapsed to it.
	void controlPoints(std::span<const Vec3> lattice, std::vector<Vec3>& control) const;

	/// Differences of control points that give the derivatives: `factor` times the sum of the ends less the others.
	struct Stencils
	{
		double factor = 0.0;
		std::vector<std::array<std::uint32_t, 4>> points; // a - b - c + d; first derivatives: a - b, and c is d
	};
	/// Pairs of axes: 00, 11, 22, 01, 02, 12. Not of a pyramid.
	const Stencils& second(std::size_t pair) const { return second_[pair]; }
	const Stencils& first(std::size_t axis) const { return first_[axis]; }

private:
	using Row = std::vector<std::pair<std::uint32_t, double>>; // nodes and their weights

	void makeCorners();
	void makeFactors(std::uint8_t type, const std::array<int, 3>& degrees);
	void placeNodes(const std::array<int, 3>& degrees);
	void fillFaces(std::uint8_t type);
	void fillMiddles(std::uint8_t type);
	void makePyramid();
	void makeLinear();
	void makeStencils();
	void chooseLevels();
	std::size_t numberOf(const std::array<int, 3>& place) const;
	std::array<int, 3> placeOf(std::size_t value) const;
	Vec3 atValue(std::size_t value) const;

	grid::CellShape shape_;
	bool bezier_;
	bool voxel_;
	bool mirrored_;
	int degree_ = 2;
	int least_levels_ = 0;
	std::size_t nodes_;
	std::vector<Vec3> corner_places_;
	std::array<std::size_t, grid::kMaxShapePoints> corner_values_{};
	std::array<unsigned, 3> corners_along_{};   // per axis: a bit for each corner at its end
	std::array<unsigned, 3> corners_at_zero_{}; // per first axis of a factor: bits of the corners at 0 of its axes
	std::vector<Factor> factors_;
	std::vector<Row> rows_;      // per value of the lattice
	std::vector<Row> collapsed_; // only for a pyramid, per value of the cube's lattice
	std::vector<double> linear_;
	std::array<Stencils, 6> second_;
	std::array<Stencils, 3> first_;
};

} // namespace vp::refine
