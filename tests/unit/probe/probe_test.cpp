#include "random_probes.h"

namespace vp::test
{

// The paper: "the world coordinates [of a hot spot] are the bottom row" of (to_probe * to_sheet)^-1.
TEST(Probe, BottomRowOfTheInverseIsTheHotSpot)
{
	std::mt19937 random(21);
	for (int i = 0; i < 100; ++i)
	{
		const probe::Probe probe = randomProbe(random);
		const probe::Probe world = placed(probe);
		for (std::size_t s = 0; s < probe.sheets.size(); ++s)
		{
			const probe::Transform back = inverse(toProbe(probe) * toFrame(probe.sheets[s]));
			expectNear(back.row[3], world.sheets[s].origin, 1e-12);
			expectNear(back.row[2], world.sheets[s].normal, 1e-14);
		}
	}
}

TEST(Probe, WorldToSheetIsTheProductOfFour)
{
	std::mt19937 random(22);
	for (int i = 0; i < 100; ++i)
	{
		const probe::Probe probe = randomProbe(random);
		const probe::Probe world = placed(probe);
		for (std::size_t s = 0; s < probe.sheets.size(); ++s)
		{
			const probe::Sheet& sheet = probe.sheets[s];
			const probe::Transform to_sheet = toFrame(sheet);
			const probe::Transform to_cube = toCube(*sheet.window);
			expectNear(worldToSheet(world.sheets[s]), toProbe(probe) * to_sheet * fxTransform(sheet.fx) * to_cube,
			           1e-9);
			expectNear(sheetToWorld(world.sheets[s]), inverse(toProbe(probe) * to_sheet * to_cube), 1e-9);
		}
	}
}

TEST(Probe, MovesItsSheetsAsOne)
{
	std::mt19937 random(23);
	for (int i = 0; i < 100; ++i)
	{
		probe::Probe probe = randomProbe(random);
		const probe::Probe before = placed(probe);
		probe.frame = randomFrame(random);
		const probe::Probe after = placed(probe);
		for (std::size_t a = 0; a < probe.sheets.size(); ++a)
		{
			EXPECT_EQ(after.sheets[a].window, before.sheets[a].window);
			EXPECT_EQ(after.sheets[a].fx, before.sheets[a].fx);
			for (std::size_t b = 0; b < a; ++b)
			{
				const auto distance = [&](const probe::Probe& p)
				{ return glm::length(p.sheets[a].origin - p.sheets[b].origin); };
				const auto cosine = [&](const probe::Probe& p)
				{ return glm::dot(p.sheets[a].normal, p.sheets[b].normal); };
				const auto twist = [&](const probe::Probe& p) { return glm::dot(p.sheets[a].up, p.sheets[b].up); };
				const auto height = [&](const probe::Probe& p)
				{ return glm::dot(p.sheets[b].origin - p.sheets[a].origin, p.sheets[a].normal); };
				EXPECT_NEAR(distance(after), distance(before), 1e-13);
				EXPECT_NEAR(cosine(after), cosine(before), 1e-14);
				EXPECT_NEAR(twist(after), twist(before), 1e-14);
				EXPECT_NEAR(height(after), height(before), 1e-13);
			}
		}
	}
}

TEST(Probe, InTheWorldsFrameItStaysAsItIs)
{
	std::mt19937 random(24);
	probe::Probe probe = randomProbe(random);
	probe.frame = {};
	EXPECT_EQ(placed(probe), probe);
}

} // namespace vp::test
