#include "refine/cell_kind.h"

#include "refine/pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vp::refine
{

using grid::CellShape;

namespace
{

/// The degrees of the lattice.
std::array<int, 3> latticeDegrees(std::uint8_t type, std::size_t nodes, const std::array<int, 3>& degrees)
{
	if (grid::hasMiddles(type, nodes)) // bubbles in faces are cubic, the one inside is quartic
		return type == grid::kLagrangeTetra ? std::array{4, 4, 4} : std::array{3, 3, 2};
	if (grid::hasDegrees(type))
		return degrees;
	if (grid::isSliceable(type))
		return {1, 1, 1};
	return type == grid::kQuadraticLinearWedge ? std::array{2, 2, 1} : std::array{2, 2, 2};
}

} // namespace

CellKind::CellKind(std::uint8_t type, std::size_t nodes, const std::array<int, 3>& degrees)
    : shape_(grid::cornerShape(type)), bezier_(grid::isBezier(type)), voxel_(type == grid::kVoxel),
      mirrored_(type == grid::kWedge || type == grid::kQuadraticWedge || type == grid::kQuadraticLinearWedge ||
                type == grid::kBiQuadraticQuadraticWedge),
      nodes_(nodes)
{
	makeCorners();
	makeFactors(type, latticeDegrees(type, nodes, degrees));
	if (isPyramid())
		makePyramid();
	else if (grid::hasMiddles(type, nodes))
		fillMiddles(type);
	else
	{
		placeNodes(latticeDegrees(type, nodes, degrees));
		fillFaces(type);
	}
	makeLinear();
	if (!isPyramid())
		makeStencils();
	chooseLevels();
}

void CellKind::makeCorners()
{
	static const std::array<Vec3, 8> cube = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0),
	                                         Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)};
	switch (shape_)
	{
	case CellShape::tetrahedron:
		corner_places_ = {cube[0], cube[1], cube[3], cube[4]};
		break;
	case CellShape::wedge:
		corner_places_ = {cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]};
		break;
	case CellShape::pyramid:
		corner_places_ = {cube[0], cube[1], cube[2], cube[3], Vec3(0.5, 0.5, 1)};
		break;
	default:
		corner_places_.assign(cube.begin(), cube.end());
	}
}

void CellKind::makeFactors(std::uint8_t type, const std::array<int, 3>& degrees)
{
	if (shape_ == CellShape::tetrahedron)
		factors_ = {Factor(0, 3, degrees[0])};
	else if (shape_ == CellShape::wedge)
		factors_ = {Factor(0, 2, degrees[0]), Factor(2, 1, degrees[2])};
	else
		for (int axis = 0; axis < 3; ++axis)
			factors_.emplace_back(axis, 1, type == grid::kPyramid ? 1 : degrees[static_cast<std::size_t>(axis)]);
	for (unsigned c = 0; c < corners(); ++c)
		for (const Factor& factor : factors_)
		{
			bool at_zero = true;
			for (int axis = factor.first(); axis < factor.first() + factor.axes(); ++axis)
				if (corner_places_[c][axis] == 1.0)
				{
					corners_along_[static_cast<std::size_t>(axis)] |= 1u << c;
					at_zero = false;
				}
			corners_at_zero_[static_cast<std::size_t>(factor.first())] |= at_zero ? 1u << c : 0u;
		}
	const std::size_t values =
	    std::accumulate(factors_.begin(), factors_.end(), std::size_t(1),
	                    [](std::size_t product, const Factor& factor) { return product * factor.size(); });
	(isPyramid() ? collapsed_ : rows_).resize(values);
}

std::size_t CellKind::numberOf(const std::array<int, 3>& place) const
{
	std::size_t number = 0;
	std::size_t stride = 1;
	for (const Factor& factor : factors_)
	{
		std::array<int, 3> own{};
		for (int a = 0; a < factor.axes(); ++a)
			own[static_cast<std::size_t>(a)] = place[static_cast<std::size_t>(factor.first() + a)];
		number += stride * factor.numberOf(own);
		stride *= factor.size();
	}
	return number;
}

