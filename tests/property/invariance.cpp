#include "pair_checks.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

// Source ids, ascending, block by block.
std::vector<std::vector<std::size_t>> sourceCells(const grid::BlockSet& set, const SlicedSheet& sheet)
{
	std::vector<std::vector<std::size_t>> all;
	for (std::size_t b = 0; b < set.blocks.size(); ++b)
	{
		std::vector<std::size_t>& ids = all.emplace_back();
		for (const CellId cell : sheet.cutCells(b))
			ids.push_back(
			    visitGrid(set.blocks[b], [&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); }));
		std::ranges::sort(ids);
	}
	return all;
}

// How much of the area rounding may move: the cut's rim and every edge that the plane meets at a low angle, by the
// distance that rounding moves a vertex along it.
double areaSlack(const grid::BlockSet& set, const SlicedSheet& sheet, double rounding)
{
	double slack = 0.0;
	const Vec3 normal = sheet.slice.sheet.normal;
	for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
	{
		double reach = 0.0;
		double shift = 0.0;
		for (const std::uint32_t v : sheet.mesh.polygon(p))
		{
			const mesh::EdgePoint& edge = sheet.mesh.edges[v];
			const Vec3 along = visitGrid(set.blocks[edge.block], [&](const auto& grid)
			                             { return grid.point(edge.higher) - grid.point(edge.lower); });
			const double rise = std::abs(glm::dot(along, normal));
			const double length = glm::length(along);
			shift = std::max(shift, rise > rounding ? rounding * length / rise : length);
			reach =
			    std::max(reach, glm::length(sheet.mesh.positions[v] - sheet.mesh.positions[sheet.mesh.polygon(p)[0]]));
		}
		slack += 8.0 * (shift + rounding) * (reach + shift + rounding);
	}
	return slack;
}

double meanOf(const grid::BlockSet& set, const SlicedSheet& sheet)
{
	return measure::measure(set, sheet.mesh, grid::FieldChoice{"linear", grid::Association::point, 0})
	    .mean.value_or(0.0);
}

// Returns true if the plane holds a whole boundary face up to rounding. Rounding then decides whether the face is
// shown.
bool liesOnBoundary(const Pair& pair)
{
	const grid::BlockSet& set = pair.set;
	const Side side(pair.plane);
	const bool floats = std::ranges::any_of(pair.raw.blocks, &RawBlock::floats);
	const double rounding = (floats ? 0x1p29 : 1.0) * roundingOf(set, pair.plane);
	const auto isFlat = [&](const auto& grid, const grid::BoundaryIndex::Face& face)
	{
		grid::CellFaces faces;
		grid.cellFaces(face.cell, faces);
		return std::ranges::all_of(faces[static_cast<int>(face.face)],
		                           [&](PointId p) { return std::abs(side.distance(grid.point(p))) <= rounding; });
	};
	for (const grid::Block& block : set.blocks)
		if (std::ranges::any_of(block.boundary.faces, [&](const auto& face)
		                        { return visitGrid(block, [&](const auto& grid) { return isFlat(grid, face); }); }))
			return true;
	return false;
}

// Whether the area is the same when rounding moves the plane: a vertex that changes sides moves what is cut of a warped
// face, or the overlap of a folded cell, at once.
bool keepsArea(const Pair& pair)
{
	return pair.generic || (pair.raw.flat_faces && pair.raw.conforming && !liesOnBoundary(pair));
}

class Comparison
{
public:
	explicit Comparison(const Pair& pair) : pair_(pair), cells_(sourceCells(pair.set, pair.sheet)) {}

	// The same slice, cut otherwise; `cells` named as in the pair's set.
	void expectSame(const char* how, const grid::BlockSet& set, const SlicedSheet& sheet,
	                const std::vector<std::vector<std::size_t>>& cells, double rounding) const
	{
		const double slack = areaSlack(pair_.set, pair_.sheet, rounding) + areaSlack(set, sheet, rounding);
		EXPECT_NEAR(areaOf(sheet), areaOf(pair_.sheet), slack + 1e-12 * areaOf(sheet)) << how;
		if (!pair_.generic || !isGeneric(set, {sheet.slice.sheet.origin, sheet.slice.sheet.normal}))
			return;
		EXPECT_EQ(cells, cells_) << how;
		EXPECT_EQ(sheet.mesh.polygons(), pair_.sheet.mesh.polygons()) << how;
		EXPECT_EQ(sheet.mesh.positions.size(), pair_.sheet.mesh.positions.size()) << how;
		EXPECT_EQ(sheet.mesh.cells_twisted, pair_.sheet.mesh.cells_twisted) << how;
	}

private:
	const Pair& pair_;
	std::vector<std::vector<std::size_t>> cells_;
};

