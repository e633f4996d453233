#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace vp::reader::meshes
{

// How VTK has an element of Gmsh. Its corner i is the element's node order[i]; without an order they are the same.
struct GmshElement
{
	int nodes = 0;   // in the file; 0 for a type that is not known
	int corners = 0; // in VTK's cell
	std::uint8_t type = 0;
	std::span<const std::uint8_t> order{};
};

GmshElement gmshElement(std::int64_t type);

// Returns a type's name, such as "hexahedra of order 3"; empty for types that are read and for unknown ones.
std::string_view gmshNameOf(std::int64_t type);

} // namespace vp::reader::meshes
