#include "grid/check/quality.h"

#include "base/parallel_for.h"
#include "grid/cell_turn.h"
#include "grid/measure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <type_traits>

namespace vp::grid
{

namespace
{

constexpr std::size_t kFaultChunk = 16384;

// Cells of a chunk by fault, and the orientation of all.
struct CellFaults
{
	std::vector<CellId> collapsed;
	std::vector<CellId> degenerate;
	std::vector<CellId> twisted;
	std::vector<CellId> negative; // volume
	std::vector<CellId> negative_polyhedra;
	std::vector<CellId> positive_polyhedra;
	std::size_t positive = 0; // cells of table shapes
};

template <class G>
constexpr bool kIsBoxes = std::is_same_v<G, UniformGrid> || std::is_same_v<G, RectilinearGrid>;

bool anyAlike(std::span<const PointId> ids, std::span<const Vec3> at)
{
	for (std::size_t i = 1; i < ids.size(); ++i)
		for (std::size_t j = 0; j < i; ++j)
			if (ids[i] == ids[j] || at[i] == at[j])
				return true;
	return false;
}

// Returns true if corners that a cell lists twice are joined by edges of it, and no others lie at one place.
bool collapsesAlongEdges(CellShape shape, std::span<const PointId> ids, std::span<const Vec3> at)
{
	std::array<std::size_t, kMaxShapePoints> joined;
	std::iota(joined.begin(), joined.end(), std::size_t(0));
	const ShapeTopology& table = topology(shape);
	for (int pass = 0; pass < table.points; ++pass) // the lowest number spreads along the edges
		for (int e = 0; e < table.edges; ++e)
			if (const auto [a, b] = table.edge[static_cast<std::size_t>(e)]; ids[a] == ids[b])
				joined[a] = joined[b] = std::min(joined[a], joined[b]);
	int distinct = 0;
	for (std::size_t i = 0; i < ids.size(); ++i)
	{
		distinct += joined[i] == i;
		for (std::size_t j = 0; j < i; ++j)
			if (joined[i] != joined[j] && (ids[i] == ids[j] || at[i] == at[j]))
				return false;
	}
	return distinct >= 4;
}

bool isTwisted(CellShape shape, std::span<const Vec3> at, bool positive)
{
	// Rounding of a determinant is some 1e-16 of the product of its edges.
	constexpr double kNoVolume = 1e-12;
	for (const CornerFrame& frame : cornerFrames(shape))
	{
		const Vec3 a = at[frame.corner[1]] - at[frame.corner[0]];
		const Vec3 b = at[frame.corner[2]] - at[frame.corner[0]];
		const Vec3 c = at[frame.corner[3]] - at[frame.corner[0]];
		const double volume = glm::dot(a, glm::cross(b, c)) * (positive ? 1.0 : -1.0);
		if (volume < -kNoVolume * glm::length(a) * glm::length(b) * glm::length(c))
			return true;
	}
	return false;
}

template <Grid G>
void inspectPolyhedron(const G& grid, CellId cell, CellFaces& faces, CellFaults& faults)
{
	grid.cellFaces(cell, faces);
	std::vector<PointId> ids = faces.points;
	std::ranges::sort(ids);
	ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
	std::vector<Vec3> at;
	for (const PointId p : ids)
		at.push_back(grid.point(p));
	if (anyAlike(ids, at))
		faults.collapsed.push_back(cell);
	if (const double volume = signedVolume(grid, cell, faces); volume != 0.0 && orientedAlike(faces))
		(volume > 0.0 ? faults.positive_polyhedra : faults.negative_polyhedra).push_back(cell);
}

template <Grid G>
void inspectCell(const G& grid, CellId cell, CellFaces& faces, CellFaults& faults)
{
	const CellShape shape = grid.shape(cell);
	if (shape == CellShape::polyhedron)
		return inspectPolyhedron(grid, cell, faces, faults);
	const CellPoints ids = grid.cellPoints(cell);
	std::array<Vec3, kMaxShapePoints> at;
	for (int i = 0; i < ids.size; ++i)
		at[i] = grid.point(ids.id[i]);
	const std::span<const Vec3> places(at.data(), ids.size);
	const double volume = signedVolume(grid, cell, faces);
	if (const std::span<const PointId> of_cell(ids.begin(), ids.end()); anyAlike(of_cell, places))
	{
		const bool is_simpler = volume != 0.0 && collapsesAlongEdges(shape, of_cell, places);
		(is_simpler ? faults.degenerate : faults.collapsed).push_back(cell);
	}
	if (volume < 0.0)
		faults.negative.push_back(cell);
	else if (volume > 0.0)
		++faults.positive;
	if (volume != 0.0 && isTwisted(shape, places, volume > 0.0))
		faults.twisted.push_back(cell);
}

void append(std::uint32_t block, const std::vector<CellId>& cells, std::vector<SetCell>& list)
{
	for (const CellId cell : cells)
		list.push_back({block, cell});
}

// Calls take(faults) chunk by chunk.
template <Grid G, class Take>
void inspectCells(const G& grid, Take&& take)
{
	std::vector<CellFaults> chunks((grid.cellCount() + kFaultChunk - 1) / kFaultChunk);
	tracedFor(std::size_t(0), chunks.size(),
	          [&](std::size_t n)
	          {
		          CellFaces faces;
		          const std::size_t end = std::min(grid.cellCount(), (n + 1) * kFaultChunk);
		          for (std::size_t c = n * kFaultChunk; c < end; ++c)
			          inspectCell(grid, static_cast<CellId>(c), faces, chunks[n]);
	          });
	for (const CellFaults& chunk : chunks)
		take(chunk);
}

// The cells of a structured block that are turned the other way than most: all that are not listed as negative, if most
// are.
template <Grid G>
void addMinority(const G& grid, std::uint32_t block, const std::vector<CellId>& negative, std::size_t positive,
                 Quality& quality)
{
	if (negative.size() <= positive)
		return append(block, negative, quality.inverted);
	CellFaces faces;
	for (std::size_t c = 0; positive > 0 && c < grid.cellCount(); ++c)
		if (signedVolume(grid, static_cast<CellId>(c), faces) > 0.0)
			quality.inverted.push_back({block, static_cast<CellId>(c)});
}

template <Grid G>
void findCellFaultsOf(const G& grid, std::uint32_t block, Quality& quality)
{
	std::vector<CellId> negative;
	std::vector<CellId> negative_polyhedra;
	std::vector<CellId> positive_polyhedra;
	std::size_t positive = 0;
	inspectCells(grid,
	             [&](const CellFaults& faults)
	             {
		             append(block, faults.collapsed, quality.collapsed);
		             append(block, faults.degenerate, quality.degenerate);
		             append(block, faults.twisted, quality.twisted);
		             negative.insert(negative.end(), faults.negative.begin(), faults.negative.end());
		             negative_polyhedra.insert(negative_polyhedra.end(), faults.negative_polyhedra.begin(),
		                                       faults.negative_polyhedra.end());
		             positive_polyhedra.insert(positive_polyhedra.end(), faults.positive_polyhedra.begin(),
		                                       faults.positive_polyhedra.end());
		             positive += faults.positive;
	             });
	if constexpr (std::is_same_v<G, UnstructuredGrid>)
		append(block, negative, quality.inverted);
	else
		addMinority(grid, block, negative, positive, quality);
	append(block, negative_polyhedra.size() <= positive_polyhedra.size() ? negative_polyhedra : positive_polyhedra,
	       quality.inverted);
}

bool placedBefore(const Vec3& a, const Vec3& b)
{
	return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

template <Grid G>
std::vector<PointId> coincidentPoints(const G& grid)
{
	std::vector<PointId> order(grid.usedPointCount());
	std::iota(order.begin(), order.end(), 0u);
	// A coordinate that is no number has no place among the others.
	std::erase_if(order,
	              [&](PointId p)
	              {
		              const Vec3 x = grid.point(p);
		              return std::isnan(x.x) || std::isnan(x.y) || std::isnan(x.z);
	              });
	tbb::parallel_sort(order,
	                   [&](PointId a, PointId b)
	                   {
		                   const Vec3 p = grid.point(a);
		                   const Vec3 q = grid.point(b);
		                   return p == q ? a < b : placedBefore(p, q);
	                   });
	std::vector<PointId> found;
	for (std::size_t i = 1; i < order.size(); ++i)
		if (grid.point(order[i]) == grid.point(order[i - 1]))
			found.push_back(order[i]);
	std::ranges::sort(found);
	return found;
}

} // namespace

bool haveOwnPoints(const UnstructuredGrid& grid)
{
	constexpr std::uint32_t kNobody = ~0u;
	std::vector<std::uint32_t> owners(grid.pointCount(), kNobody);
	CellFaces faces;
	for (std::size_t c = 0; c < grid.cellCount(); ++c)
	{
		const auto source = static_cast<std::uint32_t>(grid.sourceCell(static_cast<CellId>(c)));
		grid.cellFaces(static_cast<CellId>(c), faces);
		for (const PointId p : faces.points)
		{
			if (owners[p] != kNobody && owners[p] != source)
				return false;
			owners[p] = source;
		}
	}
	return true;
}

void findCellFaults(const BlockSet& blocks, Quality& quality)
{
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		std::visit(
		    [&]<class G>(const G& grid)
		    {
			    if constexpr (!kIsBoxes<G>) // by construction
				    findCellFaultsOf(grid, b, quality);
		    },
		    blocks.blocks[b].grid);
	std::ranges::sort(quality.inverted);
}

void findPointFaults(const BlockSet& blocks, Quality& quality)
{
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		std::visit(
		    [&]<class G>(const G& grid)
		    {
			    if constexpr (!kIsBoxes<G>)
			    {
				    const std::vector<PointId> found = coincidentPoints(grid);
				    for (const PointId p : found)
					    quality.coincident.push_back({b, p});
				    if constexpr (std::is_same_v<G, UnstructuredGrid>)
					    quality.coincident_at_fault |= !found.empty() && !haveOwnPoints(grid);
			    }
			    for (std::size_t p = grid.usedPointCount(); p < grid.pointCount(); ++p)
				    quality.orphans.push_back({b, static_cast<PointId>(p)});
		    },
		    blocks.blocks[b].grid);
}

Quality checkQuality(const BlockSet& blocks)
{
	Quality quality;
	findCellFaults(blocks, quality);
	findPointFaults(blocks, quality);
	findTopologyFaults(blocks, quality);
	findOverlaps(blocks, quality);
	return quality;
}

} // namespace vp::grid
