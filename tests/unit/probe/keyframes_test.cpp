#include "probe/spline.h"

#include "probe/presets.h"

#include "random_probes.h"

namespace vp::test
{

using probe::Frame;
using probe::Key;

namespace
{

std::vector<Key> randomKeys(std::mt19937& random, int count)
{
	std::vector<Key> keys;
	double at = between(-5.0, 5.0, random);
	for (int i = 0; i < count; ++i)
	{
		keys.push_back({at, randomFrame(random)});
		at += between(0.3, 3.0, random);
	}
	return keys;
}

std::vector<Frame> film(std::vector<Key> keys, int frames, bool there_and_back = false)
{
	probe::Path path;
	path.kind = probe::PathKind::keyframes;
	path.keys = std::move(keys);
	path.there_and_back = there_and_back;
	return poses(path, probe::single({}), {}, frames);
}

// By how much a frame's nine numbers change per unit of time, on one side of it.
std::array<Vec3, 3> velocity(const std::vector<Key>& keys, double period, double time, double step)
{
	// One-sided difference of second order: (-3 f(0) + 4 f(h) - f(2h)) / 2h.
	const Frame a = splinePose(keys, period, time);
	const Frame b = splinePose(keys, period, time + step);
	const Frame c = splinePose(keys, period, time + 2.0 * step);
	const auto slope = [&](const Vec3& f0, const Vec3& f1, const Vec3& f2)
	{ return (-3.0 * f0 + 4.0 * f1 - f2) / (2.0 * step); };
	return {slope(a.origin, b.origin, c.origin), slope(a.normal, b.normal, c.normal), slope(a.up, b.up, c.up)};
}

void expectSmoothAt(const std::vector<Key>& keys, double period, double time)
{
	const auto before = velocity(keys, period, time, -1e-5);
	const auto after = velocity(keys, period, time, 1e-5);
	for (int i = 0; i < 3; ++i)
		expectNear(before[i], after[i], 1e-4 * (1.0 + glm::length(after[i])));
}

} // namespace

TEST(Keyframes, PassExactlyThroughTheKeys)
{
	std::mt19937 random(51);
	for (int i = 0; i < 50; ++i)
		for (const double period : {0.0, 100.0})
		{
			const std::vector<Key> keys = randomKeys(random, 2 + i % 5);
			for (const Key& key : keys)
			{
				EXPECT_EQ(splinePose(keys, period, key.at), key.frame);
				// And all but there just beside it.
				expectNear(splinePose(keys, period, key.at + 1e-9), key.frame, 1e-6);
				if (&key != &keys.front())
					expectNear(splinePose(keys, period, key.at - 1e-9), key.frame, 1e-6);
			}
		}
}

TEST(Keyframes, MoveAndTurnSmoothlyThroughTheKeys)
{
	std::mt19937 random(52);
	for (int i = 0; i < 50; ++i)
	{
		const std::vector<Key> keys = randomKeys(random, 5);
		for (int k = 1; k < 4; ++k)
			expectSmoothAt(keys, 0.0, keys[k].at);
	}
}

TEST(Keyframes, ALoopIsSmoothWhereItClosesToo)
{
	std::mt19937 random(53);
	for (int i = 0; i < 50; ++i)
	{
		const std::vector<Key> keys = randomKeys(random, 3);
		const double period = keys.back().at - keys.front().at + 1.5;
		expectNear(splinePose(keys, period, keys.front().at + period), keys.front().frame, 1e-11);
		for (const Key& key : keys)
			expectSmoothAt(keys, period, key.at + period);
	}
}

TEST(Keyframes, TwoKeysMoveStraightAndTurnEvenly)
{
	const Frame start;
	Frame end = turned(start, Vec3(0.0), {1.0, 2.0, 3.0}, 120.0);
	end.origin = {2.0, 4.0, 8.0};
	const std::vector<Frame> frames = film({{0.0, start}, {7.0, end}}, 5);
	for (int k = 0; k < 5; ++k)
	{
		Frame expected = turned(start, Vec3(0.0), {1.0, 2.0, 3.0}, 30.0 * k);
		expected.origin = 0.25 * k * end.origin;
		expectNear(frames[k], expected, 1e-14);
	}
}

// Users find out by comparing frames whether a probe rests, so a rest must be exact.
TEST(Keyframes, ARestIsExact)
{
	std::mt19937 random(52);
	for (int i = 0; i < 50; ++i)
	{
		const Frame rest = randomFrame(random);
		const Frame other = randomFrame(random);
		for (const Frame& frame : film({{0.0, rest}, {5.0, rest}}, 9))
			EXPECT_EQ(frame, rest);
		// A stretch of a longer path. Both of its ends have no velocity.
		const std::vector<Key> keys{{0.0, rest}, {1.0, rest}, {2.0, rest}, {3.0, other}};
		EXPECT_EQ(splinePose(keys, 0.0, 0.3), rest);
		EXPECT_NE(splinePose(keys, 0.0, 1.7), rest);
	}
}

// Keys on an even motion, at uneven times, give back that motion; positions even a parabola's.
TEST(Keyframes, ReproduceAnEvenTurnAndAParabola)
{
	const auto motion = [](double t)
	{
		Frame frame = probe::turned({}, Vec3(0.0), {3.0, -1.0, 2.0}, 40.0 * t);
		frame.origin = {t, t * t, 5.0 - 2.0 * t * t};
		return frame;
	};
	std::vector<Key> keys;
	for (const double at : {0.0, 0.5, 2.0, 3.0, 6.0})
		keys.push_back({at, motion(at)});
	for (int i = 0; i <= 600; ++i)
		expectNear(splinePose(keys, 0.0, 0.01 * i), motion(0.01 * i), 1e-12);
}

TEST(Keyframes, AreFramesAllTheWay)
{
	std::mt19937 random(54);
	const std::vector<Key> keys = randomKeys(random, 6);
	for (const Frame& frame : film(keys, 500))
	{
		EXPECT_NEAR(glm::length(frame.normal), 1.0, 1e-14);
		EXPECT_NEAR(glm::length(frame.up), 1.0, 1e-14);
		EXPECT_NEAR(glm::dot(frame.normal, frame.up), 0.0, 1e-14);
	}
}

TEST(Keyframes, AFilmOfItsOwnLengthHasTheKeysThemselves)
{
	std::mt19937 random(55);
	std::vector<Key> keys = randomKeys(random, 4);
	const std::array<int, 4> at{3, 20, 21, 50};
	for (int k = 0; k < 4; ++k)
		keys[k].at = at[k];
	const std::vector<Frame> frames = film(keys, 48);
	for (int k = 0; k < 4; ++k)
		EXPECT_EQ(frames[at[k] - 3], keys[k].frame);

	const std::vector<Frame> back = film(keys, 94, true);
	for (int k = 0; k < 4; ++k)
	{
		EXPECT_EQ(back[at[k] - 3], keys[k].frame);
		EXPECT_EQ(back[(94 - (at[k] - 3)) % 94], keys[k].frame);
	}
}

TEST(Keyframes, OppositeOrientationsAreNoTrouble)
{
	const Frame start;
	const Frame over = turned(start, Vec3(0.0), {0.0, 1.0, 0.0}, 180.0);
	for (const Frame& frame : film({{0.0, start}, {1.0, over}, {2.0, start}, {3.0, start}}, 61))
	{
		EXPECT_NEAR(glm::length(frame.normal), 1.0, 1e-14);
		EXPECT_NEAR(glm::length(frame.up), 1.0, 1e-14);
	}
}

} // namespace vp::test