struct Motion
{
	Vec3 axis;
	double angle;
	Vec3 shift;

	Vec3 turned(const Vec3& p) const
	{
		return std::cos(angle) * p + std::sin(angle) * glm::cross(axis, p) +
		       (1.0 - std::cos(angle)) * glm::dot(axis, p) * axis;
	}
	Vec3 operator()(const Vec3& p) const { return turned(p) + shift; }
};

void checkShuffled(const Pair& pair, const Comparison& comparison, std::mt19937& random)
{
	RawSet raw = pair.raw;
	std::vector<std::vector<std::size_t>> orders(raw.blocks.size());
	for (std::size_t b = 0; b < raw.blocks.size(); ++b)
		if (raw.blocks[b].kind == RawKind::cells)
			raw.blocks[b] = shuffled(pair.raw.blocks[b], random, orders[b]);
	const grid::BlockSet set = build(raw);
	cut::Cutter cutter(set);
	const SlicedSheet sheet = cut(cutter, pair.asked);
	std::vector<std::vector<std::size_t>> cells = sourceCells(set, sheet);
	for (std::size_t b = 0; b < cells.size(); ++b)
		if (!orders[b].empty())
		{
			for (std::size_t& cell : cells[b])
				cell = orders[b][cell];
			std::ranges::sort(cells[b]);
		}
	comparison.expectSame("shuffled", set, sheet, cells, roundingOf(set, pair.plane));
	if (pair.generic && areaOf(sheet) > 0.0)
	{
		const double scale = std::abs(linearAt(set.bounds().lo)) + std::abs(linearAt(set.bounds().hi)) + 1.0;
		EXPECT_NEAR(meanOf(set, sheet), meanOf(pair.set, pair.sheet), 1e-9 * scale);
	}
}

void checkMoved(const Pair& pair, const Comparison& comparison, std::mt19937& random)
{
	const Box box = pair.set.bounds();
	std::uniform_real_distribution<double> angle(0.0, 6.0);
	Motion motion{randomDirection(random), angle(random), Vec3(0.0)};
	motion.shift = randomPoint({-box.size(), box.size()}, random);
	const RawSet raw = moved(pair.raw, motion);
	// A float's rounding is another grid, not a motion of this one.
	if (std::ranges::any_of(raw.blocks, &RawBlock::floats))
		return;
	const grid::BlockSet set = build(raw);
	cut::Cutter cutter(set);
	const TestPlane plane{motion(pair.plane.origin), motion.turned(pair.plane.normal)};
	const SlicedSheet sheet = cut(cutter, plane);
	if (keepsArea(pair))
		comparison.expectSame("moved", set, sheet, sourceCells(set, sheet),
		                      roundingOf(set, plane) + roundingOf(pair.set, pair.plane));
}

} // namespace

void checkInvariance(const Pair& pair, unsigned seed)
{
	std::mt19937 random(seed);
	const Comparison comparison(pair);
	cut::Cutter cutter(pair.set);
	const double rounding = roundingOf(pair.set, pair.plane);
	const auto again = [&](const char* how, const TestPlane& plane, double shift)
	{
		const SlicedSheet sheet = cut(cutter, plane);
		comparison.expectSame(how, pair.set, sheet, sourceCells(pair.set, sheet), rounding + shift);
	};
	const SlicedSheet flipped = cut(cutter, {pair.asked.origin, -1.0 * pair.asked.normal});
	EXPECT_EQ(sourceCells(pair.set, flipped), sourceCells(pair.set, pair.sheet));
	EXPECT_EQ(flipped.mesh.polygons(), pair.sheet.mesh.polygons());
	comparison.expectSame("flipped", pair.set, flipped, sourceCells(pair.set, flipped), rounding);
	if (keepsArea(pair))
	{
		TestPlane shifted = pair.asked;
		shifted.origin.x = std::nextafter(shifted.origin.x, 1e300);
		again("shifted by an ulp", shifted, 0.0);
	}
	checkShuffled(pair, comparison, random);
	checkMoved(pair, comparison, random);
}

} // namespace vp::test
