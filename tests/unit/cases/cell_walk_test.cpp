#include "cases/cell_walk.h"
#include "grid/cell_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

namespace vp::cases
{
namespace
{

WalkFaces facesOf(const std::vector<std::vector<int>>& lists)
{
	WalkFaces faces;
	faces.starts.push_back(0);
	for (const std::vector<int>& list : lists)
	{
		for (const int p : list)
			faces.points.push_back(static_cast<std::uint16_t>(p));
		faces.starts.push_back(static_cast<std::uint32_t>(faces.points.size()));
	}
	return faces;
}

const WalkFaces& hexahedron()
{
	static const WalkFaces faces =
	    facesOf({{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}});
	return faces;
}

std::vector<std::uint8_t> bits(unsigned mask, int points)
{
	std::vector<std::uint8_t> positive(points);
	for (int p = 0; p < points; ++p)
		positive[p] = mask >> p & 1;
	return positive;
}

Pairing pairingOf(bool center_positive)
{
	return center_positive ? Pairing::negative_apart : Pairing::positive_apart;
}

CellCut walk(const WalkFaces& faces, const std::vector<std::uint8_t>& positive, bool center)
{
	CellCut cut;
	walkCell(
	    faces, positive, [&](int, auto) { return pairingOf(center); }, cut);
	return cut;
}

TEST(CellWalk, EveryMaskOfAHexahedronCloses)
{
	for (unsigned mask = 0; mask < 256; ++mask)
		for (const bool center : {false, true})
		{
			const CellCut cut = walk(hexahedron(), bits(mask, 8), center);
			EXPECT_FALSE(cut.open) << mask;
			// Each cut edge once, in all polygons together.
			std::size_t cut_edges = 0;
			const auto& shape = grid::topology(grid::CellShape::hexahedron);
			for (int e = 0; e < shape.edges; ++e)
				cut_edges += (mask >> shape.edge[e][0] & 1) != (mask >> shape.edge[e][1] & 1);
			EXPECT_EQ(cut.edges.size(), cut_edges) << mask;
			std::size_t face_cuts = 0;
			for (const std::uint8_t count : cut.face_cuts)
				face_cuts += count;
			EXPECT_EQ(face_cuts, 2 * cut_edges) << mask;
			EXPECT_EQ(cut.starts.back(), cut.edges.size());
		}
}

TEST(CellWalk, AmbiguousFaceFollowsItsCenter)
{
	// Two opposite corners of the bottom face: cut off one by one, or joined through the face's middle.
	const std::vector<std::uint8_t> positive = bits(0b0101, 8);
	const CellCut apart = walk(hexahedron(), positive, false);
	EXPECT_TRUE(apart.ambiguous);
	EXPECT_EQ(apart.polygons(), 2);
	EXPECT_EQ(apart.face_cuts[4], 4);
	const CellCut joined = walk(hexahedron(), positive, true);
	EXPECT_EQ(joined.polygons(), 1);
	EXPECT_EQ(joined.edges.size(), 6u);
}

// Both cells of a face pair its edges in the same way, though they list the face in opposite senses.
TEST(CellWalk, BothCellsOfAnAmbiguousFaceAgree)
{
	const auto pairs = [](const WalkFaces& faces, unsigned mask, bool center)
	{
		// Segments within face 0, as unordered pairs of edges.
		std::vector<Crossing> crossings;
		detail::WalkScratch scratch;
		detail::findCrossings(faces, 0, bits(mask, 8), crossings);
		detail::addSegments(crossings, 0, pairingOf(center), scratch);
		std::map<std::pair<int, int>, std::pair<int, int>> joined;
		for (const detail::Segment& s : scratch.segments)
		{
			joined[{s.from.positive, s.from.negative}] = {s.to.positive, s.to.negative};
			joined[{s.to.positive, s.to.negative}] = {s.from.positive, s.from.negative};
		}
		return joined;
	};
	for (unsigned mask = 0; mask < 256; ++mask)
		for (const bool center : {false, true})
			EXPECT_EQ(pairs(facesOf({{0, 1, 2, 3, 4, 5, 6, 7}}), mask, center),
			          pairs(facesOf({{3, 2, 1, 0, 7, 6, 5, 4}}), mask, center));
}

TEST(CellWalk, RepeatedPointsAreNoEdges)
{
	// A hexahedron with two corners drawn together, its face listing the point twice.
	const WalkFaces faces =
	    facesOf({{0, 4, 0, 0}, {1, 2, 6, 5}, {0, 1, 5, 4}, {0, 0, 6, 2}, {0, 0, 2, 1}, {4, 5, 6, 0}});
	for (unsigned mask = 0; mask < 128; ++mask)
	{
		const CellCut cut = walk(faces, bits(mask, 7), false);
		for (const CutEdge& edge : cut.edges)
			EXPECT_NE(edge.positive, edge.negative);
	}
	const CellCut twice = walk(facesOf({{0, 0, 1, 1, 2, 2}, {0, 1, 3, 3}, {1, 2, 3}, {2, 2, 0, 3}}), bits(1, 4), false);
	EXPECT_FALSE(twice.open);
	EXPECT_EQ(twice.polygons(), 1);
	EXPECT_EQ(twice.edges.size(), 3u);
}

TEST(CellWalk, FacesListedEitherWayRoundStillClose)
{
	std::mt19937 random(4);
	for (unsigned mask = 1; mask < 255; ++mask)
	{
		WalkFaces faces = hexahedron();
		for (int f = 0; f < faces.size(); ++f)
			if (random() % 2)
				std::reverse(faces.points.begin() + faces.starts[f], faces.points.begin() + faces.starts[f + 1]);
		const CellCut expected = walk(hexahedron(), bits(mask, 8), false);
		const CellCut cut = walk(faces, bits(mask, 8), false);
		EXPECT_FALSE(cut.open);
		EXPECT_EQ(cut.polygons(), expected.polygons()) << mask;
		EXPECT_EQ(cut.edges.size(), expected.edges.size()) << mask;
	}
}

TEST(CellWalk, MissingFaceIsTold)
{
	// Without its top: the polygon at mid height on one side is closed straight.
	const WalkFaces faces = facesOf({{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}});
	const CellCut cut = walk(faces, bits(0b00110011, 8), false);
	EXPECT_TRUE(cut.open);
	ASSERT_EQ(cut.polygons(), 1);
	EXPECT_EQ(cut.edges.size(), 4u);
	const CellCut whole = walk(faces, bits(0b00001111, 8), false);
	EXPECT_FALSE(whole.open);
	EXPECT_EQ(whole.edges.size(), 4u);
}

TEST(CellWalk, ManyRunsOnOneFace)
{
	// A prism over a polygon of 40 points, every other one positive.
	std::vector<std::vector<int>> lists(2);
	constexpr int n = 40;
	for (int p = 0; p < n; ++p)
	{
		lists[0].insert(lists[0].begin(), p);
		lists[1].push_back(n + p);
		lists.push_back({p, (p + 1) % n, n + (p + 1) % n, n + p});
	}
	std::vector<std::uint8_t> positive(2 * n);
	for (int p = 0; p < 2 * n; ++p)
		positive[p] = p % 2;
	const CellCut apart = walk(facesOf(lists), positive, false);
	EXPECT_EQ(apart.face_cuts[0], n);
	EXPECT_FALSE(apart.open);
	EXPECT_EQ(apart.polygons(), n / 2);
	const CellCut joined = walk(facesOf(lists), positive, true);
	EXPECT_EQ(joined.polygons(), n / 2);
	EXPECT_EQ(joined.edges.size(), 2u * n);
}

// Two cubes that share an edge alone, as one cell: four faces meet there. Whatever the order of the faces, polygons go
// through each face once, from where its rim leaves the positive side to where it comes back.
TEST(CellWalk, FacesThatMeetAtAnEdgeTwice)
{
	// Points 0 to 7 are one cube; the other one has its edge 2 6, and 8 to 13.
	std::vector<std::vector<int>> lists{{0, 3, 2, 1},  {4, 5, 6, 7},   {0, 1, 5, 4},    {1, 2, 6, 5},
	                                    {2, 3, 7, 6},  {3, 0, 4, 7},   {2, 10, 9, 8},   {6, 11, 12, 13},
	                                    {2, 8, 11, 6}, {8, 9, 12, 11}, {9, 10, 13, 12}, {10, 2, 6, 13}};
	std::vector<std::uint8_t> positive(14, 0);
	for (const int top : {4, 5, 6, 7, 11, 12, 13})
		positive[top] = 1;
	std::mt19937 random(3);
	for (int order = 0; order < 50; ++order)
	{
		std::shuffle(lists.begin(), lists.end(), random);
		std::multiset<std::array<int, 4>> expected;
		for (const std::vector<int>& face : lists)
		{
			std::array<int, 4> way{}; // the edge where the rim leaves the positive side, and the other one
			for (std::size_t i = 0; i < 4; ++i)
			{
				const int here = face[i];
				const int next = face[(i + 1) % 4];
				if (positive[here] > positive[next])
					way = {here, next, way[2], way[3]};
				else if (positive[here] < positive[next])
					way = {way[0], way[1], next, here};
			}
			if (way != std::array<int, 4>{})
				expected.insert(way);
		}
		const CellCut cut = walk(facesOf(lists), positive, false);
		EXPECT_FALSE(cut.open);
		std::multiset<std::array<int, 4>> found;
		for (int p = 0; p < cut.polygons(); ++p)
			for (std::uint32_t e = cut.starts[p]; e < cut.starts[p + 1]; ++e)
			{
				const CutEdge& from = cut.edges[e];
				const CutEdge& to = cut.edges[e + 1 < cut.starts[p + 1] ? e + 1 : cut.starts[p]];
				found.insert({from.positive, from.negative, to.positive, to.negative});
			}
		EXPECT_EQ(found, expected) << order;
	}
}

TEST(CellWalk, FaceThatGoesRoundForever)
{
	std::vector<int> round;
	for (int i = 0; i < 400000; ++i)
		round.push_back(i % 2 ? i / 2 % 3 : 3);
	const CellCut cut = walk(facesOf({round, round, {0, 1, 3}}), bits(0b0111, 4), true);
	EXPECT_EQ(cut.face_cuts[0], 254);
}

TEST(CellWalk, SurvivesMalformedCells)
{
	std::mt19937 random(9);
	for (int round = 0; round < 20000; ++round)
	{
		const int points = 1 + random() % 12;
		std::vector<std::vector<int>> lists(random() % 10);
		for (std::vector<int>& list : lists)
		{
			list.resize(random() % (round % 50 == 0 ? 700 : 9));
			for (int& p : list)
				p = random() % (points + (round % 7 == 0 ? 2 : 0)); // some of no point of the cell
		}
		std::vector<std::uint8_t> positive(points);
		for (std::uint8_t& sign : positive)
			sign = random() % 2;
		const WalkFaces faces = facesOf(lists);
		CellCut cut;
		walkCell(
		    faces, positive, [&](int, auto) { return static_cast<Pairing>(random() % 3); }, cut);
		ASSERT_EQ(cut.face_cuts.size(), lists.size());
		ASSERT_EQ(cut.starts.back(), cut.edges.size());
		for (int p = 0; p < cut.polygons(); ++p)
			ASSERT_GE(cut.starts[p + 1] - cut.starts[p], 3u);
		for (const CutEdge& edge : cut.edges)
		{
			ASSERT_LT(edge.positive, points);
			ASSERT_LT(edge.negative, points);
			ASSERT_TRUE(positive[edge.positive] && !positive[edge.negative]);
		}
		for (const std::uint8_t count : cut.face_cuts)
			ASSERT_EQ(count % 2, 0);
	}
	WalkFaces torn = hexahedron();
	torn.starts[3] = 1000;
	EXPECT_TRUE(walk(torn, bits(3, 8), false).open);
	EXPECT_EQ(walk(WalkFaces{}, bits(3, 8), false).polygons(), 0);
}

} // namespace
} // namespace vp::cases
