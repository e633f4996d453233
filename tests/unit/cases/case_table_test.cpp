#include "cases/case_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace vp::cases
{
namespace
{

using grid::CellShape;
using grid::ShapeTopology;

constexpr CellShape kShapes[] = {CellShape::tetrahedron, CellShape::pyramid, CellShape::wedge, CellShape::hexahedron};

using Corner = std::array<int, 3>;

std::vector<Corner> cornersOf(CellShape shape)
{
	switch (shape)
	{
	case CellShape::tetrahedron:
		return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	case CellShape::pyramid:
		return {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}};
	case CellShape::wedge:
		return {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}};
	default:
		return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
	}
}

// Returns true if a plane separates the corners of a mask from the others. If there is one, the perceptron finds it
// after at most (R / margin)^2 corrections: a few hundred for corners as near the origin as these.
bool separable(CellShape shape, unsigned mask)
{
	const std::vector<Corner> corners = cornersOf(shape);
	std::array<long, 4> weight{};
	for (int correction = 0; correction < 10000;)
	{
		bool wrong = false;
		for (std::size_t p = 0; p < corners.size(); ++p)
		{
			const int side = mask >> p & 1 ? 1 : -1;
			const long value =
			    weight[0] * corners[p][0] + weight[1] * corners[p][1] + weight[2] * corners[p][2] + weight[3];
			if (side * value > 0)
				continue;
			for (int axis = 0; axis < 3; ++axis)
				weight[axis] += side * corners[p][axis];
			weight[3] += side;
			wrong = true;
			++correction;
		}
		if (!wrong)
			return true;
	}
	return false;
}

unsigned allPositive(CellShape shape)
{
	return (1u << grid::topology(shape).points) - 1;
}

TEST(CaseTable, CountsOfValidMasks)
{
	const int valid_of[] = {14, 26, 44, 126};
	const int separable_of[] = {14, 26, 44, 102};
	for (const CellShape shape : kShapes)
	{
		const auto table = caseTable(shape);
		ASSERT_EQ(table.size(), allPositive(shape) + 1u);
		int valid = 0;
		int planar = 0;
		for (unsigned mask = 1; mask < allPositive(shape); ++mask)
		{
			EXPECT_NE(table[mask].edges > 0, table[mask].needs_walk);
			EXPECT_FALSE(separable(shape, mask) && table[mask].needs_walk) << grid::shapeName(shape) << " " << mask;
			valid += table[mask].edges > 0;
			planar += table[mask].edges > 0 && separable(shape, mask);
		}
		EXPECT_EQ(valid, valid_of[static_cast<int>(shape)]) << grid::shapeName(shape);
		EXPECT_EQ(planar, separable_of[static_cast<int>(shape)]) << grid::shapeName(shape);
		for (const unsigned mask : {0u, allPositive(shape)})
		{
			EXPECT_EQ(table[mask].edges, 0);
			EXPECT_EQ(table[mask].faces, 0);
			EXPECT_FALSE(table[mask].needs_walk);
		}
	}
}

TEST(CaseTable, PolygonRunsOverCutEdgesAndFaces)
{
	for (const CellShape shape : kShapes)
	{
		const ShapeTopology& table = grid::topology(shape);
		for (unsigned mask = 0; mask <= allPositive(shape); ++mask)
		{
			const Case& entry = caseTable(shape)[mask];
			unsigned faces = 0;
			for (int f = 0; f < table.faces; ++f)
			{
				unsigned some = 0;
				for (const std::uint8_t p : table.facePoints(f))
					some |= mask >> p & 1 ? 1 : 2;
				faces |= some == 3 ? 1u << f : 0;
			}
			EXPECT_EQ(entry.faces, faces);
			std::set<int> edges;
			for (int i = 0; i < entry.edges; ++i)
			{
				const auto [positive, negative] = entry.edge[i];
				EXPECT_TRUE(mask >> positive & 1);
				EXPECT_FALSE(mask >> negative & 1);
				EXPECT_TRUE(edges.insert(table.edgeBetween(positive, negative)).second);
				// Edges that follow each other lie in one face.
				const auto next = entry.edge[(i + 1) % entry.edges];
				bool together = false;
				for (int f = 0; f < table.faces; ++f)
				{
					const auto points = table.facePoints(f);
					const auto has = [&](std::uint8_t p) { return std::ranges::count(points, p) > 0; };
					together = together || (has(positive) && has(negative) && has(next[0]) && has(next[1]));
				}
				EXPECT_TRUE(together);
			}
			EXPECT_FALSE(edges.contains(-1));
			if (entry.edges > 0)
			{
				int cut = 0;
				for (int e = 0; e < table.edges; ++e)
					cut += (mask >> table.edge[e][0] & 1) != (mask >> table.edge[e][1] & 1);
				EXPECT_EQ(cut, entry.edges);
			}
		}
	}
}

