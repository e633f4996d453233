#include "random_probe.h"

#include "classify/gpu_records.h"
#include "render/passes/sheet_regions.h"

#include <algorithm>

namespace vp::render::test
{

namespace
{

constexpr std::uint32_t kPixelsAcross = 643;
constexpr std::uint32_t kPixelsDown = 331;

class Regions : public DrawingTest
{
protected:
	Scene randomScene(unsigned seed, int samples)
	{
		std::mt19937 random(seed);
		Scene scene = bareScene(kPixelsAcross, kPixelsDown, samples);
		for (const KnownSheet& known : randomProbe(random))
		{
			auto records = classify::recordsFromHost(classify::RecordPool::create(device()), known.records);
			EXPECT_TRUE(records);
			scene.sheets.push_back(known.drawing);
			scene.sheets.back().records = *records;
		}
		scene.camera = randomCamera(random);
		return scene;
	}
};

// As if nobody knew where they have polygons.
Scene withoutBounds(Scene scene)
{
	for (SheetDrawing& sheet : scene.sheets)
	{
		auto records = std::make_shared<classify::SheetRecords>(*sheet.records);
		records->bounds.reset();
		sheet.records = std::move(records);
		sheet.window.reset();
	}
	return scene;
}

} // namespace

TEST_F(Regions, HaveEachPixelOnce)
{
	std::size_t shown = 0;
	std::size_t sheets = 0;
	for (unsigned seed = 61; seed <= 70; ++seed)
	{
		const Scene scene = randomScene(seed, 1);
		std::vector<int> times(std::size_t(kPixelsAcross) * kPixelsDown, 0);
		for (const SheetRegion& region : sheetRegions(scene, PicturePart::whole({kPixelsAcross, kPixelsDown})))
		{
			EXPECT_TRUE(std::ranges::is_sorted(region.sheets));
			const VkRect2D& pixels = region.pixels;
			for (std::uint32_t y = 0; y < pixels.extent.height; ++y)
				for (std::uint32_t x = 0; x < pixels.extent.width; ++x)
					++times.at(std::size_t(pixels.offset.y + y) * kPixelsAcross + pixels.offset.x + x);
			shown += region.sheets.size() * pixels.extent.width * pixels.extent.height;
		}
		EXPECT_EQ(std::ranges::count(times, 1), std::ptrdiff_t(times.size()));
		sheets += scene.sheets.size() * times.size();
	}
	EXPECT_LT(shown, sheets);
}

TEST_F(Regions, LeaveNoSheetOut)
{
	for (unsigned seed = 71; seed <= 76; ++seed)
		for (const int samples : {1, 4})
		{
			Scene scene = randomScene(seed, samples);
			for (SheetDrawing& sheet : scene.sheets)
				sheet.window.reset();
			const Picture picture = draw(scene);
			EXPECT_TRUE(draw(withoutBounds(scene)).rgba == picture.rgba);
		}
}

// Sheets that reach behind the camera may be anywhere.
TEST_F(Regions, KnowNothingOfSheetsBehindTheNearPlane)
{
	Scene scene = randomScene(77, 1);
	scene.camera.position *= 0.2;
	for (SheetDrawing& sheet : scene.sheets)
		sheet.window.reset();
	const Picture picture = draw(scene);
	EXPECT_TRUE(draw(withoutBounds(scene)).rgba == picture.rgba);
}

} // namespace vp::render::test
