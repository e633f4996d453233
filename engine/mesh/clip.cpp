#include "mesh/clip.h"

#include "mesh/clip_outside.h"
#include "mesh/clip_polygon.h"

#include <algorithm>
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
	    : origin_(origin), sides_(sides), mesh_(mesh), polygon_(origin, sides, corners, mesh)
	{
	}

	void clip()
	{
		if (findOutside(origin_, sides_, mesh_.positions, outside_))
		{
			takePolygons();
			for (unsigned side = 0; side < sides_.size(); ++side)
				polygon_.pairAcrossSeams(side);
		}
		dropUnusedVertices(mesh_);
	}

private:
	// Another part of a polygon that clipping has split, after the first.
	struct More
	{
		PolygonClipper::Loop loop;
		std::size_t polygon;
		BlockCell cell;
	};

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
	// Returns true if a side has all vertices of a polygon outside.
	bool areAllOutside(std::span<const std::uint32_t> polygon) const
	{
		unsigned all = ~0u;
		for (const std::uint32_t v : polygon)
			all &= outside_[v];
		return all != 0;
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
		if (areAllOutside(polygon) || !polygon_.clip(polygon, is_added))
			return false;
		for (PolygonClipper::Loop& other : polygon_.others())
			more_.push_back({std::move(other), p, mesh_.polygon_cells[p]});
		const PolygonClipper::Loop& part = polygon_.part();
		makeRoom(part.corners.size());
		const auto to = static_cast<std::ptrdiff_t>(corners_kept_);
		std::ranges::copy(part.corners, mesh_.polygon_vertices.begin() + to);
		if (!part.is_added.empty())
			std::ranges::copy(part.is_added, mesh_.is_added.begin() + to);
		corners_kept_ += part.corners.size();
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

	Vec3 origin_;
	std::span<const ClipSide> sides_;
	SheetMesh& mesh_;
	PolygonClipper polygon_;
	RawVector<std::uint8_t> outside_; // per vertex
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
