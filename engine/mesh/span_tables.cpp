#include "mesh/span_tables.h"

#include <algorithm>

namespace vp::mesh
{

namespace
{

using cases::LatticeCase;
using cases::LatticeEdge;

CornerTable makeCornerTable(bool turned)
{
	CornerTable table{};
	for (std::size_t c = 0; c < cases::kLeftOut; ++c)
	{
		const LatticeCase& entry = cases::latticeCases()[c];
		std::array<LatticeEdge, cases::kMaxLatticeEdges> edges = entry.edge;
		if (turned && entry.edges)
		{
			std::reverse(edges.begin(), edges.begin() + entry.edges);
			std::fill(edges.begin() + entry.edges, edges.end(), edges[0]);
		}
		table[c].corners = entry.edges;
		for (std::size_t e = 0; e < edges.size(); ++e)
		{
			table[c].row[e] = edges[e].row;
			table[c].number[e] = static_cast<std::uint8_t>(4 * edges[e].at + edges[e].axis);
		}
	}
	return table;
}

} // namespace

const CornerTable& cornerTable(bool turned)
{
	static const std::array<CornerTable, 2> tables{makeCornerTable(false), makeCornerTable(true)};
	return tables[turned];
}

const OwnedTable& ownedTable()
{
	static const OwnedTable table = []
	{
		OwnedTable made;
		for (std::size_t c = 0; c < made.size(); ++c)
			for (unsigned axis = 0; axis < 3; ++axis)
			{
				const std::uint32_t owned = cases::latticeCases()[c % cases::kLeftOut].owned >> axis & 1;
				made[c].up_to[axis + 1] = made[c].up_to[axis] + owned;
				made[c].bytes[axis + 1] = made[c].up_to[axis + 1] * sizeof(EdgePoint);
			}
		return made;
	}();
	return table;
}

} // namespace vp::mesh
