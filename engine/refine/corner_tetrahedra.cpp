#include "refine/corner_tetrahedra.h"

#include <algorithm>

namespace vp::refine
{

void splitCorners(grid::CellShape shape, std::span<const std::uint32_t> ids,
                  std::vector<std::array<std::uint8_t, 4>>& tetrahedra)
{
	tetrahedra.clear();
	const auto apex = static_cast<std::uint8_t>(std::ranges::min_element(ids) - ids.begin());
	const auto add = [&](std::uint8_t a, std::uint8_t b, std::uint8_t c)
	{
		std::array<std::uint32_t, 4> sorted{ids[apex], ids[a], ids[b], ids[c]};
		std::ranges::sort(sorted);
		if (std::ranges::adjacent_find(sorted) == sorted.end())
			tetrahedra.push_back({apex, a, b, c});
	};
	const grid::ShapeTopology& topology = grid::topology(shape);
	for (int f = 0; f < topology.faces; ++f)
	{
		const std::span<const std::uint8_t> face = topology.facePoints(f);
		if (std::ranges::find(face, apex) != face.end())
			continue;
		const auto first = static_cast<std::size_t>(
		    std::ranges::min_element(face, {}, [&](std::uint8_t corner) { return ids[corner]; }) - face.begin());
		const auto corner = [&](std::size_t i) { return face[(first + i) % face.size()]; };
		for (std::size_t i = 1; i + 1 < face.size(); ++i)
			add(corner(0), corner(i), corner(i + 1));
	}
}

} // namespace vp::refine
