#include "probe/path.h"

#include "probe/presets.h"

#include "random_probes.h"

#include <map>

namespace vp::test
{

using probe::Frame;
using probe::Path;
using probe::PathKind;

namespace
{

const Box kPathBounds{{-1.0, 0.0, 2.0}, {3.0, 4.0, 8.0}};

probe::Probe probeAt(const Frame& frame)
{
	return probe::paddlewheel(frame, kPathBounds, 3);
}

Path pathOf(PathKind kind)
{
	Path path;
	path.kind = kind;
	return path;
}

} // namespace

TEST(Path, TranslationVisitsEqualSlabsOfTheBounds)
{
	Frame start; // normal z; the bounds reach from 2 to 8
	start.origin = {0.5, 1.5, 100.0};
	const std::vector<Frame> frames = poses(pathOf(PathKind::translate), probeAt(start), kPathBounds, 3);
	ASSERT_EQ(frames.size(), 3u);
	for (int k = 0; k < 3; ++k)
	{
		expectNear(frames[k].origin, {0.5, 1.5, 3.0 + 2.0 * k}, 1e-13);
		EXPECT_EQ(frames[k].normal, start.normal);
		EXPECT_EQ(frames[k].up, start.up);
	}
	EXPECT_EQ(poses(pathOf(PathKind::translate), probeAt(start), kPathBounds, 1)[0].origin, Vec3(0.5, 1.5, 5.0));
}

TEST(Path, TranslationAlongAnyAxisStaysInTheBounds)
{
	std::mt19937 random(41);
	for (int i = 0; i < 50; ++i)
	{
		Path path = pathOf(PathKind::translate);
		const Frame start = randomFrame(random);
		path.axis = 7.0 * randomDirection(random);
		const Vec3 axis = glm::normalize(*path.axis);
		const std::vector<Frame> frames = poses(path, probeAt(start), kPathBounds, 9);
		const double step = glm::dot(frames[1].origin - frames[0].origin, axis);
		const double reach = glm::dot(glm::abs(axis), 0.5 * kPathBounds.size());
		EXPECT_NEAR(step * 9.0, 2.0 * reach, 1e-12);
		for (int k = 0; k < 9; ++k)
		{
			const double at = glm::dot(frames[k].origin - kPathBounds.center(), axis);
			EXPECT_NEAR(at, (k - 4) * step, 1e-12);
			expectNear(glm::cross(frames[k].origin - start.origin, axis), Vec3(0.0), 1e-12); // not off its line
		}
	}
}

TEST(Path, ThereAndBackPassesEachPlaceTwiceButItsEnds)
{
	Path path = pathOf(PathKind::translate);
	path.there_and_back = true;
	const std::vector<Frame> frames = poses(path, probeAt({}), kPathBounds, 6);
	ASSERT_EQ(frames.size(), 6u);
	for (const auto& [k, z] : std::map<int, double>{{0, 2.75}, {1, 4.25}, {2, 5.75}, {3, 7.25}, {4, 5.75}, {5, 4.25}})
		EXPECT_NEAR(frames[k].origin.z, z, 1e-13) << k;
	EXPECT_NEAR(poses(path, probeAt({}), kPathBounds, 1)[0].origin.z, 5.0, 1e-13);
}

TEST(Path, RotationGoesRoundTheUpAxisAndLeavesItsEndOut)
{
	std::mt19937 random(42);
	const Frame start = randomFrame(random);
	const std::vector<Frame> frames = poses(pathOf(PathKind::rotate), probeAt(start), kPathBounds, 8);
	ASSERT_EQ(frames.size(), 8u);
	expectNear(frames[0], start, 1e-15);
	for (int k = 0; k < 8; ++k)
	{
		EXPECT_EQ(frames[k].origin, start.origin);
		expectNear(frames[k].up, start.up, 1e-14);
		expectNear(turned(frames[k], start.origin, start.up, 45.0), frames[(k + 1) % 8], 1e-14); // and so it loops
	}
}

TEST(Path, RotationAboutAnyAxisInSpace)
{
	Path path = pathOf(PathKind::rotate);
	path.axis = Vec3(0.0, 0.0, 2.0);
	path.through = Vec3(1.0, 0.0, 0.0);
	path.degrees = 90.0; // no whole turn: both ends are there
	const std::vector<Frame> frames = poses(path, probeAt({}), kPathBounds, 3);
	expectNear(frames[0], Frame(), 1e-15);
	expectNear(frames[1].origin, {1.0 - std::sqrt(0.5), -std::sqrt(0.5), 0.0}, 1e-15);
	expectNear(frames[2].origin, {1.0, -1.0, 0.0}, 1e-15);
	expectNear(frames[2].up, {-1.0, 0.0, 0.0}, 1e-15);
}

TEST(Path, SpinKeepsThePlane)
{
	std::mt19937 random(43);
	const Frame start = randomFrame(random);
	const std::vector<Frame> frames = poses(pathOf(PathKind::spin), probeAt(start), kPathBounds, 5);
	for (int k = 0; k < 5; ++k)
	{
		EXPECT_EQ(frames[k].origin, start.origin);
		expectNear(frames[k].normal, start.normal, 1e-14);
		EXPECT_NEAR(glm::dot(frames[k].up, start.up), std::cos(2.0 * std::numbers::pi * k / 5.0), 1e-14);
	}
}

// The paper: "a complete revolution may be faked by film looping the sweep between consecutive vanes".
TEST(Path, RevolveLoopsFromVaneToVane)
{
	std::mt19937 random(44);
	for (const int vanes : {1, 2, 3, 5})
		for (const int frames : {1, 2, 7})
		{
			probe::Probe probe = probe::paddlewheel(randomFrame(random), kPathBounds, vanes);
			const Frame start = probe.frame;
			const std::vector<Frame> film = poses(pathOf(PathKind::revolve), probe, kPathBounds, frames);
			const probe::Probe first = placed(probe);
			expectNear(film[0], start, 1e-14);
			// One step on from the last frame every vane lies where the next one began.
			probe.frame = turned(film.back(), start.origin, start.up, 360.0 / vanes / frames);
			const probe::Probe next = placed(probe);
			for (int k = 0; k < vanes; ++k)
				expectNear(next.sheets[k], first.sheets[(k + 1) % vanes], 1e-13);
		}
	Path six = pathOf(PathKind::revolve);
	six.vanes = 6;
	const std::vector<Frame> film = poses(six, probeAt({}), kPathBounds, 2);
	expectNear(film[1], probe::turned({}, Vec3(0.0), {0.0, 1.0, 0.0}, 30.0), 1e-15);
}

// As the benchmark's figures were taken.
TEST(Path, ProfileIsTheBenchmarksSweep)
{
	const std::vector<Frame> frames = poses(pathOf(PathKind::profile), probeAt({}), kPathBounds, probe::kProfilePlanes);
	ASSERT_EQ(frames.size(), 60u);
	const Vec3 n0 = Vec3(0.3, 0.5, 0.81) / std::sqrt(0.09 + 0.25 + 0.6561);
	for (int k = 0; k < 60; ++k)
	{
		const double t = (-30.0 + 60.0 * k / 59.0) * std::numbers::pi / 180.0;
		const Vec3 n(std::cos(t) * n0.x - std::sin(t) * n0.y, std::sin(t) * n0.x + std::cos(t) * n0.y, n0.z);
		const double h = 0.5 * (std::abs(n.x) * 4.0 + std::abs(n.y) * 4.0 + std::abs(n.z) * 6.0);
		expectNear(frames[k].normal, n, 1e-14);
		expectNear(frames[k].origin, kPathBounds.center() + n * (-0.6 + 1.2 * k / 59.0) * h, 1e-13);
	}
}

TEST(Path, KnowsItsFrames)
{
	Path path = pathOf(PathKind::rotate);
	EXPECT_EQ(framesOf(path, 25.0), std::nullopt);
	path.length = 48.0;
	EXPECT_EQ(framesOf(path, 25.0), 48);
	path.unit = probe::TimeUnit::seconds;
	EXPECT_EQ(framesOf(path, 25.0), 1200);
	path.length = 1e-3;
	EXPECT_EQ(framesOf(path, 25.0), 1);

	Path keyed = pathOf(PathKind::keyframes);
	keyed.keys = {{10.0, {}}, {40.0, {}}};
	EXPECT_EQ(framesOf(keyed, 25.0), 31);
	keyed.there_and_back = true;
	EXPECT_EQ(framesOf(keyed, 25.0), 60);
	keyed.there_and_back = false;
	keyed.loop = true;
	keyed.length = 50.0;
	EXPECT_EQ(framesOf(keyed, 25.0), 50);
}

} // namespace vp::test
