#include "cases/face_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace vp::cases
{
namespace
{

using Edges = std::vector<std::pair<int, int>>;

struct Answer
{
	Pairing pairing;
	Edges order;

	bool operator==(const Answer&) const = default;
};

// A face listed from each of its points on, either way round: all answers. The crossings lie at their places.
std::vector<Answer> answersOf(std::vector<FacePoint> face, const std::vector<Crossing>& crossings,
                              const std::vector<FacePairs::Placed>& places)
{
	std::vector<Answer> answers;
	FacePairs pairs;
	for (int way = 0; way < 2; ++way)
	{
		for (std::size_t first = 0; first < face.size(); ++first)
		{
			std::vector<Crossing> listed = crossings;
			Answer answer{pairs.of(face, listed, [&](const Crossing& c) { return places[c.edge.positive]; }), {}};
			for (const Crossing& crossing : listed)
				answer.order.emplace_back(crossing.edge.positive, crossing.edge.negative);
			answers.push_back(std::move(answer));
			std::rotate(face.begin(), face.begin() + 1, face.end());
		}
		std::reverse(face.begin(), face.end());
	}
	return answers;
}

// Two cells list a face from other points on, and the other way round. In these orders the heights add up to 0 or to
// -1.
TEST(FacePairs, TheMeanIsTheSameFromEachPointOn)
{
	const std::vector<FacePoint> square{{{0, 0, 0}, 1e16}, {{1, 0, 0}, 1.0}, {{1, 1, 0}, -1e16}, {{0, 1, 0}, -1.0}};
	for (const Answer& answer : answersOf(square, {}, {}))
		EXPECT_EQ(answer.pairing, Pairing::negative_apart);
}

// A dart, symmetrical about a line, as are its heights: its trace runs across the line exactly. So the two crossings
// lie at one place of it, and what tells them apart is how they move.
TEST(FacePairs, TheTraceIsTheSameFromEachPointOn)
{
	std::mt19937 random(6);
	std::uniform_real_distribution<double> height(-1.0, 1.0);
	const std::vector<Vec3> half{{3.0, 0.5, 0.0}, {5.0, 1.0, 0.0}, {3.0, 1.2, 0.0}};
	const auto mirrored = [](const Vec3& p) { return Vec3(p.y, p.x, p.z); };
	for (int round = 0; round < 200; ++round)
	{
		std::vector<FacePoint> dart{{Vec3(0.0), height(random)}};
		for (const Vec3& p : half)
			dart.push_back({p, height(random)});
		dart.push_back({Vec3(1.0, 1.0, 0.0), height(random)});
		for (std::size_t i = half.size(); i-- > 0;)
			dart.push_back({mirrored(half[i]), dart[i + 1].height});
		const std::vector<Answer> answers =
		    answersOf(dart, {{{0, 9}, true}, {{1, 9}, false}},
		              {{{2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {{4.0, 2.0, 0.0}, {-1.0, 0.0, 0.0}}});
		for (const Answer& answer : answers)
			EXPECT_EQ(answer, (Answer{Pairing::in_order, {{1, 9}, {0, 9}}})) << round;
	}
}

} // namespace
} // namespace vp::cases
