#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vp::reader::wrapped
{

// A cell of VTK's with nodes in all of its edges and faces and inside it. Its nodes are known by the corners between
// which they lie: one for a corner, two for an edge, three or four for a face, more for the inside.
struct FullCell
{
	std::uint8_t type;
	std::vector<std::vector<std::uint8_t>> nodes;
	// The node inside, of the others, where an element lacks it.
	std::vector<double> inside;
};

// A type of Exodus elements that VTK's reader mixes up.
struct ExodusForm
{
	std::string_view family; // the first three letters of its name
	const FullCell* cell;
	std::vector<std::uint8_t> nodes; // for each node of the element, in the manual's order, the node of the cell
	std::size_t in_place;            // those before the nodes in faces and inside, about which writers differ

	// For each node of the cell, the weights of the element's nodes: their polynomials at that place.
	std::vector<std::vector<double>> weights() const;
};

std::span<const ExodusForm> exodusForms();

// Whether VTK's reader has the nodes of a type in the right order.
bool isPlainExodus(std::string_view family, std::size_t nodes);

// Returns the types to name in place of one that is refused, or nothing if the family is none of solid cells.
std::optional<std::string_view> plainExodusNames(std::string_view family);

} // namespace vp::reader::wrapped
