#include "synthetic_scene.h"

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace vp::render::test
{

// Layers that are as they should be are not drawn again, and the picture is that of a renderer that never drew
// anything.
class Unchanged : public DrawingTest
{
protected:
	Scene threeSheets()
	{
		Scene scene = bareScene(160, 120, 1);
		scene.values = ValueScale{"f", -1.0, 1.0, false};
		for (const Vec3& normal : {Vec3(1, 0, 0.2), Vec3(0, 1, 0.3), Vec3(0, 0, 1)})
			scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, normal), 1.0, 0.7, waves, 40));
		return scene;
	}

	// How many layers are drawn; the pixels are compared.
	std::size_t layersFor(const Scene& scene)
	{
		const Picture picture = draw(scene);
		const std::size_t drawn = renderer().layersDrawn();
		auto fresh = Renderer::create(device());
		EXPECT_TRUE(fresh);
		auto expected = fresh->draw(scene);
		EXPECT_TRUE(expected);
		EXPECT_TRUE(picture.rgba == expected->rgba);
		EXPECT_EQ(fresh->layersDrawn(), scene.sheets.size() * static_cast<std::size_t>(scene.look.samples));
		return drawn;
	}
};

TEST_F(Unchanged, LooksNeedNoLayer)
{
	Scene scene = threeSheets();
	EXPECT_EQ(layersFor(scene), 3u);
	EXPECT_EQ(layersFor(scene), 0u);
	scene.look.colors = makeColorMap("turbo").value();
	EXPECT_EQ(layersFor(scene), 0u);
	scene.look.range = {-0.5, 0.4};
	scene.look.lines = 5;
	EXPECT_EQ(layersFor(scene), 0u);
	scene.sheets[1].opacity = 0.2;
	scene.look.lit = true;
	EXPECT_EQ(layersFor(scene), 0u);
	scene.look.background = parseBackground("transparent").value();
	EXPECT_EQ(layersFor(scene), 0u);
}

TEST_F(Unchanged, AMovedSheetIsOneLayer)
{
	Scene scene = threeSheets();
	EXPECT_EQ(layersFor(scene), 3u);
	scene.sheets[1].sheet.origin += Vec3(0.1, 0.0, 0.0);
	EXPECT_EQ(layersFor(scene), 1u);
	scene.sheets[2].window = WindowRect{-0.5, 0.6, -0.4, 0.7};
	EXPECT_EQ(layersFor(scene), 1u);
	scene.sheets[2].window->x0 = -0.3;
	scene.sheets[0].magnification = 1.2;
	EXPECT_EQ(layersFor(scene), 2u);
	scene.sheets[2].window.reset();
	EXPECT_EQ(layersFor(scene), 1u);
	scene.sheets[0] = square(scene.sheets[0].sheet, 0.8, 0.7, waves, 30);
	EXPECT_EQ(layersFor(scene), 1u);
	scene.sheets[0].records = nullptr;
	EXPECT_EQ(layersFor(scene), 1u);
	EXPECT_EQ(layersFor(scene), 0u);
}

// Pipelines of looks that were not seen for long are forgotten, and made again.
TEST_F(Unchanged, ManyLooksLeaveNoTrace)
{
	Scene scene = threeSheets();
	scene.values->lo = 0.1;
	scene.values->log_lo = 0.1;
	std::vector<Scene> looks;
	for (int kind = 0; kind < 16; ++kind)
		for (std::size_t sheets = 1; sheets <= 2; ++sheets)
		{
			Scene& look = looks.emplace_back(scene);
			look.sheets.resize(sheets);
			look.look.lines = kind & 1 ? 5 : 0;
			look.look.bands = kind & 2 ? 4 : 0;
			look.look.mesh = (kind & 4) != 0;
			look.look.logarithmic = (kind & 8) != 0;
		}
	std::vector<std::vector<std::uint8_t>> pictures;
	for (const Scene& look : looks)
		pictures.push_back(draw(look).rgba);
	EXPECT_GT(std::set(pictures.begin(), pictures.end()).size(), looks.size() / 2); // they are different
	for (const std::size_t again : {0, 1, 2, 20, 31})
		EXPECT_TRUE(draw(looks[again]).rgba == pictures[again]) << again;
}

TEST_F(Unchanged, RecordsThatAreGoneAreNotTakenForOthers)
{
	// The pool gives the page of the first records to the second, and their owner may lie where the first lay.
	Scene scene = threeSheets();
	for (int i = 0; i < 4; ++i)
	{
		scene.sheets[0].records = nullptr;
		scene.sheets[0] = square(
		    scene.sheets[0].sheet, 1.0, 0.7, [i](double u, double v) { return waves(u + 0.3 * i, v); }, 40);
		EXPECT_EQ(layersFor(scene), i == 0 ? 3u : 1u);
	}
}

TEST_F(Unchanged, LinesAroundTheSheetsAreTheScenes)
{
	Scene scene = threeSheets();
	std::vector<Segment> outline{{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}};
	scene.outline = outline;
	EXPECT_EQ(layersFor(scene), 3u);
	EXPECT_EQ(layersFor(scene), 0u);
	outline[0].b = {1.0, -1.0, 1.0};
	EXPECT_EQ(layersFor(scene), 0u);
	outline.push_back({{-1.0, 1.0, 1.0}, {1.0, -1.0, -1.0}});
	scene.outline = outline;
	EXPECT_EQ(layersFor(scene), 0u);
	scene.sheets[0].window = WindowRect{-0.5, 0.5, -0.5, 0.5};
	EXPECT_EQ(layersFor(scene), 1u);
	scene.outline = {};
	scene.sheets[0].rim = false;
	EXPECT_EQ(layersFor(scene), 0u);
	scene.outline = outline;
	EXPECT_EQ(layersFor(scene), 0u);
	scene.camera.position += Vec3(0.0, 0.2, 0.0);
	EXPECT_EQ(layersFor(scene), 3u);
}

TEST_F(Unchanged, ViewsNeedAllLayers)
{
	Scene scene = threeSheets();
	EXPECT_EQ(layersFor(scene), 3u);
	scene.camera.position += Vec3(0.3, 0.0, 0.0);
	EXPECT_EQ(layersFor(scene), 3u);
	scene.look.width = 150;
	EXPECT_EQ(layersFor(scene), 3u);
	scene.look.mesh = true;
	EXPECT_EQ(layersFor(scene), 3u);
	EXPECT_EQ(layersFor(scene), 0u);
	scene.look.mesh = false;
	EXPECT_EQ(layersFor(scene), 3u);
}

TEST_F(Unchanged, SamplesAreDrawnOneByOne)
{
	Scene scene = threeSheets();
	scene.look.samples = 4;
	EXPECT_EQ(layersFor(scene), 12u);
	EXPECT_EQ(layersFor(scene), 12u);
	scene.look.samples = 1;
	EXPECT_EQ(layersFor(scene), 3u);
}

TEST_F(Unchanged, SheetsComeAndGo)
{
	Scene scene = threeSheets();
	EXPECT_EQ(layersFor(scene), 3u);
	const std::vector<SheetDrawing> all = scene.sheets;
	scene.sheets.pop_back();
	EXPECT_EQ(layersFor(scene), 0u);
	scene.sheets = all;
	EXPECT_EQ(layersFor(scene), 0u);
	scene.sheets.clear();
	EXPECT_EQ(draw(scene).rgba, std::vector<std::uint8_t>(4 * 160 * 120, 255));
	scene.sheets = all;
	EXPECT_EQ(layersFor(scene), 1u);
}

} // namespace vp::render::test
