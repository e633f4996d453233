#include "cases/case_table.h"

#include "cases/cell_walk.h"

#include <algorithm>

namespace vp::cases
{

namespace
{

using grid::CellShape;
using grid::kTableShapes;
using grid::ShapeTopology;

WalkFaces facesOf(const ShapeTopology& shape)
{
	WalkFaces faces;
	faces.starts.push_back(0);
	for (int f = 0; f < shape.faces; ++f)
	{
		for (const std::uint8_t p : shape.facePoints(f))
			faces.points.push_back(p);
		faces.starts.push_back(static_cast<std::uint32_t>(faces.points.size()));
	}
	return faces;
}

// Returns the face with two edges that follow each other in a polygon.
std::uint8_t faceThrough(const ShapeTopology& shape, const CutEdge& edge, const CutEdge& next)
{
	for (int f = 0; f < shape.faces; ++f)
	{
		const auto holds = [&](std::uint16_t point) { return std::ranges::count(shape.facePoints(f), point) > 0; };
		if (holds(edge.positive) && holds(edge.negative) && holds(next.positive) && holds(next.negative))
			return static_cast<std::uint8_t>(f);
	}
	return 0; // only for edges that do not follow each other
}

Case caseOf(const ShapeTopology& shape, const CellCut& cut)
{
	Case entry;
	for (std::size_t f = 0; f < cut.face_cuts.size(); ++f)
		if (cut.face_cuts[f] > 0)
			entry.faces |= static_cast<std::uint8_t>(1 << f);
	entry.needs_walk = cut.ambiguous || cut.open || cut.polygons() > 1;
	if (entry.needs_walk || cut.polygons() == 0)
		return entry;
	entry.edges = static_cast<std::uint8_t>(cut.edges.size());
	for (std::size_t i = 0; i < cut.edges.size(); ++i)
	{
		entry.edge[i] = {static_cast<std::uint8_t>(cut.edges[i].positive),
		                 static_cast<std::uint8_t>(cut.edges[i].negative)};
		entry.face_after[i] = faceThrough(shape, cut.edges[i], cut.edges[(i + 1) % cut.edges.size()]);
	}
	std::fill(entry.face_after.begin() + entry.edges, entry.face_after.end(), entry.face_after[0]);
	return entry;
}

std::vector<Case> buildTable(const ShapeTopology& shape)
{
	const WalkFaces faces = facesOf(shape);
	std::vector<Case> table;
	std::vector<std::uint8_t> positive(shape.points);
	CellCut cut;
	for (unsigned mask = 0; mask < 1u << shape.points; ++mask)
	{
		for (int p = 0; p < shape.points; ++p)
			positive[p] = mask >> p & 1;
		walkCell(
		    faces, positive, [](int, auto) { return Pairing::positive_apart; }, cut);
		table.push_back(caseOf(shape, cut));
	}
	return table;
}

} // namespace

std::span<const Case> caseTable(CellShape shape)
{
	static const auto tables = []
	{
		std::array<std::vector<Case>, kTableShapes> made;
		for (int s = 0; s < kTableShapes; ++s)
			made[s] = buildTable(grid::topology(static_cast<CellShape>(s)));
		return made;
	}();
	return tables[static_cast<std::size_t>(shape)];
}

std::vector<std::uint32_t> packedCaseTables()
{
	std::vector<std::uint32_t> words;
	for (int s = 0; s < kTableShapes; ++s)
		for (const Case& entry : caseTable(static_cast<CellShape>(s)))
		{
			words.push_back(entry.edges | std::uint32_t(entry.faces) << 8 | std::uint32_t(entry.needs_walk) << 16);
			for (int pair = 0; pair < kMaxPolygon; pair += 2)
			{
				const auto edge = [&](int i) { return entry.edge[i][0] | std::uint32_t(entry.edge[i][1]) << 8; };
				words.push_back(edge(pair) | edge(pair + 1) << 16);
			}
		}
	return words;
}

std::uint32_t caseTableStart(CellShape shape)
{
	std::uint32_t start = 0;
	for (int s = 0; s < static_cast<int>(shape); ++s)
		start += 1u << grid::topology(static_cast<CellShape>(s)).points;
	return start;
}

} // namespace vp::cases
