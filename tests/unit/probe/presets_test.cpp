#include "probe/presets.h"

#include "random_probes.h"

namespace vp::test
{

namespace
{

const Box kBounds{{-1.0, 0.0, 2.0}, {3.0, 4.0, 8.0}}; // its diagonal is sqrt(68)

std::vector<Vec3> corners(const Box& box)
{
	std::vector<Vec3> found;
	for (int corner = 0; corner < 8; ++corner)
		found.push_back(
		    {corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y, corner & 4 ? box.hi.z : box.lo.z});
	return found;
}

} // namespace

TEST(Presets, SingleIsTheProbesPlane)
{
	std::mt19937 random(31);
	const probe::Frame frame = randomFrame(random);
	const probe::Probe probe = probe::single(frame, probe::WindowSize{4.0, 2.0});
	ASSERT_EQ(probe.sheets.size(), 1u);
	EXPECT_EQ(static_cast<const probe::Frame&>(probe.sheets[0]), probe::Frame());
	EXPECT_EQ(probe.sheets[0].window, (probe::Window{-2.0, 2.0, -1.0, 1.0}));
	expectNear(placed(probe).sheets[0], frame, 1e-15);
	EXPECT_FALSE(probe::single(frame).sheets[0].window);
}

TEST(Presets, TrihedralIsNormalToXUpAndNormal)
{
	std::mt19937 random(32);
	for (int i = 0; i < 50; ++i)
	{
		const probe::Frame frame = randomFrame(random);
		const probe::Probe world = placed(probe::trihedral(frame, probe::WindowSize{1.0, 1.0}));
		ASSERT_EQ(world.sheets.size(), 3u);
		expectNear(world.sheets[0].normal, frame.xAxis(), 1e-15);
		expectNear(world.sheets[1].normal, frame.up, 1e-15);
		expectNear(world.sheets[2].normal, frame.normal, 1e-15);
		expectNear(world.sheets[0].up, frame.up, 1e-15);
		expectNear(world.sheets[1].up, frame.xAxis(), 1e-15);
		expectNear(world.sheets[2].up, frame.up, 1e-15);
		for (const probe::Sheet& sheet : world.sheets)
		{
			EXPECT_EQ(sheet.origin, frame.origin);
			EXPECT_EQ(sheet.window, probe::centeredWindow(1.0, 1.0));
		}
	}
}

TEST(Presets, VanesTouchAlongTheUpAxis)
{
	std::mt19937 random(33);
	for (const int vanes : {1, 2, 3, 4, 5, 6})
	{
		const probe::Frame frame = randomFrame(random);
		const probe::Probe world = placed(probe::paddlewheel(frame, kBounds, vanes));
		ASSERT_EQ(world.sheets.size(), static_cast<std::size_t>(vanes));
		expectNear(world.sheets[0], frame, 1e-14);
		for (int k = 0; k < vanes; ++k)
		{
			const probe::Sheet& vane = world.sheets[k];
			expectNear(vane.up, frame.up, 1e-14);
			EXPECT_EQ(vane.origin, frame.origin);
			const double angle = 2.0 * std::numbers::pi * k / vanes;
			expectNear(vane.xAxis(), std::cos(angle) * frame.xAxis() - std::sin(angle) * frame.normal, 1e-14);
		}
	}
	// Four vanes lie in the planes of the axes, exactly.
	const probe::Probe cross = probe::paddlewheel({}, kBounds, 4);
	EXPECT_EQ(cross.sheets[1].normal, Vec3(1.0, 0.0, 0.0));
	EXPECT_EQ(cross.sheets[3].normal, Vec3(-1.0, 0.0, 0.0));
}

TEST(Presets, VanesReachFromTheAxisOutward)
{
	const double r = 0.5 * std::sqrt(68.0);
	const probe::Probe wide = probe::paddlewheel({}, kBounds);
	ASSERT_EQ(wide.sheets.size(), 3u);
	EXPECT_EQ(wide.sheets[1].window, (probe::Window{0.0, 2.0 * r, -r, r}));
	const probe::Probe sized = probe::paddlewheel({}, kBounds, 2, probe::WindowSize{5.0, 3.0});
	EXPECT_EQ(sized.sheets[1].window, (probe::Window{0.0, 5.0, -1.5, 1.5}));
}

// R is half the diagonal: about the center of the bounds nothing is out of a vane's reach, however it stands.
TEST(Presets, VanesCoverTheBoundsAboutTheirCenter)
{
	std::mt19937 random(34);
	for (int i = 0; i < 100; ++i)
	{
		probe::Frame frame = randomFrame(random);
		frame.origin = kBounds.center();
		const probe::Sheet vane = placed(probe::paddlewheel(frame, kBounds)).sheets[0];
		for (const Vec3& corner : corners(kBounds))
		{
			// The corner, swung about the axis into the vane's plane.
			const Vec3 arm = toFrame(frame).point(corner);
			const Vec3 swung = fromFrame(frame).point({std::hypot(arm.x, arm.z), arm.y, 0.0});
			const glm::dvec2 uv = worldToWindow(vane, swung);
			EXPECT_TRUE(uv.x >= 0.0 && uv.x <= 1.0 && uv.y >= -1e-12 && uv.y <= 1.0 + 1e-12) << uv.x << " " << uv.y;
		}
	}
}

TEST(Presets, StackHasItsOffsetsAlongTheNormal)
{
	std::mt19937 random(35);
	const probe::Frame frame = randomFrame(random);
	const std::vector<double> offsets{-1.5, 0.0, 4.0};
	const probe::Probe world = placed(probe::stack(frame, offsets, probe::WindowSize{2.0, 2.0}));
	ASSERT_EQ(world.sheets.size(), 3u);
	for (std::size_t k = 0; k < 3; ++k)
	{
		expectNear(world.sheets[k].origin, frame.origin + offsets[k] * frame.normal, 1e-14);
		expectNear(world.sheets[k].normal, frame.normal, 1e-15);
		EXPECT_EQ(world.sheets[k].window, probe::centeredWindow(2.0, 2.0));
	}
}

TEST(Presets, EvenOffsetsAreTheMiddlesOfEqualSlabs)
{
	probe::Frame frame;
	frame.origin = {0.0, 0.0, 3.0}; // z of the bounds: 2 to 8
	EXPECT_EQ(probe::evenOffsets(frame, kBounds, 3), (std::vector<double>{0.0, 2.0, 4.0}));
	EXPECT_EQ(probe::evenOffsets(frame, kBounds, 1), (std::vector<double>{2.0}));
	EXPECT_EQ(probe::evenOffsets(frame, kBounds).size(), 5u);

	std::mt19937 random(36);
	for (int i = 0; i < 50; ++i)
	{
		frame = randomFrame(random);
		const std::vector<double> offsets = probe::evenOffsets(frame, kBounds, 4);
		double lo = INFINITY, hi = -INFINITY;
		for (const Vec3& corner : corners(kBounds))
		{
			lo = std::min(lo, glm::dot(corner - frame.origin, frame.normal));
			hi = std::max(hi, glm::dot(corner - frame.origin, frame.normal));
		}
		for (int k = 0; k < 4; ++k)
			EXPECT_NEAR(offsets[k], lo + (k + 0.5) / 4.0 * (hi - lo), 1e-13);
	}
}

} // namespace vp::test
