#include "grid/boundary.h"

#include "base/parallel_for.h"
#include "grid/structured.h"
#include "grid/unstructured.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <span>
#include <type_traits>

namespace vp::grid
{

namespace
{

constexpr std::uint32_t kPatchFaces = 16;
constexpr std::uint32_t kGroupFacePatches = 64;

// On the side of a lattice.
constexpr std::uint32_t kPatchEdge = 4;
constexpr std::uint32_t kGroupEdge = 32;

// Side f of a lattice: group by group, patch by patch.
void addSide(const Lattice& lattice, int f, BoundaryIndex& index)
{
	const int axis = f / 2;
	const int u_axis = axis == 0 ? 1 : 0;
	const int v_axis = axis == 2 ? 1 : 2;
	const std::uint32_t u_count = lattice.cells()[u_axis];
	const std::uint32_t v_count = lattice.cells()[v_axis];
	std::array<std::uint32_t, 3> at{};
	at[axis] = f % 2 ? lattice.cells()[axis] - 1 : 0;

	const auto addPatch = [&](std::uint32_t u0, std::uint32_t v0)
	{
		const auto begin = static_cast<std::uint32_t>(index.faces.size());
		for (std::uint32_t v = v0; v < std::min(v0 + kPatchEdge, v_count); ++v)
			for (std::uint32_t u = u0; u < std::min(u0 + kPatchEdge, u_count); ++u)
			{
				at[u_axis] = u;
				at[v_axis] = v;
				index.faces.push_back({lattice.cell(at[0], at[1], at[2]), static_cast<std::uint32_t>(f)});
			}
		index.patches.push_back({Box{}, begin, static_cast<std::uint32_t>(index.faces.size())});
	};
	for (std::uint32_t gv = 0; gv < v_count; gv += kGroupEdge)
		for (std::uint32_t gu = 0; gu < u_count; gu += kGroupEdge)
		{
			const auto begin = static_cast<std::uint32_t>(index.patches.size());
			for (std::uint32_t v = gv; v < std::min(gv + kGroupEdge, v_count); v += kPatchEdge)
				for (std::uint32_t u = gu; u < std::min(gu + kGroupEdge, u_count); u += kPatchEdge)
					addPatch(u, v);
			index.groups.push_back({Box{}, begin, static_cast<std::uint32_t>(index.patches.size())});
		}
}

void addFaces(const Lattice& lattice, BoundaryIndex& index)
{
	if (lattice.cellCount() == 0)
		return;
	const auto [ni, nj, nk] = lattice.cells();
	index.faces.reserve(2 * (std::size_t(ni) * nj + std::size_t(ni) * nk + std::size_t(nj) * nk));
	for (int f = 0; f < 6; ++f)
		addSide(lattice, f, index);
}

// Three distinct points.
bool hasArea(std::span<const PointId> face)
{
	const auto differs = [&](std::size_t i) { return face[i] != face[0]; };
	std::size_t second = 1;
	while (second < face.size() && !differs(second))
		++second;
	for (std::size_t third = second + 1; third < face.size(); ++third)
		if (differs(third) && face[third] != face[second])
			return true;
	return false;
}

void addFaces(const UnstructuredGrid& grid, BoundaryIndex& index)
{
	constexpr std::size_t chunk = 16384;
	std::vector<std::vector<BoundaryIndex::Face>> found((grid.cellCount() + chunk - 1) / chunk);
	parallelFor(std::size_t(0), found.size(),
	            [&](std::size_t n)
	            {
		            CellFaces faces;
		            const std::size_t end = std::min(grid.cellCount(), (n + 1) * chunk);
		            for (std::size_t c = n * chunk; c < end; ++c)
		            {
			            const CellId cell = static_cast<CellId>(c);
			            if (grid.hasAllNeighbors(cell))
				            continue;
			            bool listed = false;
			            for (int f = 0; f < grid.faceCount(cell); ++f)
			            {
				            bool alone = true;
				            grid.forEachNeighbor(cell, f, [&](CellId) { alone = false; });
				            if (!alone)
					            continue;
				            if (!listed)
					            grid.cellFaces(cell, faces);
				            listed = true;
				            if (hasArea(faces[f]))
					            found[n].push_back({cell, static_cast<std::uint32_t>(f)});
			            }
		            }
	            });
	std::size_t count = 0;
	for (const auto& faces : found)
		count += faces.size();
	index.faces.reserve(count);
	for (const auto& faces : found)
		index.faces.insert(index.faces.end(), faces.begin(), faces.end());

	const auto cut = [](std::size_t size, std::uint32_t step, std::vector<BoundaryIndex::Range>& ranges)
	{
		for (std::size_t begin = 0; begin < size; begin += step)
			ranges.push_back({Box{}, static_cast<std::uint32_t>(begin),
			                  static_cast<std::uint32_t>(std::min<std::size_t>(begin + step, size))});
	};
	cut(index.faces.size(), kPatchFaces, index.patches);
	cut(index.patches.size(), kGroupFacePatches, index.groups);
}

// Coordinates along straight axes rise or fall throughout, so the first and the last face of a patch reach as far as
// all of them do.
template <Grid G>
void fillBoxesOfStraightAxes(const G& grid, BoundaryIndex& index)
{
	parallelFor(tbb::blocked_range<std::size_t>(0, index.patches.size(), 1024),
	            [&](const auto& range)
	            {
		            for (std::size_t p = range.begin(); p < range.end(); ++p)
			            for (const std::uint32_t i : {index.patches[p].begin, index.patches[p].end - 1})
			            {
				            const auto [cell, side] = index.faces[i];
				            const auto at = grid.cellIndex(cell);
				            for (std::uint32_t corner = 0; corner < 8; ++corner)
				            {
					            const std::array step{corner & 1, corner >> 1 & 1, corner >> 2};
					            if (step[side / 2] == side % 2)
						            index.patches[p].box.include(
						                grid.pointAt(at[0] + step[0], at[1] + step[1], at[2] + step[2]));
				            }
			            }
	            });
}

template <Grid G>
void fillBoxesOfFaces(const G& grid, BoundaryIndex& index)
{
	constexpr bool kKeepsCoordinates = requires
	{
		grid.coordinates();
	};
	if constexpr (kKeepsCoordinates)
		index.corners.resize(index.faces.size());
	std::atomic<bool> has_large_faces = false;
	parallelFor(tbb::blocked_range<std::size_t>(0, index.patches.size(), 64),
	            [&](const auto& range)
	            {
		            CellFaces faces;
		            for (std::size_t p = range.begin(); p < range.end(); ++p)
		            {
			            BoundaryIndex::Range& patch = index.patches[p];
			            for (std::uint32_t i = patch.begin; i < patch.end; ++i)
			            {
				            grid.cellFaces(index.faces[i].cell, faces);
				            const std::span<const PointId> points = faces[index.faces[i].face];
				            for (const PointId point : points)
					            patch.box.include(grid.point(point));
				            if (points.size() > 4)
					            has_large_faces = true;
				            else if constexpr (kKeepsCoordinates)
					            for (std::size_t corner = 0; corner < 4; ++corner)
						            index.corners[i][corner] = points[std::min(corner, points.size() - 1)];
			            }
		            }
	            });
	if (has_large_faces)
		index.corners = {};
}

template <Grid G>
void fillBoxes(const G& grid, BoundaryIndex& index)
{
	constexpr bool kIsStraight = requires
	{
		grid.coordinate(0, 0);
	};
	if constexpr (kIsStraight)
		fillBoxesOfStraightAxes(grid, index);
	else
		fillBoxesOfFaces(grid, index);
	for (BoundaryIndex::Range& group : index.groups)
		for (std::uint32_t p = group.begin; p < group.end; ++p)
			group.box.include(index.patches[p].box);
}

} // namespace

template <Grid G>
BoundaryIndex buildBoundaryIndex(const G& grid)
{
	BoundaryIndex index;
	addFaces(grid, index);
	fillBoxes(grid, index);
	return index;
}

template BoundaryIndex buildBoundaryIndex(const UniformGrid&);
template BoundaryIndex buildBoundaryIndex(const RectilinearGrid&);
template BoundaryIndex buildBoundaryIndex(const CurvilinearGrid&);
template BoundaryIndex buildBoundaryIndex(const UnstructuredGrid&);

} // namespace vp::grid
