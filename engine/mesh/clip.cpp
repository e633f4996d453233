#include "mesh/clip.h"

#include "base/key_numbers.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <tuple>
#include <unordered_map>

namespace vp::mesh
{

namespace
{

// Clips the polygons that cross the rim at one side after the other; the others are kept or left out as they are.
class Clipper
{
public:
	Clipper(const Vec3& origin, std::span<const ClipSide> sides, Corners corners, SheetMesh& mesh)
	    : origin_(origin), sides_(sides), corners_(corners), mesh_(mesh), first_made_(mesh.positions.size())
	{
		assert(sides.size() <= kMaxClipSides);
		for (std::size_t side = 0; side < sides.size(); ++side)
			numbers_.emplace_back(16);
	}

	void clip()
	{
		if (findOutside())
		{
			takePolygons();
			for (unsigned side = 0; side < sides_.size(); ++side)
				pairAcrossSeams(side);
		}
		dropUnusedVertices(mesh_);
	}

private:
	// A vertex made on the rim, where a side cuts the edge between two others.
	struct Cut
	{
		std::uint32_t from;
		std::uint32_t to;
		unsigned side;
	};

	// How far a vertex lies within a side.
	double within(std::uint32_t v, unsigned side) const
	{
		return glm::dot(mesh_.positions[v] - origin_, sides_[side].axis) - sides_[side].least;
	}
	// Per vertex a bit for each side that it lies outside of. Returns whether there are any.
	bool findOutside()
	{
		outside_.resize(mesh_.positions.size());
		std::atomic<bool> any{false};
		constexpr std::size_t kGrain = 4096;
		tbb::parallel_for(tbb::blocked_range<std::size_t>(0, outside_.size(), kGrain),
		                  [&](const auto& range)
		                  {
			                  if (findOutside(range.begin(), range.end()))
				                  any = true;
		                  });
		return any;
	}
	bool findOutside(std::size_t begin, std::size_t end)
	{
		// Copies, that what is written cannot be thought to change what is read.
		std::array<ClipSide, kMaxClipSides> sides;
		std::ranges::copy(sides_, sides.begin());
		const std::size_t count = sides_.size();
		const Vec3 origin = origin_;
		const Vec3* positions = mesh_.positions.data();
		std::uint8_t* outside = outside_.data();
		unsigned found = 0;
		for (std::size_t v = begin; v < end; ++v)
		{
			const Vec3 way = positions[v] - origin;
			unsigned of_vertex = 0;
			for (std::size_t side = 0; side < count; ++side)
				of_vertex |= static_cast<unsigned>(glm::dot(way, sides[side].axis) - sides[side].least < 0.0) << side;
			outside[v] = static_cast<std::uint8_t>(of_vertex);
			found |= of_vertex;
		}
		return found != 0;
	}

	void takePolygons()
	{
		RawVector<std::uint32_t> starts;
		RawVector<std::uint32_t> vertices;
		starts.resize(mesh_.polygon_starts.size());
		starts[0] = 0;
		vertices.resize(mesh_.polygon_vertices.size());
		std::size_t corners = 0;
		std::size_t kept = 0;
		const std::size_t of_cells = mesh_.polygons() - mesh_.boundary_polygons;
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
		{
			const std::span<const std::uint32_t> part = partOf(mesh_.polygon(p));
			if (part.empty())
			{
				mesh_.boundary_polygons -= p >= of_cells;
				continue;
			}
			if (corners + part.size() > vertices.size()) // a polygon may get corners on the rim
				vertices.resize(2 * (corners + part.size()));
			for (const std::uint32_t v : part)
				vertices[corners++] = v;
			mesh_.polygon_cells[kept++] = mesh_.polygon_cells[p];
			starts[kept] = static_cast<std::uint32_t>(corners);
		}
		vertices.resize(corners);
		starts.resize(kept + 1);
		mesh_.polygon_cells.resize(kept);
		mesh_.polygon_starts = std::move(starts);
		mesh_.polygon_vertices = std::move(vertices);
	}

