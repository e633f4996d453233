#include "gmsh_twice.h"

#include "gmsh_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>

namespace vp::reader::meshes
{

namespace
{

// Elements of one hash that are compared with each other, at the most.
constexpr std::size_t kMaxCompared = 16;

using Index = std::int64_t;

std::span<const Index> cornersOf(const GmshMesh& mesh, Index element)
{
	const auto at = static_cast<std::size_t>(element);
	return std::span(mesh.corners)
	    .subspan(static_cast<std::size_t>(mesh.offsets[at]),
	             static_cast<std::size_t>(mesh.offsets[at + 1] - mesh.offsets[at]));
}

bool isTwin(const GmshMesh& mesh, Index a, Index b)
{
	const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
	return mesh.types[i] == mesh.types[j] && mesh.entity[i] == mesh.entity[j] &&
	       std::ranges::equal(cornersOf(mesh, a), cornersOf(mesh, b));
}

std::uint64_t hashOf(std::span<const Index> corners)
{
	std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a, by words
	for (const Index corner : corners)
		hash = (hash ^ static_cast<std::uint64_t>(corner)) * 0x100000001b3;
	return hash;
}

// Those of entities whose elements name more than one group, by hash and then in their order.
std::vector<std::pair<std::uint64_t, Index>> candidates(const GmshMesh& mesh)
{
	std::map<std::pair<std::uint8_t, std::int32_t>, std::pair<std::int32_t, bool>> groups;
	for (std::size_t e = 0; e < mesh.types.size(); ++e)
	{
		const auto [place, is_new] = groups.try_emplace({mesh.types[e], mesh.entity[e]}, mesh.physical[e], false);
		place->second.second |= place->second.first != mesh.physical[e];
	}
	std::vector<std::pair<std::uint64_t, Index>> found;
	for (std::size_t e = 0; e < mesh.types.size(); ++e)
		if (groups[{mesh.types[e], mesh.entity[e]}].second)
			found.emplace_back(hashOf(cornersOf(mesh, static_cast<Index>(e))), static_cast<Index>(e));
	std::sort(found.begin(), found.end());
	return found;
}

template <class Value>
void keepOnly(std::vector<Value>& values, const std::vector<Index>& place_of)
{
	if (values.empty())
		return;
	std::size_t kept = 0;
	for (std::size_t e = 0; e < place_of.size(); ++e)
		if (place_of[e] >= 0)
			values[kept++] = values[e];
	values.resize(kept);
}

// Takes out the elements that have a twin.
void takeOut(GmshMesh& mesh, const std::vector<Index>& twin_of)
{
	std::vector<Index> place_of(twin_of.size(), -1);
	std::vector<Index> offsets{0}, corners;
	Index kept = 0;
	for (std::size_t e = 0; e < twin_of.size(); ++e)
		if (twin_of[e] < 0)
		{
			const auto own = cornersOf(mesh, static_cast<Index>(e));
			corners.insert(corners.end(), own.begin(), own.end());
			offsets.push_back(static_cast<Index>(corners.size()));
			place_of[e] = kept++;
		}
	for (std::size_t e = 0; e < twin_of.size(); ++e)
		if (twin_of[e] >= 0)
			mesh.other_tags.emplace_back(mesh.tags[e], place_of[static_cast<std::size_t>(twin_of[e])]);
	mesh.offsets = std::move(offsets);
	mesh.corners = std::move(corners);
	for (auto* values : {&mesh.physical, &mesh.entity, &mesh.partition})
		keepOnly(*values, place_of);
	keepOnly(mesh.types, place_of);
	keepOnly(mesh.tags, place_of);
	keepOnly(mesh.ghost, place_of);
	std::map<Index, std::vector<std::int32_t>> more;
	for (auto& [element, groups] : mesh.more_groups)
		more[place_of[static_cast<std::size_t>(element)]] = std::move(groups);
	mesh.more_groups = std::move(more);
}

} // namespace

void joinGmshTwins(GmshMesh& mesh)
{
	const auto all = candidates(mesh);
	std::vector<Index> twin_of(mesh.types.size(), -1);
	bool has_twins = false;
	for (std::size_t begin = 0; begin < all.size();)
	{
		std::vector<Index> first; // elements that differ from each other
		std::size_t end = begin;
		for (; end < all.size() && all[end].first == all[begin].first; ++end)
		{
			const Index element = all[end].second;
			const auto own = std::ranges::find_if(first, [&](Index other) { return isTwin(mesh, other, element); });
			if (own == first.end())
			{
				if (first.size() < kMaxCompared)
					first.push_back(element);
				continue;
			}
			const std::int32_t group = mesh.physical[static_cast<std::size_t>(element)];
			const auto more = mesh.more_groups.find(*own);
			const bool has_group =
			    mesh.physical[static_cast<std::size_t>(*own)] == group ||
			    (more != mesh.more_groups.end() && std::ranges::find(more->second, group) != more->second.end());
			if (has_group)
				continue; // it stands there twice
			mesh.more_groups[*own].push_back(group);
			twin_of[static_cast<std::size_t>(element)] = *own;
			has_twins = true;
		}
		begin = end;
	}
	if (has_twins)
		takeOut(mesh, twin_of);
}

} // namespace vp::reader::meshes