std::array<int, 3> CellKind::placeOf(std::size_t value) const
{
	std::array<int, 3> place{};
	for (const Factor& factor : factors_)
	{
		const std::array<int, 3>& own = factor.places()[value % factor.size()];
		for (int a = 0; a < factor.axes(); ++a)
			place[static_cast<std::size_t>(factor.first() + a)] = own[static_cast<std::size_t>(a)];
		value /= factor.size();
	}
	return place;
}

Vec3 CellKind::atValue(std::size_t value) const
{
	const std::array<int, 3> place = placeOf(value);
	Vec3 at(0.0);
	for (const Factor& factor : factors_)
		for (int axis = factor.first(); axis < factor.first() + factor.axes(); ++axis)
			at[axis] = place[static_cast<std::size_t>(axis)] / double(factor.degree());
	return at;
}

void CellKind::makeLinear()
{
	linear_.resize(lattice() * corners());
	static constexpr std::array<std::array<int, 2>, 8> kPyramidEdges{
	    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};
	for (std::size_t value = 0; value < lattice(); ++value)
	{
		const std::span<double> weights = std::span(linear_).subspan(value * corners(), corners());
		if (isPyramid())
		{
			const Vec3 at = value < 5 ? corner_places_[value]
			                          : 0.5 * (corner_places_[static_cast<std::size_t>(kPyramidEdges[value - 5][0])] +
			                                   corner_places_[static_cast<std::size_t>(kPyramidEdges[value - 5][1])]);
			grid::weighPyramid(at, weights);
			if (value < 5)
				corner_values_[value] = value;
			continue;
		}
		const Vec3 at = atValue(value);
		for (std::size_t c = 0; c < corners(); ++c)
		{
			const Vec3& corner = corner_places_[c];
			double weight = 1.0;
			for (const Factor& factor : factors_)
			{
				double rest = 1.0;
				double own = -1.0;
				for (int axis = factor.first(); axis < factor.first() + factor.axes(); ++axis)
				{
					rest -= at[axis];
					own = corner[axis] > 0.5 ? at[axis] : own;
				}
				weight *= own >= 0.0 ? own : rest;
			}
			weights[c] = weight;
			if (weight == 1.0)
				corner_values_[c] = value;
		}
	}
}

/// The middles of edges that were halved so often tell all of the polynomials along them, or nearly.
void CellKind::chooseLevels()
{
	if (isPyramid())
	{
		degree_ = nodes_ > 5 ? 2 : 1;
		least_levels_ = degree_ - 1;
		return;
	}
	int bent = 0; // factors that are not linear
	int highest = 1;
	for (const Factor& factor : factors_)
	{
		bent += factor.degree() > 1;
		highest = std::max(highest, factor.degree());
	}
	degree_ = highest;
	if (highest <= 2)
		least_levels_ = bent > 1 ? 1 : 0;
	else
		least_levels_ = highest <= 3 || (highest == 4 && bent == 1) ? 1 : highest <= 8 ? 2 : 3;
}

int CellKind::degreeAlong(const Vec3f& a, const Vec3f& b) const
{
	if (isPyramid() || bezier_)
		return std::numeric_limits<int>::max(); // they may be rational
	int degree = 0;
	for (const Factor& factor : factors_)
	{
		bool moves = false;
		for (int axis = factor.first(); axis < factor.first() + factor.axes(); ++axis)
			moves |= a[axis] != b[axis];
		degree += moves ? factor.degree() : 0;
	}
	return degree;
}

