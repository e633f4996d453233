#include "contour/contour_parts.h"

#include "contour/box_contour.h"
#include "contour/box_traversal.h"
#include "seed/boundary_cut.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

namespace vp::contour
{

namespace
{

constexpr std::uint32_t kNoGroup = std::numeric_limits<std::uint32_t>::max();

using CellGroups = std::unordered_map<std::uint64_t, std::uint32_t>; // groups of the cells that have a way out

std::uint64_t keyOf(std::size_t block, CellId cell)
{
	return std::uint64_t(block) << 32 | cell;
}

bool touch(const Box& a, const Box& b)
{
	return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
}

// Adds the boundary faces of a block that the surface cuts in the box and that may meet something in `others`. Faces
// that meet other blocks here are none.
void findWaysOut(const grid::BlockSet& blocks, std::uint32_t b, const surface::BlockSurface& surface,
                 const ClipBox& box, std::span<const Box> others, std::vector<WayOut>& ways_out)
{
	const grid::Block& block = blocks.blocks[b];
	const grid::BlockSeams* seams = blocks.interfaces.of(b);
	const auto meetsOthers = [&](const Box& of_faces)
	{ return std::ranges::any_of(others, [&](const Box& other) { return touch(of_faces, other); }); };
	std::visit(
	    [&](const auto& grid)
	    {
		    grid::CellFaces faces;
		    block.boundary.visitWhere([&](const Box& of_faces) { return meetsOthers(of_faces) && box.meets(of_faces); },
		                              [&](const grid::BoundaryIndex::Face& face)
		                              {
			                              seed::useFacePoints(
			                                  grid, face.cell, face.face, faces,
			                                  [&](std::span<const PointId> points)
			                                  {
				                                  if (meetsOthers(seed::boxOf(grid, points)) &&
				                                      box.meetsFace(grid, surface, points) &&
				                                      !(seams && !seams->of(face.cell, face.face).empty()))
					                                  ways_out.push_back({b, face, kNoGroup});
			                                  });
		                              });
	    },
	    block.grid);
}

// Adds what a search has found, as a group. ways: gets the group of its cells with a way out.
void addGroup(std::vector<find::CellCut>&& found, std::uint32_t group, CellGroups& ways, ContourParts& parts)
{
	for (std::size_t b = 0; b < found.size(); ++b)
	{
		find::CellCut& cut = parts.cuts[b];
		for (std::size_t i = 0; i < found[b].cells.size() && !ways.empty(); ++i)
			if (found[b].codes[i] & shared::kCodeCut)
				if (const auto way = ways.find(keyOf(b, found[b].cells[i])); way != ways.end())
					way->second = group;
		cut.cells.insert(cut.cells.end(), found[b].cells.begin(), found[b].cells.end());
		cut.codes.insert(cut.codes.end(), found[b].codes.begin(), found[b].codes.end());
		cut.cut_cells += found[b].cut_cells;
		parts.groups[b].resize(cut.cells.size(), group);
	}
}

} // namespace

Result<ContourParts> BoxContourer::growParts(double value, std::span<const Box> others) const
{
	const grid::BlockSet& blocks = slicer_.blocks();
	ContourParts parts;
	parts.value = value;
	parts.surfaces = find::isoSurfaces(blocks, value, sheet_.field);
	parts.cuts.resize(blocks.blocks.size());
	parts.groups.resize(blocks.blocks.size());
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		findWaysOut(blocks, b, parts.surfaces[b], box_, others, parts.ways_out);
	CellGroups ways;
	for (const WayOut& way : parts.ways_out)
		ways.emplace(keyOf(way.block, way.face.cell), kNoGroup);

	BoxTraversal traversal(slicer_, parts.surfaces, box_);
	auto from_sheet = traversal.searchFrom(seedsOf(value));
	if (!from_sheet)
		return from_sheet.error();
	for (const find::CellCut& cut : *from_sheet)
	{
		parts.generations = std::max(parts.generations, cut.steps);
		parts.seeds += cut.generations() > 0 ? cut.generation_starts[1] : 0;
	}
	addGroup(std::move(*from_sheet), 0, ways, parts);
	for (const WayOut& way : parts.ways_out)
	{
		const std::uint64_t key = keyOf(way.block, way.face.cell);
		if (ways.at(key) != kNoGroup)
			continue;
		auto found = traversal.searchFrom(way.block, way.face.cell);
		if (!found)
			return found.error();
		addGroup(std::move(*found), parts.group_count, ways, parts);
		parts.group_count += ways.at(key) != kNoGroup; // else nothing is found, since a value is not finite
	}
	for (WayOut& way : parts.ways_out)
		way.group = ways.at(keyOf(way.block, way.face.cell));
	std::erase_if(parts.ways_out, [](const WayOut& way) { return way.group == kNoGroup; });
	return parts;
}

void keepGroups(const std::vector<std::uint8_t>& kept, ContourParts& parts)
{
	for (std::size_t b = 0; b < parts.cuts.size(); ++b)
	{
		find::CellCut& cut = parts.cuts[b];
		std::size_t to = 0;
		cut.cut_cells = 0;
		for (std::size_t i = 0; i < cut.cells.size(); ++i)
		{
			if (!kept[parts.groups[b][i]])
				continue;
			cut.cells[to] = cut.cells[i];
			cut.codes[to] = cut.codes[i];
			parts.groups[b][to++] = parts.groups[b][i];
			cut.cut_cells += (cut.codes[i] & shared::kCodeCut) != 0;
		}
		cut.cells.resize(to);
		cut.codes.resize(to);
		parts.groups[b].resize(to);
	}
}

} // namespace vp::contour
