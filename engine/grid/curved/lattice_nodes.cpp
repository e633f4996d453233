#include "grid/curved/lattice_nodes.h"

#include <algorithm>

namespace vp::grid
{

namespace
{

using Spot = std::array<int, 2>; // in the lattice of a triangle

/// Returns the lattice points of a triangle: first the corners, then the edges, then the triangle that is left, in the
/// same way.
std::vector<Spot> inRings(int degree)
{
	if (degree == 0)
		return {{0, 0}};
	std::vector<Spot> spots = {{0, 0}, {degree, 0}, {0, degree}};
	for (int i = 1; i < degree; ++i)
		spots.push_back({i, 0});
	for (int i = 1; i < degree; ++i)
		spots.push_back({degree - i, i});
	for (int i = 1; i < degree; ++i)
		spots.push_back({0, degree - i});
	if (degree >= 3)
		for (const Spot& spot : inRings(degree - 3))
			spots.push_back({spot[0] + 1, spot[1] + 1});
	return spots;
}

std::vector<Spot> insideTriangle(int degree, bool rings)
{
	std::vector<Spot> spots;
	if (degree < 3)
		return spots;
	if (rings)
		for (const Spot& spot : inRings(degree - 3))
			spots.push_back({spot[0] + 1, spot[1] + 1});
	else
		for (int j = 1; j < degree; ++j)
			for (int i = 1; i + j < degree; ++i)
				spots.push_back({i, j});
	return spots;
}

/// A place that is so far from the first corner of a simplex toward others.
LatticePlace between(const std::array<LatticePlace, 3>& corners, int degree, int to_second, int to_third)
{
	LatticePlace place;
	for (std::size_t axis = 0; axis < 3; ++axis)
		place[axis] = ((degree - to_second - to_third) * corners[0][axis] + to_second * corners[1][axis] +
		               to_third * corners[2][axis]) /
		              degree;
	return place;
}

} // namespace

std::vector<LatticePlace> tetrahedronNodes(int degree)
{
	if (degree == 0)
		return {{0, 0, 0}};
	const std::array<LatticePlace, 4> corners{{{0, 0, 0}, {degree, 0, 0}, {0, degree, 0}, {0, 0, degree}}};
	constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
	constexpr std::array<std::array<int, 3>, 4> faces{{{0, 1, 3}, {2, 3, 1}, {0, 3, 2}, {0, 2, 1}}};
	std::vector<LatticePlace> nodes(corners.begin(), corners.end());
	for (const auto& [a, b] : edges)
		for (int i = 1; i < degree; ++i)
			nodes.push_back(between({corners[a], corners[b], corners[b]}, degree, i, 0));
	for (const auto& [a, b, c] : faces)
		for (const Spot& spot : insideTriangle(degree, true))
			nodes.push_back(between({corners[a], corners[b], corners[c]}, degree, spot[0], spot[1]));
	if (degree >= 4)
		for (const LatticePlace& place : tetrahedronNodes(degree - 4))
			nodes.push_back({place[0] + 1, place[1] + 1, place[2] + 1});
	return nodes;
}

std::vector<LatticePlace> wedgeNodes(int across, int along, const WedgeHabit& habit)
{
	const std::array<Spot, 3> corners = {{{0, 0}, {across, 0}, {0, across}}};
	std::array<std::vector<Spot>, 3> edges;
	for (int i = 1; i < across; ++i)
	{
		edges[0].push_back({i, 0});
		edges[1].push_back({across - i, i});
		edges[2].push_back({0, across - i});
	}
	const std::vector<Spot> inside = insideTriangle(across, habit.rings);
	std::vector<LatticePlace> nodes;
	const auto add = [&](const auto& spots, int k)
	{
		for (const Spot& spot : spots)
			nodes.push_back({spot[0], spot[1], k});
	};
	for (const int k : {0, along})
		add(corners, k);
	for (const int k : {0, along})
		for (const auto& edge : edges)
			add(edge, k);
	for (const Spot& corner : corners)
		for (int k = 1; k < along; ++k)
			nodes.push_back({corner[0], corner[1], k});
	for (const int k : {0, along})
		add(inside, k);
	if (habit.upward)
		std::reverse(edges[2].begin(), edges[2].end());
	for (const auto& side : edges)
		for (int k = 1; k < along; ++k)
			add(side, k);
	for (int k = 1; k < along; ++k)
		add(inside, k);
	return nodes;
}

std::vector<LatticePlace> hexahedronNodes(const std::array<int, 3>& degrees)
{
	const auto [a, b, c] = degrees;
	std::vector<LatticePlace> nodes;
	for (const int k : {0, c})
		nodes.insert(nodes.end(), {{0, 0, k}, {a, 0, k}, {a, b, k}, {0, b, k}});
	for (const int k : {0, c})
	{
		for (int i = 1; i < a; ++i)
			nodes.push_back({i, 0, k});
		for (int j = 1; j < b; ++j)
			nodes.push_back({a, j, k});
		for (int i = 1; i < a; ++i)
			nodes.push_back({i, b, k});
		for (int j = 1; j < b; ++j)
			nodes.push_back({0, j, k});
	}
	for (const auto& [i, j] : {Spot{0, 0}, Spot{a, 0}, Spot{a, b}, Spot{0, b}})
		for (int k = 1; k < c; ++k)
			nodes.push_back({i, j, k});
	for (const int i : {0, a})
		for (int k = 1; k < c; ++k)
			for (int j = 1; j < b; ++j)
				nodes.push_back({i, j, k});
	for (const int j : {0, b})
		for (int k = 1; k < c; ++k)
			for (int i = 1; i < a; ++i)
				nodes.push_back({i, j, k});
	for (const int k : {0, c})
		for (int j = 1; j < b; ++j)
			for (int i = 1; i < a; ++i)
				nodes.push_back({i, j, k});
	for (int k = 1; k < c; ++k)
		for (int j = 1; j < b; ++j)
			for (int i = 1; i < a; ++i)
				nodes.push_back({i, j, k});
	return nodes;
}

} // namespace vp::grid
