#pragma once

#include "base/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::reader::cells
{

// Finds the order in which the file lists the nodes of one kind of Lagrange or Bezier cell. Writers differ, and the
// file's version does not tell them apart (docs/CORRECTNESS.md). So this looks at the places of the nodes: in the right
// order, neighbors in the cell's lattice are neighbors in space, and the links between them are short.
class NodeOrder
{
public:
	NodeOrder() = default;
	// `at` gives the place of each node in VTK's order, from 0 to 1.
	NodeOrder(std::uint8_t type, const std::array<int, 3>& degrees, std::span<const Vec3> at);

	// Returns true if writers differ about this kind.
	bool isDoubtful() const { return !orders_.empty(); }

	// Measures the orders on a cell of the file.
	void weigh(std::span<const Vec3> nodes);

	// Returns for each node of VTK's order its position in the file's list. This is the order with the shortest links,
	// or VTK's if no other is better.
	const std::vector<int>& best() const;
	bool isVtk() const { return &best() == orders_.data(); }

private:
	std::vector<std::vector<int>> orders_; // VTK's comes first
	std::vector<double> lengths_;          // the sum of the squared links in each order
	std::vector<std::array<int, 2>> links_;
};

} // namespace vp::reader::cells
