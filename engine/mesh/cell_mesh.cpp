#include "mesh/cell_mesh.h"

#include "base/key_numbers.h"
#include "base/parallel_for.h"
#include "mesh/mesh_chunk_writer.h"

#include <algorithm>
#include <array>

namespace vp::mesh
{

namespace
{

// Some 1400 vertices of tetrahedra or 2100 of hexahedra, whose table and places stay in a second-level cache.
constexpr std::size_t kPartCells = 2048;

// The cut cells by their numbers: neighbors of a part are in it, and their points in the cache. Of a list from the
// traversal that takes less time than it saves. Digit by digit, so that it is linear.
find::CellCut inOrder(const find::CellCut& cut)
{
	constexpr int kDigit = 11; // bits: counts that stay in the first-level cache
	struct Entry
	{
		CellId cell;
		std::uint32_t code;
	};
	std::vector<Entry> entries;
	entries.reserve(cut.cut_cells);
	CellId last = 0;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.codes[i] & shared::kCodeCut)
		{
			entries.push_back({cut.cells[i], cut.codes[i]});
			last = std::max(last, cut.cells[i]);
		}
	std::vector<Entry> sorted(entries.size());
	for (int shift = 0; last >> shift; shift += kDigit)
	{
		const auto digitOf = [&](const Entry& entry) { return entry.cell >> shift & ((1u << kDigit) - 1); };
		std::array<std::uint32_t, (1u << kDigit) + 1> starts{};
		for (const Entry& entry : entries)
			++starts[digitOf(entry) + 1];
		for (std::size_t d = 1; d < starts.size(); ++d)
			starts[d] += starts[d - 1];
		for (const Entry& entry : entries)
			sorted[starts[digitOf(entry)]++] = entry;
		entries.swap(sorted);
		if (shift + kDigit >= 32)
			break;
	}
	find::CellCut ordered;
	ordered.cut_cells = cut.cut_cells;
	for (const Entry& entry : entries)
	{
		ordered.cells.push_back(entry.cell);
		ordered.codes.push_back(entry.code);
	}
	return ordered;
}

// A vertex that several parts know is numbered by the first of them. Returns how many vertices there are then.
std::uint32_t settleShared(std::vector<MeshChunk>& parts, std::uint32_t next)
{
	std::size_t shared = 0;
	for (const MeshChunk& part : parts)
		shared += part.shared.size();
	KeyNumbers known(shared / 2);
	for (MeshChunk& part : parts)
	{
		part.first_vertex = next;
		for (const std::uint32_t v : part.shared)
		{
			const std::uint32_t number = next + v - static_cast<std::uint32_t>(part.foreign.size());
			if (const auto [vertex, is_new] = known.find(part.edges[v], number); !is_new)
				part.foreign.emplace_back(v, vertex);
		}
		next += static_cast<std::uint32_t>(part.owned());
	}
	return next;
}

// Behind what the mesh holds.
void placeParts(std::vector<MeshChunk>& parts, SheetMesh& mesh)
{
	const std::uint32_t vertices = settleShared(parts, static_cast<std::uint32_t>(mesh.positions.size()));
	auto corner = static_cast<std::uint32_t>(mesh.polygon_vertices.size());
	auto polygon = static_cast<std::uint32_t>(mesh.polygons());
	for (MeshChunk& part : parts)
	{
		part.first_corner = corner;
		part.first_polygon = polygon;
		corner += static_cast<std::uint32_t>(part.corners.size());
		polygon += static_cast<std::uint32_t>(part.cells.size());
		mesh.cells_twisted += part.twisted;
	}
	mesh.positions.resize(vertices);
	mesh.edges.resize(vertices);
	mesh.polygon_vertices.resize(corner);
	mesh.polygon_starts.resize(polygon + std::size_t(1));
	mesh.polygon_cells.resize(polygon);
}

// Calls use(reader) with what reads the cells of a grid fastest.
template <grid::Grid G, class Use>
void withReader(const G& grid, Use&& use)
{
	if constexpr (std::is_same_v<G, grid::UnstructuredGrid>)
		if (grid.hasNeighbors())
			return grid::readRecords(grid, use);
	use(CellReader<G>(grid));
}

} // namespace

template <class Surface>
MeshCleanup addCells(const grid::Block& block, std::uint32_t number, const Surface& surface, const Vec3& normal,
                     const find::CellCut& found, SheetMesh& mesh)
{
	if (found.cut_cells == 0)
		return {};
	const find::CellCut ordered = found.closed ? find::CellCut() : inOrder(found);
	const find::CellCut& cut = found.closed ? found : ordered;
	std::vector<MeshChunk> parts((cut.cells.size() + kPartCells - 1) / kPartCells);
	std::vector<MeshCleanup> doubts(parts.size());
	const auto forParts = [&](auto&& act) { tracedFor(std::size_t(0), parts.size(), act); };
	const auto add = [&](const auto& grid, const auto& reader)
	{
		forParts(
		    [&](std::size_t p)
		    {
			    const std::size_t end = std::min((p + 1) * kPartCells, cut.cells.size());
			    parts[p] = MeshChunkBuilder(grid, reader, surface, cut, p * kPartCells, end).make();
		    });
		placeParts(parts, mesh);
		forParts(
		    [&](std::size_t p)
		    {
			    const MeshChunk part = std::move(parts[p]); // freed here, not one after the other
			    doubts[p] =
			        MeshChunkWriter(grid, block.bounds.size(), reader, number, surface, normal, part, mesh).write();
		    });
	};
	std::visit([&](const auto& grid) { withReader(grid, [&](const auto& reader) { add(grid, reader); }); }, block.grid);
	MeshCleanup any;
	for (const MeshCleanup& of_part : doubts)
		any = any | of_part;
	return any;
}

template MeshCleanup addCells(const grid::Block&, std::uint32_t, const surface::Plane&, const Vec3&,
                              const find::CellCut&, SheetMesh&);
template MeshCleanup addCells(const grid::Block&, std::uint32_t, const surface::BlockSurface&, const Vec3&,
                              const find::CellCut&, SheetMesh&);

} // namespace vp::mesh
