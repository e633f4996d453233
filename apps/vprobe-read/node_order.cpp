#include "node_order.h"

#include <vtkCellType.h>
#include <vtkHigherOrderHexahedron.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

using vp::Vec3;

namespace
{

// Another order must make the links shorter than this share of VTK's.
constexpr double kClearlyShorter = 0.99;

using Place = std::array<int, 3>; // in the cell's lattice

// How a writer lists the nodes within the faces of a wedge, and the nodes inside it.
struct WedgeHabit
{
	bool rings;  // triangles: corners, edges, and what is left likewise, as in a Lagrange triangle; else row by row
	bool upward; // the face between corners 2, 0, 3, 5: from corner 0 to corner 2
};

// VTK 9.1 and PyFR; VTK before 9.1 and MFEM; and both with the order of Lagrange triangles.
constexpr std::array<WedgeHabit, 4> kWedgeHabits = {{{false, false}, {false, true}, {true, false}, {true, true}}};

using Spot = std::array<int, 2>; // in the lattice of a triangle

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

// Corners, edges, triangles, quadrilaterals, and what lies inside.
std::vector<Place> wedgeNodes(int across, int along, const WedgeHabit& habit)
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
	std::vector<Place> nodes;
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

} // namespace

NodeOrder::NodeOrder(std::uint8_t type, const std::array<int, 3>& degrees, std::span<const Vec3> at)
{
	const bool is_wedge = type == VTK_LAGRANGE_WEDGE || type == VTK_BEZIER_WEDGE;
	const bool is_hexahedron = type == VTK_LAGRANGE_HEXAHEDRON || type == VTK_BEZIER_HEXAHEDRON;
	const auto count = static_cast<int>(at.size());
	if (is_hexahedron ? degrees[2] < 2 : !is_wedge || degrees[0] < 3)
		return;

	std::map<Place, int> known; // VTK's number of each place
	for (int n = 0; n < count; ++n)
	{
		Place place;
		for (int axis = 0; axis < 3; ++axis)
			place[axis] = static_cast<int>(std::lround(at[n][axis] * degrees[axis]));
		known[place] = n;
	}
	const auto link = [&](int n, const Place& other)
	{
		if (const auto found = known.find(other); found != known.end())
			links_.push_back({n, found->second});
	};
	for (const auto& [place, n] : known)
	{
		link(n, {place[0] + 1, place[1], place[2]});
		link(n, {place[0], place[1] + 1, place[2]});
		link(n, {place[0], place[1], place[2] + 1});
		if (is_wedge)
			link(n, {place[0] + 1, place[1] - 1, place[2]});
	}

	std::vector<int> order(at.size());
	std::iota(order.begin(), order.end(), 0);
	orders_.push_back(order);
	if (is_hexahedron)
	{
		// Before VTK 9.1 two edges had each other's nodes.
		for (int n = 0; n < count; ++n)
			order[n] = static_cast<int>(vtkHigherOrderHexahedron::NodeNumberingMappingFromVTK8To9(degrees.data(), n));
		orders_.push_back(order);
	}
	else
		for (const WedgeHabit& habit : kWedgeHabits)
		{
			const std::vector<Place> nodes = wedgeNodes(degrees[0], degrees[2], habit);
			for (int n = 0; n < count; ++n)
				order[known.at(nodes[n])] = n;
			if (std::ranges::find(orders_, order) == orders_.end())
				orders_.push_back(order);
		}
	if (orders_.size() == 1)
		orders_.clear();
	lengths_.resize(orders_.size());
}

void NodeOrder::weigh(std::span<const Vec3> nodes)
{
	for (std::size_t o = 0; o < orders_.size(); ++o)
		for (const auto& [a, b] : links_)
		{
			const Vec3 link = nodes[orders_[o][a]] - nodes[orders_[o][b]];
			lengths_[o] += glm::dot(link, link);
		}
}

const std::vector<int>& NodeOrder::best() const
{
	const auto shortest = static_cast<std::size_t>(std::ranges::min_element(lengths_) - lengths_.begin());
	return orders_[lengths_[shortest] < kClearlyShorter * lengths_[0] ? shortest : 0];
}
