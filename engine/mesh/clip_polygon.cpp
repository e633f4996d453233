#include "mesh/clip_polygon.h"

#include "mesh/rim_chains.h"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace vp::mesh
{

namespace
{

std::uint64_t edgeKeyOf(std::uint32_t a, std::uint32_t b)
{
	return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

} // namespace

PolygonClipper::PolygonClipper(const Vec3& origin, std::span<const ClipSide> sides, Corners corners, SheetMesh& mesh)
    : origin_(origin), sides_(sides), corners_(corners), mesh_(mesh), first_made_(mesh.positions.size())
{
	assert(sides.size() <= kMaxClipSides);
	for (std::size_t side = 0; side < sides.size(); ++side)
		numbers_.emplace_back(16);
}

// Returns how far a vertex lies within a side.
double PolygonClipper::within(std::uint32_t v, unsigned side) const
{
	return glm::dot(mesh_.positions[v] - origin_, sides_[side].axis) - sides_[side].least;
}

bool PolygonClipper::clip(std::span<const std::uint32_t> polygon, std::span<const std::uint8_t> is_added)
{
	others_.clear();
	part_.corners.assign(polygon.begin(), polygon.end());
	part_.is_added.assign(is_added.begin(), is_added.end());
	bool has_corner = false;
	for (unsigned side = 0; side < sides_.size(); ++side)
	{
		has_corner = clipPart(side) || has_corner;
		for (std::size_t other = 0, count = others_.size(); other < count; ++other)
		{
			std::swap(part_, others_[other]);
			has_corner = clipPart(side) || has_corner;
			std::swap(part_, others_[other]);
		}
		std::erase_if(others_, [](const Loop& other) { return other.corners.size() < 3; });
	}
	if (has_corner && corners_ == Corners::skip)
		others_.clear();
	if (part_.corners.size() < 3 || (has_corner && corners_ == Corners::skip))
	{
		part_.corners.clear();
		part_.is_added.clear();
	}
	if (part_.corners.empty() && others_.empty())
		return false;
	if (part_.corners.empty())
	{
		part_ = std::move(others_.back());
		others_.pop_back();
	}
	return true;
}

bool PolygonClipper::clipPart(unsigned side)
{
	return std::ranges::any_of(part_.corners, [&](std::uint32_t v) { return within(v, side) < 0.0; }) && clipAt(side);
}

// Returns whether a corner of the window became a vertex: an edge of the rim was cut.
bool PolygonClipper::clipAt(unsigned side)
{
	bool has_corner = false;
	std::swap(part_, whole_);
	part_.corners.clear();
	part_.is_added.clear();
	const bool has_added = !whole_.is_added.empty();
	int times_out = 0;
	const auto add = [&](std::uint32_t v, bool is_added)
	{
		if (!part_.corners.empty() && part_.corners.back() == v)
			return;
		part_.corners.push_back(v);
		if (has_added)
			part_.is_added.push_back(is_added);
	};
	std::uint32_t previous = whole_.corners.back();
	double previous_within = within(previous, side);
	for (std::size_t i = 0; i < whole_.corners.size(); ++i)
	{
		const std::uint32_t v = whole_.corners[i];
		const double v_within = within(v, side);
		// A vertex on the side itself is its own cut.
		if ((previous_within < 0.0 && v_within > 0.0) || (previous_within > 0.0 && v_within < 0.0))
		{
			add(cutOf(previous, v, side), false);
			has_corner = has_corner || (isOnRim(previous) && isOnRim(v));
		}
		if (v_within >= 0.0)
			add(v, staysAdded(i, side));
		times_out += previous_within >= 0.0 && v_within < 0.0;
		previous = v;
		previous_within = v_within;
	}
	while (part_.corners.size() > 1 && part_.corners.back() == part_.corners.front())
	{
		part_.corners.pop_back();
		part_.is_added.resize(has_added ? part_.corners.size() : 0);
	}
	if (times_out > 1 && mesh_.flat) // else the ends do not lie on one line
		partAlong(side);
	return has_corner;
}

// Returns true if corner i of whole_ stays an added corner. On the side itself it may be the end of the rest of its
// polygon's side.
bool PolygonClipper::staysAdded(std::size_t i, unsigned side) const
{
	return !whole_.is_added.empty() && whole_.is_added[i] && within(whole_.corners[i], side) > 0.0;
}

// Splits the rest of whole_ if it leaves the side more than once, because the way along the side leads through
// places outside the polygon.
void PolygonClipper::partAlong(unsigned side)
{
	std::vector<std::uint32_t> added;
	for (std::size_t i = 0; i < whole_.corners.size(); ++i)
		if (staysAdded(i, side))
			added.push_back(whole_.corners[i]);
	std::vector<std::vector<std::uint32_t>> chains;
	const auto begin = std::ranges::find_if(whole_.corners, [&](std::uint32_t v) { return within(v, side) < 0.0; });
	std::rotate(whole_.corners.begin(), begin, whole_.corners.end());
	std::uint32_t previous = whole_.corners.front();
	for (std::size_t i = 1; i <= whole_.corners.size(); ++i)
	{
		const std::uint32_t v = whole_.corners[i % whole_.corners.size()];
		const double before = within(previous, side);
		const double here = within(v, side);
		if (before < 0.0 && here >= 0.0)
			chains.emplace_back();
		if ((before < 0.0 && here > 0.0) || (before > 0.0 && here < 0.0))
			chains.back().push_back(cutOf(previous, v, side));
		if (here >= 0.0)
			chains.back().push_back(v);
		previous = v;
	}
	std::erase_if(chains, [](const auto& chain) { return chain.size() < 2; }); // touches the side
	const bool has_added = !whole_.is_added.empty();
	part_.corners.clear();
	part_.is_added.clear();
	bool is_first = true;
	for (std::vector<std::uint32_t>& corners : joinAlongRim(chains, mesh_.positions.data()))
	{
		Loop loop{std::move(corners), {}};
		for (const std::uint32_t v : loop.corners)
			if (has_added)
				loop.is_added.push_back(std::ranges::find(added, v) != added.end());
		if (std::exchange(is_first, false))
			part_ = std::move(loop);
		else
			others_.push_back(std::move(loop));
	}
}

// The vertex where the edge between two crosses the side. Interpolated from the one that comes first by its
// coordinates, so that it does not depend on how vertices are numbered.
std::uint32_t PolygonClipper::cutOf(std::uint32_t a, std::uint32_t b, unsigned side)
{
	const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
	const auto [number, is_new] = numbers_[side].find(edgeKeyOf(a, b), next);
	if (is_new)
	{
		const auto placeOf = [&](std::uint32_t v)
		{
			const Vec3& p = mesh_.positions[v];
			return std::tuple(p.x, p.y, p.z);
		};
		if (placeOf(b) < placeOf(a))
			std::swap(a, b);
		const double t = within(a, side) / (within(a, side) - within(b, side));
		const Vec3 place = mesh_.positions[a] + t * (mesh_.positions[b] - mesh_.positions[a]);
		mesh_.positions.push_back(place);
		addShares(mesh_, a, 1.0 - t, mesh_.rim_shares);
		addShares(mesh_, b, t, mesh_.rim_shares);
		mesh_.rim_starts.push_back(static_cast<std::uint32_t>(mesh_.rim_shares.size()));
		made_.push_back({a, b, side});
	}
	return number;
}

void PolygonClipper::pairAcrossSeams(unsigned side)
{
	if (mesh_.seam_pairs.empty())
		return;
	std::unordered_multimap<std::uint32_t, std::uint32_t> partners;
	for (const auto& [v, w] : mesh_.seam_pairs)
	{
		partners.emplace(v, w);
		partners.emplace(w, v);
	}
	// The edges may also have an end in common.
	const auto withPartners = [&](std::uint32_t v)
	{
		std::vector<std::uint32_t> all{v};
		const auto [begin, end] = partners.equal_range(v);
		for (auto partner = begin; partner != end; ++partner)
			all.push_back(partner->second);
		return all;
	};
	const auto none = static_cast<std::uint32_t>(mesh_.positions.size());
	for (std::size_t m = 0; m < made_.size(); ++m)
	{
		const Cut& cut = made_[m];
		if (cut.side != side)
			continue;
		const auto v = static_cast<std::uint32_t>(first_made_ + m);
		for (const std::uint32_t a : withPartners(cut.from))
			for (const std::uint32_t b : withPartners(cut.to))
			{
				const auto found = numbers_[side].find(edgeKeyOf(a, b), none);
				if (!found.is_new && found.number > v && found.number < none)
					mesh_.seam_pairs.emplace_back(v, found.number);
			}
	}
}

} // namespace vp::mesh
