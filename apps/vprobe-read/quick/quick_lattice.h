#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace vp::reader::text
{
struct XmlElement;
}

namespace vp::reader::quick
{

// A lattice of a .vti, .vtr or .vts file whose layers the quick reader can read alone.
struct Lattice
{
	const char* kind; // as in the manifest
	std::array<std::uint64_t, 3> points;
};
std::optional<Lattice> quickLattice(const std::string& file);

// Returns the number of points of a lattice along each axis. Throws NotQuick if there are no cells, or too many.
std::array<std::uint64_t, 3> latticePoints(const text::XmlElement& data, const text::XmlElement& piece);

} // namespace vp::reader::quick
