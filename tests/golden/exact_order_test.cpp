#include "exact_order.h"
#include "tries.h"

namespace vp::render::test
{

TEST_F(ExactOrder, OfRandomProbes)
{
	compareProbes(1, vp::test::tries(8));
}

TEST_F(ExactOrder, SheetsInOnePlaneKeepTheProbesOrder)
{
	const auto constant = [](double value) { return [value](double, double) { return value; }; };
	const Vec3 normal = glm::normalize(Vec3(0.31, -0.2, 0.87));
	const probe::Sheet first = probe::makeSheet({1e-3, 2e-3, -7e-4}, normal);
	// Elsewhere in the plane, turned, its back to the front: their planes' numbers do not agree to the last bit.
	const Vec3 moved = first.origin + 0.37 * first.xAxis() - 0.11 * first.up;
	const probe::Sheet second = probe::makeSheet(moved, -normal, {0.9, 0.1, 0.3});
	for (const bool swapped : {false, true})
	{
		Scene scene = bareScene(120, 90, 1);
		scene.camera.position = {1.7, 1.1, 4.3};
		scene.sheets.push_back(square(first, 0.6, 1.0, constant(0.0)));
		scene.sheets.push_back(square(second, 0.6, 1.0, constant(1.0)));
		if (swapped)
			std::swap(scene.sheets[0], scene.sheets[1]);
		const Picture picture = draw(scene);
		const Rgb front = rgb(scene.look.colors.at(swapped ? 1.0 : 0.0));
		std::size_t both = 0;
		for (std::uint32_t y = 0; y < 90; ++y)
			for (std::uint32_t x = 0; x < 120; ++x)
				if (hit(scene, first, 0.58, x + 0.5, y + 0.5) && hit(scene, second, 0.58, x + 0.5, y + 0.5))
				{
					++both;
					ASSERT_LE(difference(front, picture.pixel(x, y)), 1.0) << x << " " << y;
				}
		EXPECT_GE(both, 300u);
	}
}

} // namespace vp::render::test
