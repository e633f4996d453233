#include "ranks/join/piece_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace vp::ranks
{

namespace
{

using Subscripts = std::array<int, 3>;

// The points of a lattice from the first to the last along i, j and k.
struct Extent
{
	Subscripts first;
	Subscripts last;
};

constexpr Extent kWhole{{0, 0, 0}, {4, 3, 6}};

using Place = Vec3 (*)(const Subscripts& at);

Vec3 bent(const Subscripts& at)
{
	return {at[0] + 0.1 * at[2], at[1] + 0.03 * at[0] * at[2], at[2] + 0.02 * at[0] * at[1]};
}

// Closes along one axis.
template <std::size_t kAround>
Vec3 ring(const Subscripts& at)
{
	const int steps = kWhole.last[kAround];
	const double angle = 2.0 * std::numbers::pi * (at[kAround] % steps) / steps;
	const double radius = 1.0 + at[(kAround + 1) % 3];
	return {radius * std::cos(angle), radius * std::sin(angle), double(at[(kAround + 2) % 3])};
}

render::EdgeCurves curvesOf(const Extent& extent, Place place)
{
	std::array<std::uint32_t, 3> points{};
	for (std::size_t axis = 0; axis < 3; ++axis)
		points[axis] = static_cast<std::uint32_t>(extent.last[axis] - extent.first[axis] + 1);
	std::vector<double> xyz;
	for (int k = extent.first[2]; k <= extent.last[2]; ++k)
		for (int j = extent.first[1]; j <= extent.last[1]; ++j)
			for (int i = extent.first[0]; i <= extent.last[0]; ++i)
			{
				const Vec3 p = place({i, j, k});
				xyz.insert(xyz.end(), {p.x, p.y, p.z});
			}
	return render::edgeCurves(grid::CurvilinearGrid(points, grid::Points(Array<double>(std::move(xyz)))));
}

using Lines = std::vector<std::array<double, 6>>;

// Each with its ends in order; sorted.
Lines sorted(const std::vector<render::Segment>& segments)
{
	Lines lines;
	for (const render::Segment& segment : segments)
	{
		std::array<double, 3> a{segment.a.x, segment.a.y, segment.a.z};
		std::array<double, 3> b{segment.b.x, segment.b.y, segment.b.z};
		if (b < a)
			std::swap(a, b);
		lines.push_back({a[0], a[1], a[2], b[0], b[1], b[2]});
	}
	std::ranges::sort(lines);
	return lines;
}

Lines linesOf(const std::vector<Extent>& extents, Place place)
{
	std::vector<render::EdgeCurves> pieces;
	for (const Extent& extent : extents)
		pieces.push_back(curvesOf(extent, place));
	return sorted(outlineOfPieces(pieces));
}

Lines linesOfWhole(Place place)
{
	std::vector<render::Segment> segments;
	for (const std::vector<Vec3>& curve : curvesOf(kWhole, place))
		for (std::size_t i = 1; i < curve.size(); ++i)
			segments.push_back({curve[i - 1], curve[i]});
	return sorted(segments);
}

// Two halves along an axis.
std::vector<Extent> halves(std::size_t axis)
{
	std::vector<Extent> both(2, kWhole);
	both[0].last[axis] = both[1].first[axis] = kWhole.last[axis] / 2;
	return both;
}

} // namespace

TEST(PieceOutline, OfOnePieceIsItsOwn)
{
	EXPECT_EQ(linesOf({kWhole}, bent), linesOfWhole(bent));
	EXPECT_EQ(linesOf({kWhole}, bent).size(), 4u * (4 + 3 + 6));
}

TEST(PieceOutline, OfSlabsIsThatOfTheWhole)
{
	for (std::size_t axis = 0; axis < 3; ++axis)
		EXPECT_EQ(linesOf(halves(axis), bent), linesOfWhole(bent)) << axis;
	const std::vector<Extent> three{{{0, 0, 0}, {4, 3, 1}}, {{0, 0, 1}, {4, 3, 4}}, {{0, 0, 4}, {4, 3, 6}}};
	EXPECT_EQ(linesOf(three, bent), linesOfWhole(bent));
}

TEST(PieceOutline, OfPiecesAlongEveryAxisIsThatOfTheWhole)
{
	std::vector<Extent> octants(8, kWhole);
	constexpr Subscripts kMiddle{2, 1, 4};
	for (std::size_t octant = 0; octant < 8; ++octant)
		for (std::size_t axis = 0; axis < 3; ++axis)
			(octant >> axis & 1 ? octants[octant].first : octants[octant].last)[axis] = kMiddle[axis];
	EXPECT_EQ(linesOf(octants, bent), linesOfWhole(bent));
}

// The whole has the lines where it closes twice: those of its first layer and those of its last one.
TEST(PieceOutline, OfARingIsThatOfTheWholeInSlabsAlongTheLastAxisAlone)
{
	EXPECT_EQ(linesOf(halves(2), ring<2>), linesOfWhole(ring<2>));
	Lines around = linesOfWhole(ring<0>);
	const auto isAround = [](const std::array<double, 6>& line) { return line[0] != line[3] || line[1] != line[4]; };
	EXPECT_LT(linesOf(halves(0), ring<0>).size(), around.size());
	EXPECT_TRUE(std::ranges::all_of(linesOf(halves(0), ring<0>), isAround));
}

} // namespace vp::ranks
