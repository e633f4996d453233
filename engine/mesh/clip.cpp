#include "mesh/clip.h"

#include "base/key_numbers.h"
#include "mesh/rim_chains.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <tuple>
#include <unordered_map>
#include <utility>

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

	// A polygon, or a part of one.
	struct Loop
	{
		std::vector<std::uint32_t> corners;
		std::vector<std::uint8_t> is_added; // per corner; empty if no corner is added (SheetMesh::is_added)
	};

	// Another part of a polygon that clipping has split, after the first.
	struct More
	{
		Loop loop;
		std::size_t polygon;
		BlockCell cell;
	};

	// Returns how far a vertex lies within a side.
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
				std::span<const std::uint8_t> added;
				if (!is_added.empty())
					added = std::span(is_added).subspan(starts[p], corners);
				if (!takePart(std::span(vertices).subspan(starts[p], corners), added, p))
					mesh_.boundary_polygons -= p >= of_cells;
			}
		}
		mesh_.polygon_vertices.resize(corners_kept_);
		mesh_.is_added.resize(is_added.empty() ? 0 : corners_kept_);
		mesh_.polygon_starts.resize(kept_ + 1);
		mesh_.polygon_cells.resize(kept_);
		placeMore(of_cells);
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
	// Takes what is left of a polygon: of one that is not convex perhaps several parts, of which all but the first wait
	// for their places. Returns false where that is nothing.
	bool takePart(std::span<const std::uint32_t> polygon, std::span<const std::uint8_t> is_added, std::size_t p)
	{
		clipToSides(polygon, is_added);
		if (part_.corners.empty() && others_.empty())
			return false;
		if (part_.corners.empty())
		{
			part_ = std::move(others_.back());
			others_.pop_back();
		}
		for (Loop& other : others_)
			more_.push_back({std::move(other), p, mesh_.polygon_cells[p]});
		makeRoom(part_.corners.size());
		const auto to = static_cast<std::ptrdiff_t>(corners_kept_);
		std::ranges::copy(part_.corners, mesh_.polygon_vertices.begin() + to);
		if (!part_.is_added.empty())
			std::ranges::copy(part_.is_added, mesh_.is_added.begin() + to);
		corners_kept_ += part_.corners.size();
		mesh_.polygon_cells[kept_++] = mesh_.polygon_cells[p];
		mesh_.polygon_starts[kept_] = static_cast<std::uint32_t>(corners_kept_);
		return true;
	}
	// Puts the parts that wait behind the polygons of their kind, which are those of cells or boundary faces.
	void placeMore(std::size_t of_cells)
	{
		if (more_.empty())
			return;
		const std::size_t kept_of_cells = kept_ - mesh_.boundary_polygons;
		const bool has_added = !mesh_.is_added.empty();
		RawVector<std::uint32_t> starts{0};
		RawVector<std::uint32_t> vertices;
		std::vector<std::uint8_t> is_added;
		RawVector<BlockCell> cells;
		const auto add =
		    [&](std::span<const std::uint32_t> corners, std::span<const std::uint8_t> added, BlockCell cell)
		{
			vertices.insert(vertices.end(), corners.begin(), corners.end());
			is_added.insert(is_added.end(), added.begin(), added.end());
			starts.push_back(static_cast<std::uint32_t>(vertices.size()));
			cells.push_back(cell);
		};
		for (const bool boundary : {false, true})
		{
			for (std::size_t p = boundary ? kept_of_cells : 0; p < (boundary ? kept_ : kept_of_cells); ++p)
			{
				std::span<const std::uint8_t> added;
				if (has_added)
					added = std::span(mesh_.is_added).subspan(mesh_.polygon_starts[p], mesh_.polygon(p).size());
				add(mesh_.polygon(p), added, mesh_.polygon_cells[p]);
			}
			for (const More& more : more_)
				if ((more.polygon >= of_cells) == boundary)
				{
					add(more.loop.corners, more.loop.is_added, more.cell);
					mesh_.boundary_polygons += boundary;
				}
		}
		mesh_.polygon_starts = std::move(starts);
		mesh_.polygon_vertices = std::move(vertices);
		mesh_.is_added = std::move(is_added);
		mesh_.polygon_cells = std::move(cells);
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

	// Leaves in part_ and others_ what is left of a polygon with vertices outside; no corners where that is no polygon.
	void clipToSides(std::span<const std::uint32_t> polygon, std::span<const std::uint8_t> is_added)
	{
		others_.clear();
		part_.corners.clear();
		part_.is_added.clear();
		unsigned all = ~0u;
		for (const std::uint32_t v : polygon)
			all &= outside_[v];
		if (all != 0)
			return;
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
	}

	bool clipPart(unsigned side)
	{
		return std::ranges::any_of(part_.corners, [&](std::uint32_t v) { return within(v, side) < 0.0; }) &&
		       clipAt(side);
	}

	// Returns whether a corner of the window became a vertex: an edge of the rim was cut.
	bool clipAt(unsigned side)
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
	bool staysAdded(std::size_t i, unsigned side) const
	{
		return !whole_.is_added.empty() && whole_.is_added[i] && within(whole_.corners[i], side) > 0.0;
	}

	// Splits the rest of whole_ if it leaves the side more than once, because the way along the side leads through
	// places outside the polygon.
	void partAlong(unsigned side)
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
	Loop part_;
	Loop whole_;               // what part_ is clipped from
	std::vector<Loop> others_; // parts of the same polygon
	std::vector<More> more_;
	std::size_t kept_ = 0; // polygons that are there so far
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
