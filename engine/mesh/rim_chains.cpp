#include "mesh/rim_chains.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace vp::mesh
{

namespace
{

struct RimEnd
{
	double along; // the side
	std::size_t chain;
	bool comes_in;
};

// The ends in their order along the side, whichever way it runs.
std::vector<RimEnd> sortedEnds(std::span<const std::vector<std::uint32_t>> chains, const Vec3* positions)
{
	Box box;
	for (const std::vector<std::uint32_t>& chain : chains)
	{
		box.include(positions[chain.front()]);
		box.include(positions[chain.back()]);
	}
	const Vec3 size = box.size();
	const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
	std::vector<RimEnd> ends;
	for (std::size_t c = 0; c < chains.size(); ++c)
	{
		ends.push_back({positions[chains[c].front()][axis], c, true});
		ends.push_back({positions[chains[c].back()][axis], c, false});
	}
	std::ranges::stable_sort(ends, {}, &RimEnd::along);
	// The two ways along a bridge meet the side at one place: what is open is closed first.
	int open = 0;
	for (std::size_t i = 0; i < ends.size(); ++i)
	{
		if (i + 1 < ends.size() && ends[i].along == ends[i + 1].along && open != 0 && (open > 0) == ends[i].comes_in)
			std::swap(ends[i], ends[i + 1]);
		open += ends[i].comes_in ? 1 : -1;
	}
	return ends;
}

} // namespace

std::vector<std::vector<std::uint32_t>> joinAlongRim(std::span<const std::vector<std::uint32_t>> chains,
                                                     const Vec3* positions)
{
	// As crossings of a face (cases/cell_walk.h): each goes with the next one that runs the other way.
	std::vector<std::size_t> next(chains.size());
	std::vector<RimEnd> open;
	for (const RimEnd& end : sortedEnds(chains, positions))
	{
		if (open.empty() || open.back().comes_in == end.comes_in)
		{
			open.push_back(end);
			continue;
		}
		next[end.comes_in ? open.back().chain : end.chain] = end.comes_in ? end.chain : open.back().chain;
		open.pop_back();
	}
	std::vector<std::vector<std::uint32_t>> polygons;
	std::vector<char> is_taken(chains.size(), 0);
	for (std::size_t first = 0; first < chains.size(); ++first)
	{
		std::vector<std::uint32_t> polygon;
		for (std::size_t c = first; !is_taken[c]; c = next[c])
		{
			is_taken[c] = 1;
			for (const std::uint32_t v : chains[c])
				if (polygon.empty() || polygon.back() != v)
					polygon.push_back(v);
		}
		while (polygon.size() > 1 && polygon.back() == polygon.front())
			polygon.pop_back();
		if (polygon.size() >= 3)
			polygons.push_back(std::move(polygon));
	}
	return polygons;
}

} // namespace vp::mesh
