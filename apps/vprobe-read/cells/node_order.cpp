#include "node_order.h"

#include "grid/curved/lattice_nodes.h"
#include "read/check_mesh.h"

#include <vtkCellType.h>
#include <vtkHigherOrderHexahedron.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace vp::reader::cells
{

namespace
{

// Another order must make the links shorter than this share of VTK's.
constexpr double kClearlyShorter = 0.99;

using Place = grid::LatticePlace;

// The orders of VTK 9.1 and PyFR, and of VTK before 9.1 and MFEM; then both with the order of Lagrange triangles.
constexpr std::array<grid::WedgeHabit, 4> kWedgeHabits = {{{false, false}, {false, true}, {true, false}, {true, true}}};

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
		for (const grid::WedgeHabit& habit : kWedgeHabits)
		{
			const std::vector<Place> nodes = grid::wedgeNodes(degrees[0], degrees[2], habit);
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
	// A cell with a node that is no place is left out. It does not affect the order of the others.
	const auto is_place = [](const Vec3& at)
	{ return read::isPlace(at.x) && read::isPlace(at.y) && read::isPlace(at.z); };
	if (!std::ranges::all_of(nodes, is_place))
		return;
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

} // namespace vp::reader::cells
