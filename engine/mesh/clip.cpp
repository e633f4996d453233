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
		// Those of a window are two pairs that face each other: one product tells of both.
		const auto faceEachOther = [&](std::size_t a, std::size_t b) { return sides_[a].axis == -sides_[b].axis; };
		if (sides_.size() == 4 && faceEachOther(0, 1) && faceEachOther(2, 3))
			return findOutside(begin, end,
			                   [x = sides_[0].axis, y = sides_[2].axis, x0 = sides_[0].least, x1 = -sides_[1].least,
			                    y0 = sides_[2].least, y1 = -sides_[3].least](const Vec3& way)
			                   {
				                   const double along_x = glm::dot(way, x);
				                   const double along_y = glm::dot(way, y);
				                   return static_cast<unsigned>(along_x < x0) |
				                          static_cast<unsigned>(along_x > x1) << 1 |
				                          static_cast<unsigned>(along_y < y0) << 2 |
				                          static_cast<unsigned>(along_y > y1) << 3;
			                   });
		std::array<ClipSide, kMaxClipSides> sides;
		std::ranges::copy(sides_, sides.begin());
		return findOutside(begin, end,
		                   [sides, count = sides_.size()](const Vec3& way)
		                   {
			                   unsigned outside = 0;
			                   for (std::size_t side = 0; side < count; ++side)
				                   outside |= static_cast<unsigned>(glm::dot(way, sides[side].axis) < sides[side].least)
				                              << side;
			                   return outside;
		                   });
	}
	// outsideOf(way from the origin): the bits.
	template <class OutsideOf>
	bool findOutside(std::size_t begin, std::size_t end, OutsideOf outsideOf)
	{
		// Copies, that what is written cannot be thought to change what is read.
		const Vec3 origin = origin_;
		const Vec3* positions = mesh_.positions.data();
		std::uint8_t* outside = outside_.data();
		unsigned found = 0;
		for (std::size_t v = begin; v < end; ++v)
		{
			const unsigned of_vertex = outsideOf(positions[v] - origin);
			outside[v] = static_cast<std::uint8_t>(of_vertex);
			found |= of_vertex;
		}
		return found != 0;
	}

	// Polygons that lie within all sides move down as they are, all between two others at once.
	void takePolygons()
	{
		RawVector<std::uint32_t> starts = std::move(mesh_.polygon_starts);
		RawVector<std::uint32_t> vertices = std::move(mesh_.polygon_vertices);
		const std::vector<std::uint8_t> is_added = std::move(mesh_.is_added);
		mesh_.is_added.assign(is_added.size(), 0);
		const std::size_t count = mesh_.polygons();
		const std::size_t of_cells = count - mesh_.boundary_polygons;
		mesh_.polygon_starts.resize(count + 1);
		mesh_.polygon_starts[0] = 0;
		mesh_.polygon_vertices.resize(vertices.size());
		for (std::size_t p = 0; p < count;)
		{
			const std::size_t next = firstOutside(vertices, starts, p);
			keep(starts, vertices, is_added, p, next);
			for (p = next; p < count && isAnyOutside(vertices, starts[p], starts[p + 1]); ++p)
			{
				const std::uint32_t corners = starts[p + 1] - starts[p];
				whole_is_added_.clear();
				if (!is_added.empty())
					whole_is_added_.assign(is_added.begin() + starts[p], is_added.begin() + starts[p + 1]);
				if (!takePart(std::span(vertices).subspan(starts[p], corners), p))
					mesh_.boundary_polygons -= p >= of_cells;
			}
		}
		mesh_.polygon_vertices.resize(corners_kept_);
		mesh_.is_added.resize(is_added.empty() ? 0 : corners_kept_);
		mesh_.polygon_starts.resize(kept_ + 1);
		mesh_.polygon_cells.resize(kept_);
	}

	bool isAnyOutside(const RawVector<std::uint32_t>& vertices, std::size_t begin, std::size_t end) const
	{
		unsigned any = 0;
		for (std::size_t corner = begin; corner < end; ++corner)
			any |= outside_[vertices[corner]];
		return any != 0;
	}
	// Returns the first polygon from `p` on that has a vertex outside, or how many there are.
	std::size_t firstOutside(const RawVector<std::uint32_t>& vertices, const RawVector<std::uint32_t>& starts,
	                         std::size_t p) const
	{
		constexpr std::size_t kAtOnce = 8; // polygons
		const std::size_t count = mesh_.polygons();
		while (p + kAtOnce <= count && !isAnyOutside(vertices, starts[p], starts[p + kAtOnce]))
			p += kAtOnce;
		while (p < count && !isAnyOutside(vertices, starts[p], starts[p + 1]))
			++p;
		return p;
	}

	// Takes the polygons [begin, end) whole.
	void keep(const RawVector<std::uint32_t>& starts, const RawVector<std::uint32_t>& vertices,
	          const std::vector<std::uint8_t>& is_added, std::size_t begin, std::size_t end)
	{
		const std::size_t first = starts[begin];
		const std::size_t corners = starts[end] - first;
		makeRoom(corners);
		std::copy_n(vertices.begin() + static_cast<std::ptrdiff_t>(first), corners,
		            mesh_.polygon_vertices.begin() + static_cast<std::ptrdiff_t>(corners_kept_));
		if (!is_added.empty())
			std::copy_n(is_added.data() + first, corners, mesh_.is_added.data() + corners_kept_);
		std::uint32_t* to = mesh_.polygon_starts.data() + kept_;
		const auto moved = static_cast<std::uint32_t>(corners_kept_ - first); // modulo 2^32
		for (std::size_t p = begin; p < end; ++p)
			*++to = starts[p + 1] + moved;
		std::copy_n(mesh_.polygon_cells.begin() + static_cast<std::ptrdiff_t>(begin), end - begin,
		            mesh_.polygon_cells.begin() + static_cast<std::ptrdiff_t>(kept_));
		kept_ += end - begin;
		corners_kept_ += corners;
	}
	// Takes what is left of a polygon. Returns false where that is nothing.
	bool takePart(std::span<const std::uint32_t> polygon, std::size_t p)
	{
		const std::span<const std::uint32_t> part = partOf(polygon);
		if (part.empty())
			return false;
		makeRoom(part.size());
		std::ranges::copy(part, mesh_.polygon_vertices.begin() + static_cast<std::ptrdiff_t>(corners_kept_));
		std::ranges::copy(part_is_added_, mesh_.is_added.begin() + static_cast<std::ptrdiff_t>(corners_kept_));
		corners_kept_ += part.size();
		mesh_.polygon_cells[kept_++] = mesh_.polygon_cells[p];
		mesh_.polygon_starts[kept_] = static_cast<std::uint32_t>(corners_kept_);
		return true;
	}
	// A polygon may get corners on the rim.
	void makeRoom(std::size_t corners)
	{
		if (corners_kept_ + corners <= mesh_.polygon_vertices.size())
			return;
		mesh_.polygon_vertices.resize(2 * (corners_kept_ + corners));
		if (!mesh_.is_added.empty())
			mesh_.is_added.resize(mesh_.polygon_vertices.size());
	}

	// What is left of a polygon with vertices outside; nothing where that is no polygon.
	std::span<const std::uint32_t> partOf(std::span<const std::uint32_t> polygon)
	{
		unsigned all = ~0u;
		for (const std::uint32_t v : polygon)
			all &= outside_[v];
		if (all != 0)
			return {};
		part_.assign(polygon.begin(), polygon.end());
		part_is_added_ = whole_is_added_;
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
		std::swap(part_is_added_, whole_is_added_);
		part_.clear();
		part_is_added_.clear();
		const bool has_added = !whole_is_added_.empty();
		const auto add = [&](std::uint32_t v, bool is_added)
		{
			if (!part_.empty() && part_.back() == v)
				return;
			part_.push_back(v);
			if (has_added)
				part_is_added_.push_back(is_added);
		};
		std::uint32_t previous = whole_.back();
		double previous_within = within(previous, side);
		for (std::size_t i = 0; i < whole_.size(); ++i)
		{
			const std::uint32_t v = whole_[i];
			const double v_within = within(v, side);
			// A vertex on the side itself is its own cut.
			if ((previous_within < 0.0 && v_within > 0.0) || (previous_within > 0.0 && v_within < 0.0))
			{
				add(cutOf(previous, v, side), false);
				has_corner = has_corner || (isOnRim(previous) && isOnRim(v));
			}
			// An added corner on the side itself may be the end of what is left of its polygon's side.
			if (v_within >= 0.0)
				add(v, has_added && whole_is_added_[i] && v_within > 0.0);
			previous = v;
			previous_within = v_within;
		}
		while (part_.size() > 1 && part_.back() == part_.front())
		{
			part_.pop_back();
			part_is_added_.resize(has_added ? part_.size() : 0);
		}
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
					const auto found = numbers_[side].find(keyOf(a, b), none);
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
	std::vector<std::uint32_t> whole_;         // what part_ is clipped from
	std::vector<std::uint8_t> part_is_added_;  // of each corner; empty where none is (SheetMesh::is_added)
	std::vector<std::uint8_t> whole_is_added_; // as `whole_`
	std::size_t kept_ = 0;                     // polygons that are there so far
	std::size_t corners_kept_ = 0;
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
