#include "refine/cell_kind.h"

#include "grid/curved/lattice_nodes.h"
#include "refine/pyramid.h"

#include <algorithm>
#include <cmath>

namespace vp::refine
{

using grid::CellShape;

/// The nodes that lie in the lattice.
void CellKind::placeNodes(const std::array<int, 3>& degrees)
{
	std::vector<grid::LatticePlace> places = shape_ == CellShape::tetrahedron ? grid::tetrahedronNodes(degrees[0])
	                                         : shape_ == CellShape::wedge     ? grid::wedgeNodes(degrees[0], degrees[2])
	                                                                          : grid::hexahedronNodes(degrees);
	places.resize(nodes_);
	for (std::uint32_t n = 0; n < nodes_; ++n)
		rows_[numberOf(places[voxel_ ? grid::kVoxelOrder[n] : n])] = {{n, 1.0}};
}

/// Values of the lattice where cells of fewer nodes have none: in the middle of faces, and inside.
void CellKind::fillFaces(std::uint8_t type)
{
	const auto add = [&](Row& row, std::initializer_list<std::uint32_t> nodes, double weight)
	{
		for (const std::uint32_t n : nodes)
			row.emplace_back(n, weight);
	};
	const auto fill = [&](const std::array<int, 3>& place, std::initializer_list<std::uint32_t> corners,
	                      std::initializer_list<std::uint32_t> middles)
	{
		Row& row = rows_[numberOf(place)];
		add(row, corners, -0.25);
		add(row, middles, 0.5);
	};
	if (type == grid::kQuadraticHexahedron)
	{
		fill({0, 1, 1}, {0, 3, 4, 7}, {11, 15, 16, 19});
		fill({2, 1, 1}, {1, 2, 5, 6}, {9, 13, 17, 18});
		fill({1, 0, 1}, {0, 1, 4, 5}, {8, 12, 16, 17});
		fill({1, 2, 1}, {2, 3, 6, 7}, {10, 14, 18, 19});
	}
	if (type == grid::kQuadraticHexahedron || type == grid::kBiQuadraticQuadraticHexahedron)
	{
		fill({1, 1, 0}, {0, 1, 2, 3}, {8, 9, 10, 11});
		fill({1, 1, 2}, {4, 5, 6, 7}, {12, 13, 14, 15});
	}
	if (type == grid::kQuadraticWedge)
	{
		fill({1, 0, 1}, {0, 1, 3, 4}, {6, 9, 12, 13});
		fill({1, 1, 1}, {1, 2, 4, 5}, {7, 10, 13, 14});
		fill({0, 1, 1}, {2, 0, 5, 3}, {8, 11, 14, 12});
		return;
	}
	if (type != grid::kQuadraticHexahedron && type != grid::kBiQuadraticQuadraticHexahedron)
		return;
	Row& inside = rows_[numberOf({1, 1, 1})];
	if (type == grid::kQuadraticHexahedron)
	{
		add(inside, {0, 1, 2, 3, 4, 5, 6, 7}, -0.25);
		add(inside, {8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}, 0.25);
	}
	if (type == grid::kBiQuadraticQuadraticHexahedron)
	{
		add(inside, {16, 17, 18, 19}, -0.25);
		add(inside, {20, 21, 22, 23}, 0.5);
	}
}

/// Fills the functions of the 15 nodes of a tetrahedron or the 21 nodes of a wedge: quadratic functions, and bubbles
/// that bring the faces and the inside to their nodes.
void CellKind::fillMiddles(std::uint8_t type)
{
	const bool is_tetrahedron = type == grid::kLagrangeTetra;
	const CellKind quadratic =
	    is_tetrahedron ? CellKind(grid::kQuadraticTetra, 10, {}) : CellKind(grid::kLagrangeWedge, 18, {2, 2, 2});
	const auto dense = [&](const Vec3& at)
	{
		std::vector<double> weights(nodes_, 0.0);
		quadratic.weighNodes(at, {}, weights.data());
		if (!is_tetrahedron)
		{
			// The middles of the triangles are nodes 15, 16 and 20; those of the quadrilaterals come between.
			std::rotate(weights.begin() + 15, weights.begin() + 18, weights.begin() + 20);
		}
		return weights;
	};
	// Adds what a bubble with this height at the place gives, where it brings the functions to a node.
	const auto addBubble =
	    [&](std::vector<double>& weights, const std::vector<double>& at_node, std::uint32_t node, double height)
	{
		for (std::size_t n = 0; n < nodes_; ++n)
			weights[n] -= height * at_node[n];
		weights[node] += height;
	};
	const double third = 1.0 / 3.0;
	for (std::size_t value = 0; value < rows_.size(); ++value)
	{
		const Vec3 at = atValue(value);
		std::vector<double> weights = dense(at);
		if (is_tetrahedron)
		{
			const std::array<double, 4> corner{1.0 - at.x - at.y - at.z, at.x, at.y, at.z};
			constexpr std::array<std::array<std::size_t, 3>, 4> faces{{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}};
			const auto withFaces = [&](const Vec3& place, const std::array<double, 4>& by)
			{
				std::vector<double> made = dense(place);
				for (std::uint32_t f = 0; f < 4; ++f)
				{
					Vec3 middle(0.0);
					for (const std::size_t c : faces[f])
						middle += third * corner_places_[c];
					addBubble(made, dense(middle), 10 + f, 27.0 * by[faces[f][0]] * by[faces[f][1]] * by[faces[f][2]]);
				}
				return made;
			};
			weights = withFaces(at, corner);
			addBubble(weights, withFaces(Vec3(0.25), {0.25, 0.25, 0.25, 0.25}), 14,
			          256.0 * corner[0] * corner[1] * corner[2] * corner[3]);
		}
		else
		{
			const double bubble = 27.0 * (1.0 - at.x - at.y) * at.x * at.y;
			const std::array<double, 3> along{(1.0 - at.z) * (1.0 - 2.0 * at.z), 4.0 * at.z * (1.0 - at.z),
			                                  at.z * (2.0 * at.z - 1.0)};
			constexpr std::array<std::uint32_t, 3> middles{15, 20, 16}; // at the heights 0, 1/2 and 1
			for (std::size_t k = 0; k < 3; ++k)
				addBubble(weights, dense(Vec3(third, third, 0.5 * double(k))), middles[k], bubble * along[k]);
		}
		for (std::uint32_t n = 0; n < nodes_; ++n)
			if (std::abs(weights[n]) > 1e-14)
				rows_[value].emplace_back(n, weights[n]);
	}
}

/// A pyramid is what it is; a cube that collapses to it gives control points.
void CellKind::makePyramid()
{
	rows_.resize(nodes_);
	for (std::uint32_t n = 0; n < nodes_; ++n)
		rows_[n] = {{n, 1.0}};
	std::vector<double> weights(nodes_);
	for (std::size_t value = 0; value < collapsed_.size(); ++value)
	{
		const Vec3 at = atValue(value);
		grid::weighPyramid({at.x * (1.0 - at.z) + 0.5 * at.z, at.y * (1.0 - at.z) + 0.5 * at.z, at.z}, weights);
		for (std::uint32_t n = 0; n < nodes_; ++n)
			if (weights[n] != 0.0)
				collapsed_[value].emplace_back(n, weights[n]);
	}
}

void CellKind::makeStencils()
{
	const auto degreeAlong = [&](std::size_t axis)
	{
		for (const Factor& factor : factors_)
			if (static_cast<int>(axis) >= factor.first() && static_cast<int>(axis) < factor.first() + factor.axes())
				return std::pair(&factor, factor.degree());
		return std::pair<const Factor*, int>(nullptr, 0);
	};
	// A place and what steps from it along one or two axes give, if it is in the lattice.
	const auto isInside = [&](const std::array<int, 3>& place)
	{
		return std::ranges::all_of(factors_,
		                           [&](const Factor& factor)
		                           {
			                           int sum = 0;
			                           for (int a = 0; a < factor.axes(); ++a)
				                           sum += place[static_cast<std::size_t>(factor.first() + a)];
			                           return sum <= factor.degree();
		                           });
	};
	constexpr std::array<std::array<std::size_t, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
	for (std::size_t value = 0; value < lattice(); ++value)
	{
		const std::array<int, 3> place = placeOf(value);
		const auto moved = [&](std::size_t j, std::size_t k)
		{
			std::array<int, 3> to = place;
			++to[j];
			if (k < 3)
				++to[k];
			return to;
		};
		const auto number = [&](const std::array<int, 3>& at) { return static_cast<std::uint32_t>(numberOf(at)); };
		for (std::size_t axis = 0; axis < 3; ++axis)
			if (isInside(moved(axis, 3)))
				first_[axis].points.push_back({number(moved(axis, 3)), number(place), 0, 0});
		for (std::size_t p = 0; p < 6; ++p)
		{
			const auto [j, k] = pairs[p];
			if (isInside(moved(j, k)))
				second_[p].points.push_back(
				    {number(moved(j, k)), number(moved(j, 3)), number(moved(k, 3)), number(place)});
		}
	}
	for (std::size_t axis = 0; axis < 3; ++axis)
		first_[axis].factor = degreeAlong(axis).second;
	for (std::size_t p = 0; p < 6; ++p)
	{
		const auto [of_j, degree_j] = degreeAlong(pairs[p][0]);
		const auto [of_k, degree_k] = degreeAlong(pairs[p][1]);
		second_[p].factor = of_j == of_k ? degree_j * (degree_j - 1.0) : double(degree_j) * degree_k;
	}
}

} // namespace vp::refine