	// What is left of a polygon; nothing where that is no polygon.
	std::span<const std::uint32_t> partOf(std::span<const std::uint32_t> polygon)
	{
		unsigned any = 0;
		unsigned all = ~0u;
		for (const std::uint32_t v : polygon)
		{
			any |= outside_[v];
			all &= outside_[v];
		}
		if (any == 0)
			return polygon;
		if (all != 0)
			return {};
		part_.assign(polygon.begin(), polygon.end());
		bool has_corner = false;
		for (unsigned side = 0; side < sides_.size() && !part_.empty(); ++side)
			if (std::ranges::any_of(part_, [&](std::uint32_t v) { return within(v, side) < 0.0; }))
				has_corner = clipAt(side) || has_corner;
		if (part_.size() < 3 || (has_corner && corners_ == Corners::skip))
			return {};
		return part_;
	}

	// Returns whether a corner of the window became a vertex: an edge of the rim was cut.
	bool clipAt(unsigned side)
	{
		bool has_corner = false;
		std::swap(part_, whole_);
		part_.clear();
		const auto add = [&](std::uint32_t v)
		{
			if (part_.empty() || part_.back() != v)
				part_.push_back(v);
		};
		std::uint32_t previous = whole_.back();
		double previous_within = within(previous, side);
		for (const std::uint32_t v : whole_)
		{
			const double v_within = within(v, side);
			// A vertex on the side itself is its own cut.
			if ((previous_within < 0.0 && v_within > 0.0) || (previous_within > 0.0 && v_within < 0.0))
			{
				add(cutOf(previous, v, side));
				has_corner = has_corner || (isOnRim(previous) && isOnRim(v));
			}
			if (v_within >= 0.0)
				add(v);
			previous = v;
			previous_within = v_within;
		}
		while (part_.size() > 1 && part_.back() == part_.front())
			part_.pop_back();
		return has_corner;
	}

	bool isOnRim(std::uint32_t v) const { return v >= first_made_; }

	static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b)
	{
		return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
	}

	// The vertex where the edge between two crosses the side. Interpolated from the one that comes first by its
	// coordinates, so that it does not depend on how vertices are numbered.
	std::uint32_t cutOf(std::uint32_t a, std::uint32_t b, unsigned side)
	{
		const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
		const auto [number, is_new] = numbers_[side].find(keyOf(a, b), next);
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
	// Where an edge lies on another across a seam, and both are cut at the side, the cuts are a pair as their ends are.
	void pairAcrossSeams(unsigned side)
	{
		if (mesh_.seam_pairs.empty())
			return;
		std::unordered_multimap<std::uint32_t, std::uint32_t> partners;
		for (const auto& [v, w] : mesh_.seam_pairs)
		{
			partners.emplace(v, w);
			partners.emplace(w, v);
		}
		const auto none = static_cast<std::uint32_t>(mesh_.positions.size());
		for (std::size_t m = 0; m < made_.size(); ++m)
		{
			const Cut& cut = made_[m];
			if (cut.side != side)
				continue;
			const auto v = static_cast<std::uint32_t>(first_made_ + m);
			const auto [a_begin, a_end] = partners.equal_range(cut.from);
			const auto [b_begin, b_end] = partners.equal_range(cut.to);
			for (auto other_a = a_begin; other_a != a_end; ++other_a)
				for (auto other_b = b_begin; other_b != b_end; ++other_b)
				{
					const auto found = numbers_[side].find(keyOf(other_a->second, other_b->second), none);
					if (!found.is_new && found.number > v && found.number < none)
						mesh_.seam_pairs.emplace_back(v, found.number);
				}
		}
	}

	Vec3 origin_;
	std::span<const ClipSide> sides_;
	Corners corners_;
	SheetMesh& mesh_;
	std::size_t first_made_; // vertex
	RawVector<std::uint8_t> outside_;
	std::vector<KeyNumbers> numbers_; // per side
	std::vector<Cut> made_;           // per vertex from first_made_
	std::vector<std::uint32_t> part_;
	std::vector<std::uint32_t> whole_; // what part_ is clipped from
};

} // namespace

void clipToSides(const Vec3& origin, std::span<const ClipSide> sides, Corners corners, SheetMesh& mesh)
{
	Clipper(origin, sides, corners, mesh).clip();
}

void clipToWindow(const probe::Sheet& content, Corners corners, SheetMesh& mesh)
{
	const probe::Window& window = *content.window;
	const ClipSide sides[] = {{content.xAxis(), window.x0},
	                          {-content.xAxis(), -window.x1},
	                          {content.up, window.y0},
	                          {-content.up, -window.y1}};
	clipToSides(content.origin, sides, corners, mesh);
}

} // namespace vp::mesh