unsigned CellKind::supportOf(const Vec3f& place) const
{
	unsigned support = 0;
	if (isPyramid())
	{
		if (place.z >= 1.0f)
			return 1u << 4;
		const float inset = 0.5f * place.z;
		const std::array<bool, 2> low{place.x < 1.0f - inset, place.y < 1.0f - inset};
		const std::array<bool, 2> high{place.x > inset, place.y > inset};
		constexpr std::array<std::array<bool, 2>, 4> is_high{
		    {{false, false}, {true, false}, {true, true}, {false, true}}};
		for (unsigned c = 0; c < 4; ++c)
			if ((is_high[c][0] ? high[0] : low[0]) && (is_high[c][1] ? high[1] : low[1]))
				support |= 1u << c;
		return place.z > 0.0f ? support | 1u << 4 : support;
	}
	// Each coordinate that is not 0 leaves the corners that have it.
	support = (1u << corners()) - 1u;
	for (const Factor& factor : factors_)
	{
		float rest = 1.0f;
		unsigned of_factor = 0;
		for (int axis = factor.first(); axis < factor.first() + factor.axes(); ++axis)
		{
			rest -= place[axis];
			of_factor |= place[axis] > 0.0f ? corners_along_[static_cast<std::size_t>(axis)] : 0u;
		}
		if (rest > 0.0f)
			of_factor |= corners_at_zero_[static_cast<std::size_t>(factor.first())];
		support &= of_factor;
	}
	return support;
}

void CellKind::toLattice(const double* nodes, std::size_t width, double* lattice) const
{
	for (const Row& row : rows_)
	{
		for (std::size_t i = 0; i < width; ++i)
			lattice[i] = 0.0;
		for (const auto& [node, weight] : row)
			for (std::size_t i = 0; i < width; ++i)
				lattice[i] += weight * nodes[node * width + i];
		lattice += width;
	}
}

void CellKind::weigh(const Vec3& at, double* weights) const
{
	if (isPyramid())
		return grid::weighPyramid(at, {weights, nodes_});
	std::array<double, kMaxLattice> own;
	std::size_t done = 1;
	weights[0] = 1.0;
	for (const Factor& factor : factors_)
	{
		if (bezier_)
			factor.weighBernstein(at, own.data());
		else
			factor.weighLagrange(at, own.data());
		for (std::size_t i = factor.size(); i-- > 0;)
			for (std::size_t n = 0; n < done; ++n)
				weights[i * done + n] = own[i] * weights[n];
		done *= factor.size();
	}
}

void CellKind::weighNodes(const Vec3& at, std::span<const double> rational, double* weights) const
{
	std::array<double, kMaxLattice> own;
	weigh(at, own.data());
	std::fill_n(weights, nodes_, 0.0);
	for (std::size_t value = 0; value < lattice(); ++value)
		for (const auto& [node, weight] : rows_[value])
			weights[node] += weight * own[value];
	if (rational.empty())
		return;
	double sum = 0.0;
	for (std::size_t n = 0; n < nodes_; ++n)
		sum += weights[n] *= rational[n];
	for (std::size_t n = 0; n < nodes_; ++n)
		weights[n] /= sum;
}

void CellKind::controlPoints(std::span<const Vec3> lattice, std::vector<Vec3>& control) const
{
	if (isPyramid())
	{
		control.assign(collapsed_.size(), Vec3(0.0));
		for (std::size_t value = 0; value < collapsed_.size(); ++value)
			for (const auto& [node, weight] : collapsed_[value])
				control[value] += weight * lattice[node];
	}
	else
		control.assign(lattice.begin(), lattice.end());
	if (bezier_)
		return;
	std::array<Vec3, 286> line; // the most values of a factor: of a tetrahedron
	std::size_t stride = 1;
	for (const Factor& factor : factors_)
	{
		const std::size_t n = factor.size();
		const std::span<const double> matrix = factor.toBernstein();
		for (std::size_t first = 0; first < control.size() && !matrix.empty(); ++first)
		{
			if (first / stride % n != 0)
				continue;
			for (std::size_t i = 0; i < n; ++i)
				line[i] = control[first + i * stride];
			for (std::size_t row = 0; row < n; ++row)
			{
				Vec3 sum(0.0);
				for (std::size_t i = 0; i < n; ++i)
					sum += matrix[row * n + i] * line[i];
				control[first + row * stride] = sum;
			}
		}
		stride *= n;
	}
}

} // namespace vp::refine
