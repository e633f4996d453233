#include "base/parallel_for.h"
#include "grid/check/quality.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>

namespace vp::grid
{

namespace
{

// The distinct points of a face, ascending.
std::vector<PointId> distinctPoints(std::span<const PointId> face)
{
	std::vector<PointId> points(face.begin(), face.end());
	std::ranges::sort(points);
	points.erase(std::unique(points.begin(), points.end()), points.end());
	return points;
}

// Faces within the block that three or more cells share by their points, entered at the lowest of them.
void sharedFaces(const UnstructuredGrid& grid, std::uint32_t block, Quality& quality)
{
	constexpr std::size_t chunk = 16384;
	std::vector<std::vector<std::vector<SetCell>>> found((grid.cellCount() + chunk - 1) / chunk);
	tracedFor(std::size_t(0), found.size(),
	          [&](std::size_t n)
	          {
		          CellFaces faces;
		          CellFaces others;
		          const auto inspect = [&](CellId cell, int f)
		          {
			          std::vector<CellId> across;
			          grid.forEachNeighbor(cell, f, [&](CellId other) { across.push_back(other); });
			          if (across.size() < 2 || std::ranges::any_of(across, [&](CellId other) { return other < cell; }))
				          return;
			          grid.cellFaces(cell, faces);
			          const std::vector<PointId> points = distinctPoints(faces[f]);
			          std::vector<SetCell> cells{{block, cell}};
			          for (const CellId other : across)
			          {
				          grid.cellFaces(other, others);
				          for (int g = 0; g < others.size(); ++g)
					          if (distinctPoints(others[g]) == points)
					          {
						          cells.push_back({block, other});
						          break;
					          }
			          }
			          std::ranges::sort(cells);
			          if (cells.size() > 2)
				          found[n].push_back(std::move(cells));
		          };
		          const std::size_t end = std::min(grid.cellCount(), (n + 1) * chunk);
		          for (std::size_t c = n * chunk; c < end; ++c)
			          for (int f = 0; f < grid.faceCount(static_cast<CellId>(c)); ++f)
				          inspect(static_cast<CellId>(c), f);
	          });
	for (auto& some : found)
		std::ranges::move(some, std::back_inserter(quality.nonmanifold_faces));
}

// Boundary faces that lie on two or more others, entered at the lowest of them.
void coincidentFaces(const BlockSet& blocks, std::uint32_t block, Quality& quality)
{
	const BlockSeams* seams = blocks.interfaces.of(block);
	if (!seams)
		return;
	const std::span<const SeamLink> links = seams->all();
	for (std::size_t begin = 0; begin < links.size();)
	{
		const std::span<const SeamLink> face = seams->of(links[begin].cell, links[begin].face);
		begin += face.size();
		std::vector<SetCell> cells{{block, face[0].cell}};
		for (const SeamLink& link : face)
			if (link.hang == Hang::none)
				cells.push_back({link.block, link.other});
		if (cells.size() < 3)
			continue;
		if (cells[0] != *std::ranges::min_element(cells))
			continue;
		std::ranges::sort(cells);
		quality.nonmanifold_faces.push_back(std::move(cells));
	}
}

// A boundary face's two edges at one of its points.
struct Wedge
{
	PointId point;
	PointId from;
	PointId to;
	CellId cell;

	auto operator<=>(const Wedge&) const = default;
};

// At a point of a closed surface, its faces form one ring in which each edge joins two of them. More faces on an edge,
// or more rings, and the domain touches itself there.
void inspectPoint(std::span<const Wedge> wedges, std::uint32_t block, Quality& quality)
{
	std::vector<std::pair<PointId, CellId>> spokes;
	for (const Wedge& wedge : wedges)
	{
		spokes.emplace_back(wedge.from, wedge.cell);
		spokes.emplace_back(wedge.to, wedge.cell);
	}
	std::ranges::sort(spokes);
	std::vector<PointId> ends;
	bool crowded = false;
	for (std::size_t begin = 0; begin < spokes.size();)
	{
		std::size_t end = begin;
		while (end < spokes.size() && spokes[end].first == spokes[begin].first)
			++end;
		if (end - begin > 2)
		{
			crowded = true;
			// Each edge is met from both its points.
			if (wedges[0].point < spokes[begin].first)
				quality.nonmanifold_edges.push_back({block, spokes[begin].second});
		}
		ends.push_back(spokes[begin].first);
		begin = end;
	}
	if (crowded)
		return;
	std::vector<std::size_t> ring(ends.size());
	std::iota(ring.begin(), ring.end(), std::size_t(0));
	std::size_t rings = ring.size();
	const auto rootOf = [&](PointId p)
	{
		std::size_t at = std::ranges::lower_bound(ends, p) - ends.begin();
		while (ring[at] != at)
		{
			ring[at] = ring[ring[at]]; // shorter for the next one: a point may have a hundred thousand edges
			at = ring[at];
		}
		return at;
	};
	for (const Wedge& wedge : wedges)
		if (const std::size_t a = rootOf(wedge.from), b = rootOf(wedge.to); a != b)
		{
			ring[b] = a;
			--rings;
		}
	if (rings > 1)
		quality.nonmanifold_points.push_back({block, wedges[0].cell});
}

// Edges and points of what bounds the domain: boundary faces that lie on no other. A block with seams is left out: its
// points are several where it closes.
void boundaryFaults(const UnstructuredGrid& grid, const Block& block, std::uint32_t number, Quality& quality)
{
	std::vector<Wedge> wedges;
	CellFaces faces;
	for (const BoundaryIndex::Face& face : block.boundary.faces)
	{
		grid.cellFaces(face.cell, faces);
		const std::span<const PointId> points = faces[static_cast<int>(face.face)];
		std::vector<PointId> corners;
		for (const PointId p : points)
			if (corners.empty() || corners.back() != p)
				corners.push_back(p);
		while (corners.size() > 1 && corners.back() == corners.front())
			corners.pop_back();
		for (std::size_t i = 0; i < corners.size(); ++i)
			wedges.push_back(
			    {corners[i], corners[i ? i - 1 : corners.size() - 1], corners[(i + 1) % corners.size()], face.cell});
	}
	tbb::parallel_sort(wedges);
	for (std::size_t begin = 0; begin < wedges.size();)
	{
		std::size_t end = begin;
		while (end < wedges.size() && wedges[end].point == wedges[begin].point)
			++end;
		inspectPoint(std::span(wedges).subspan(begin, end - begin), number, quality);
		begin = end;
	}
}

} // namespace

void findTopologyFaults(const BlockSet& blocks, Quality& quality)
{
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
	{
		const Block& block = blocks.blocks[b];
		coincidentFaces(blocks, b, quality);
		const auto* grid = std::get_if<UnstructuredGrid>(&block.grid);
		if (!grid)
			continue;
		sharedFaces(*grid, b, quality);
		if (!blocks.interfaces.of(b))
			boundaryFaults(*grid, block, b, quality);
	}
	std::ranges::sort(quality.nonmanifold_faces);
	std::ranges::sort(quality.nonmanifold_edges);
	std::ranges::sort(quality.nonmanifold_points);
}

} // namespace vp::grid
