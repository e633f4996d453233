#include "baseline.h"
#include "synthetic_scene.h"

#include "base/timeline.h"
#include "shared/slice_types.h"

#include <cmath>
#include <limits>

namespace vp::render::test
{

namespace
{

std::vector<Segment> boxOutline(double half)
{
	std::vector<Segment> lines;
	for (int i = 0; i < 8; ++i)
		for (const int bit : {1, 2, 4})
			if (!(i & bit))
			{
				const auto corner = [half](int c)
				{ return half * Vec3(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1); };
				lines.push_back({corner(i), corner(i | bit)});
			}
	return lines;
}

std::vector<Vec3> ends(const std::vector<Segment>& lines)
{
	std::vector<Vec3> points;
	for (const Segment& s : lines)
	{
		points.push_back(s.a);
		points.push_back(s.b);
	}
	return points;
}

} // namespace

class Pictures : public DrawingTest
{
protected:
	// A box, and what a user sees around it by default.
	Scene dressed(const std::vector<Segment>& outline)
	{
		Scene scene;
		scene.look.width = 320;
		scene.look.height = 240;
		scene.look.title = "waves";
		scene.look.caption = "origin (0, 0, 0)   normal (0, 0, 1)";
		scene.values = ValueScale{"s", -1.0, 1.0, false};
		scene.outline = outline;
		return scene;
	}
	void aim(Scene& scene, const char* camera)
	{
		scene.camera = makeCamera(parseCamera(camera).value(), &scene.sheets[0].sheet,
		                          ends({scene.outline.begin(), scene.outline.end()}), pictureFrame(scene));
	}
};

TEST_F(Pictures, OneSheet)
{
	const auto outline = boxOutline(1.0);
	Scene scene = dressed(outline);
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), 1.0, 1.0, waves, 24));
	aim(scene, "auto");
	Timeline timeline;
	auto drawn = renderer().draw(scene, &timeline);
	ASSERT_TRUE(drawn);
	EXPECT_TRUE(looksLike(*drawn, "one_sheet"));
	if (device().timestampBits() > 0)
	{
		for (const char* pass : {"layers", "compose", "overlay", "copy"})
			EXPECT_GT(timeline.total(pass, Timeline::Track::gpu), 0.0) << pass;
	}
}

// The axes in the corner have the letters of the sides that they run to.
TEST_F(Pictures, ThePatientsSides)
{
	const auto outline = boxOutline(1.0);
	Scene scene = dressed(outline);
	scene.look.colors = makeColorMap("grey").value();
	scene.look.axis_names = {"L", "P", "H"};
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), 1.0, 1.0, waves, 24));
	aim(scene, "30,25");
	EXPECT_TRUE(looksLike(draw(scene), "patient_sides"));
}

TEST_F(Pictures, ThreeTranslucentSheetsOnBlack)
{
	const auto outline = boxOutline(1.0);
	Scene scene = dressed(outline);
	scene.look.background = parseBackground("black").value();
	scene.look.colors = makeColorMap("turbo").value();
	for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
		scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, normal), 1.0, 0.75, waves, 24));
	aim(scene, "30,25");
	EXPECT_TRUE(looksLike(draw(scene), "three_sheets"));
}

TEST_F(Pictures, RangeNanAndALongNameOnNothing)
{
	const auto outline = boxOutline(1.0);
	Scene scene = dressed(outline);
	scene.look.background = parseBackground("transparent").value();
	scene.look.colors = makeColorMap("cool-warm").value();
	scene.look.range = {-0.6e-6, 0.6e-6};
	scene.values = ValueScale{"turbulence_dissipation_rate x", -1e-6, 1e-6, true};
	const auto f = [](double u, double v)
	{ return u * u + v * v < 0.1 ? std::numeric_limits<double>::quiet_NaN() : 1e-6 * waves(u, v); };
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}), 1.0, 1.0, f, 24));
	aim(scene, "auto");
	EXPECT_TRUE(looksLike(draw(scene), "range_nan"));
}

TEST_F(Pictures, LinesBandsAndALogarithmBesideNumberedAxes)
{
	const auto outline = boxOutline(1.0);
	Scene scene = dressed(outline);
	scene.look.axes = false;
	scene.look.box_axes = true;
	scene.look.logarithmic = true;
	scene.look.lines = 6;
	scene.look.bands = 6;
	scene.bounds = Box{Vec3(-1.0), Vec3(1.0)};
	scene.values = ValueScale{"decades", 1e-3, 1.0, false, false, 1e-3};
	const auto decades = [](double u, double v) { return std::pow(10.0, 1.5 * waves(u, v) - 1.5); };
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.1, 0.0, 1.0}), 0.99, 1.0, decades, 48));
	aim(scene, "auto");
	EXPECT_TRUE(looksLike(draw(scene), "lines_log"));
}

TEST_F(Pictures, CategoriesAMeshAndAWindow)
{
	const auto outline = boxOutline(1.0);
	Scene scene = dressed(outline);
	scene.look.mesh = true;
	scene.look.lit = true;
	scene.look.colors.categories = {{-1.0, "water", {60, 120, 200}},
	                                {0.0, "sand", {225, 200, 130}},
	                                {1.0, "a word that is far too long", {90, 150, 70}}};
	for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(0, 0, 1)})
		scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, normal), 1.0, 1.0, waves, 16));
	scene.sheets[0].window = WindowRect{-0.6, 0.7, -0.5, 0.8};
	scene.sheets[1].opacity = 0.7;
	aim(scene, "30,25");
	EXPECT_TRUE(looksLike(draw(scene), "categories_mesh"));
}

TEST_F(Pictures, WordsOverTheSceneHaveAGround)
{
	Scene scene = dressed({});
	scene.bounds = Box{Vec3(-1.0), Vec3(1.0)};
	scene.look.background = parseBackground("white").value();
	scene.look.colors = makeColorMap("grey").value();
	const auto black = [](double, double) { return -1.0; };
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), 1.0, 1.0, black));
	scene.camera.position = {0.0, 0.0, 1.2};
	// Beside the title's first letter, and within the legend's column.
	const auto ground = [&](bool fitted)
	{
		scene.fitted = fitted;
		const Picture picture = draw(scene);
		return std::pair{picture.pixel(8, 8)[0], picture.pixel(312, 120)[0]};
	};
	EXPECT_EQ(ground(true), (std::pair<std::uint8_t, std::uint8_t>{0, 0}));
	const auto [title, legend] = ground(false);
	EXPECT_NEAR(title, 204, 3);
	EXPECT_NEAR(legend, 204, 3);
	// Where the scene is elsewhere, there is none.
	scene.sheets.clear();
	scene.camera.position = {0.0, 0.0, 50.0};
	EXPECT_EQ(ground(false), ground(true));
}

TEST_F(Pictures, TheSameSceneGivesTheSamePicture)
{
	const auto outline = boxOutline(1.0);
	Scene scene = dressed(outline);
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.3, 1.0}), 1.0, 0.8, waves, 24));
	aim(scene, "iso");
	const Picture first = draw(scene);
	EXPECT_EQ(first.rgba, draw(scene).rgba);
}

} // namespace vp::render::test