TEST(CaseTable, ComplementIsTheSamePolygonReversed)
{
	for (const CellShape shape : kShapes)
		for (unsigned mask = 0; mask <= allPositive(shape); ++mask)
		{
			const Case& one = caseTable(shape)[mask];
			const Case& other = caseTable(shape)[mask ^ allPositive(shape)];
			EXPECT_EQ(one.needs_walk, other.needs_walk);
			ASSERT_EQ(one.edges, other.edges);
			EXPECT_EQ(one.faces, other.faces);
			if (one.edges == 0)
				continue;
			const auto flipped = [&](int i) { return std::array{other.edge[i][1], other.edge[i][0]}; };
			int start = 0;
			while (start < other.edges && flipped(start) != one.edge[0])
				++start;
			ASSERT_LT(start, other.edges);
			for (int i = 0; i < one.edges; ++i)
				EXPECT_EQ(one.edge[i], flipped((start + other.edges - i) % other.edges));
		}
}

// Seen from the positive side the polygon runs counter-clockwise: its normal points there.
TEST(CaseTable, PolygonFacesThePositiveSide)
{
	for (const CellShape shape : kShapes)
	{
		const std::vector<Corner> corners = cornersOf(shape);
		for (unsigned mask = 0; mask <= allPositive(shape); ++mask)
		{
			const Case& entry = caseTable(shape)[mask];
			if (entry.edges == 0 || !separable(shape, mask))
				continue;
			std::array<double, 3> normal{};
			std::array<double, 3> rise{};
			const auto middle = [&](int i, int axis)
			{ return 0.5 * (corners[entry.edge[i][0]][axis] + corners[entry.edge[i][1]][axis]); };
			for (int i = 0; i < entry.edges; ++i)
				for (int axis = 0; axis < 3; ++axis)
				{
					const int next = (i + 1) % entry.edges;
					const int u = (axis + 1) % 3;
					const int v = (axis + 2) % 3;
					normal[axis] += middle(i, u) * middle(next, v) - middle(i, v) * middle(next, u);
					rise[axis] += corners[entry.edge[i][0]][axis] - corners[entry.edge[i][1]][axis];
				}
			EXPECT_GT(normal[0] * rise[0] + normal[1] * rise[1] + normal[2] * rise[2], 0.0)
			    << grid::shapeName(shape) << " " << mask;
		}
	}
}

TEST(CaseTable, PackedWordsHoldTheCases)
{
	const std::vector<std::uint32_t> words = packedCaseTables();
	EXPECT_EQ(words.size(), 4u * (16 + 32 + 64 + 256));
	for (const CellShape shape : kShapes)
		for (unsigned mask = 0; mask <= allPositive(shape); ++mask)
		{
			const Case& entry = caseTable(shape)[mask];
			const std::uint32_t* word = &words[4 * (caseTableStart(shape) + mask)];
			EXPECT_EQ(word[0] & 0xFF, entry.edges);
			EXPECT_EQ(word[0] >> 8 & 0xFF, entry.faces);
			EXPECT_EQ(word[0] >> 16, entry.needs_walk ? 1u : 0u);
			for (int i = 0; i < entry.edges; ++i)
			{
				const std::uint32_t edge = word[1 + i / 2] >> 16 * (i % 2) & 0xFFFF;
				EXPECT_EQ(edge & 0xFF, entry.edge[i][0]);
				EXPECT_EQ(edge >> 8, entry.edge[i][1]);
			}
		}
}

} // namespace
} // namespace vp::cases
