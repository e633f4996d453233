#include "cases/lattice_cases.h"

#include "cases/case_table.h"

#include <bit>

namespace vp::cases
{

namespace
{

// Bits of a lattice corner: 0 is j + 1, 1 is k + 1, 2 is i + 1. VTK numbers the points of a hexahedron around the face
// at k, then around the face at k + 1.
constexpr std::array<std::uint8_t, 8> kCornerOf = {0, 4, 5, 1, 2, 6, 7, 3};

constexpr int kAxisOfBit[3] = {1, 2, 0}; // axis of each bit of a lattice corner

LatticeEdge latticeEdge(std::uint8_t a, std::uint8_t b)
{
	const auto lower = static_cast<std::uint8_t>(a & b); // the corner with fewer bits: they differ in one
	return {static_cast<std::uint8_t>(lower & 3), static_cast<std::uint8_t>(lower >> 2),
	        static_cast<std::uint8_t>(kAxisOfBit[std::countr_zero(static_cast<unsigned>(a ^ b))])};
}

LatticeCase latticeCase(unsigned corners)
{
	unsigned mask = 0;
	for (int v = 0; v < 8; ++v)
		mask |= (corners >> kCornerOf[v] & 1) << v;
	const Case& entry = caseTable(grid::CellShape::hexahedron)[mask];
	LatticeCase found;
	found.edges = entry.edges;
	found.needs_walk = entry.needs_walk;
	for (int e = 0; e < entry.edges; ++e)
		found.edge[e] = latticeEdge(kCornerOf[entry.edge[e][0]], kCornerOf[entry.edge[e][1]]);
	for (int e = entry.edges; e < kMaxLatticeEdges; ++e)
		found.edge[e] = found.edge[0];
	for (int bit = 0; bit < 3; ++bit)
		if ((corners & 1) != (corners >> (1 << bit) & 1))
		{
			found.owned |= static_cast<std::uint8_t>(1 << kAxisOfBit[bit]);
			++found.owned_count;
		}
	return found;
}

} // namespace

const std::array<LatticeCase, 256>& latticeCases()
{
	static const std::array<LatticeCase, 256> table = []
	{
		std::array<LatticeCase, 256> cases;
		for (unsigned corners = 0; corners < cases.size(); ++corners)
			cases[corners] = latticeCase(corners);
		return cases;
	}();
	return table;
}

} // namespace vp::cases
