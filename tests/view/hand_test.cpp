#include "desktop.h"
#include "handle_pixels.h"

#include <glm/geometric.hpp>

namespace view
{

namespace
{

using vp::Vec3;
using vp::interact::Handle;
using vp::interact::HandleKind;

// The shell's bounds, give or take nothing that a window of this size is affected by.
const vp::Box kBounds{Vec3(-3.0, 0.0, -3.0), Vec3(3.0, 3.0, 3.0)};

// One sheet with a window, seen obliquely, with nothing but the menu and the scene in the window.
class HandOnASheet : public Desktop
{
protected:
	void SetUp() override
	{
		Desktop::SetUp();
		if (IsSkipped() || HasFatalFailure())
			return;
		open({"demo:shell:32", "--origin", "0", "1.5", "0.1", "--normal", "0 0 1", "--up", "0", "1", "0", "--window",
		      "3", "2", "--camera", "8,-6,9,0,1.5,0,0,0,1"});
		act("panels");
		first_ = settle();
		area_ = scene();
	}

	SeenProbe now() { return seenProbe(settle(), kBounds, area_); }
	// A part of the scene without the notices' corner.
	Area middle() const { return {area_.x + 150, area_.y + 60, 700, 400}; }

	static Vec3 originOf(const nlohmann::json& state)
	{
		const nlohmann::json& numbers = state.at("probe").at("origin");
		return {numbers.at(0), numbers.at(1), numbers.at(2)};
	}
	static Vec3 normalOf(const nlohmann::json& state)
	{
		Vec3 normal(0.0);
		std::istringstream(state.at("probe").at("normal").get<std::string>()) >> normal.x >> normal.y >> normal.z;
		return normal;
	}

	nlohmann::json first_;
	Area area_;
};

// A place on the sheet without a handle.
constexpr Vec3 kOnTheSheet{1.2, 1.2, 0.1};

} // namespace

TEST_F(HandOnASheet, MovesItAlongItsNormal)
{
	const vp::render::Picture before = rest(middle());
	const SeenProbe seen = now();
	drag(pixelOf(seen, kOnTheSheet), pixelOf(seen, kOnTheSheet + Vec3(0.0, 0.0, 0.6)));
	const nlohmann::json state = settle();
	const Vec3 origin = originOf(state);
	EXPECT_NEAR(origin.z, 0.7, 0.03);
	EXPECT_NEAR(origin.x, 0.0, 1e-9);
	EXPECT_NEAR(origin.y, 1.5, 1e-9);
	EXPECT_EQ(normalOf(state), Vec3(0.0, 0.0, 1.0));
	EXPECT_TRUE(eventually([&] { return difference(before, Desktop::seen(middle())) > 0.02; }));
	close();
}

TEST_F(HandOnASheet, TurnsItByARing)
{
	const SeenProbe seen = now();
	const glm::ivec2 ring = pixelOf(seen, Handle{HandleKind::turn, 0});
	drag(ring, ring + glm::ivec2(0, 40));
	const nlohmann::json state = settle();
	const Vec3 normal = normalOf(state);
	EXPECT_LT(normal.z, 0.99);
	EXPECT_NEAR(normal.x, 0.0, 1e-9) << "the ring about the x axis leaves x alone";
	EXPECT_NEAR(glm::length(originOf(state) - originOf(first_)), 0.0, 1e-9);
	close();
}

TEST_F(HandOnASheet, SizesItsWindowByACorner)
{
	const SeenProbe seen = now();
	const glm::ivec2 corner = pixelOf(seen, Handle{HandleKind::corner, 0, 0, 2});
	drag(corner, pixelOf(seen, Vec3(1.0, 2.2, 0.1)));
	const nlohmann::json state = settle();
	EXPECT_NE(state["probe"], first_["probe"]);
	EXPECT_EQ(state["look"]["camera"], first_["look"]["camera"]);
	EXPECT_EQ(normalOf(state), normalOf(first_));
	close();
}

TEST_F(HandOnASheet, UndoBringsTheFirstPictureBack)
{
	moveTo({5, 690});
	const vp::render::Picture before = rest(middle());
	const SeenProbe seen = now();
	drag(pixelOf(seen, kOnTheSheet), pixelOf(seen, kOnTheSheet + Vec3(0.0, 0.0, 0.5)));
	press("a");
	press("Right");
	drag({900, 600}, {800, 640}, 3);
	moveTo({5, 690});
	EXPECT_NE(settle(), first_);
	EXPECT_GT(difference(before, rest(middle())), 0.02);
	for (int i = 0; i < 4; ++i)
		press("ctrl+z");
	EXPECT_EQ(settle(), first_);
	EXPECT_TRUE(eventually([&] { return difference(before, Desktop::seen(middle())) == 0.0; }));
	for (int i = 0; i < 4; ++i)
		press("ctrl+y");
	EXPECT_NE(settle(), first_);
	close();
}

TEST_F(HandOnASheet, TheWheelPushesTheSheetAndZoomsBesideIt)
{
	moveTo(pixelOf(now(), kOnTheSheet));
	wheel(3);
	const nlohmann::json pushed = settle();
	EXPECT_GT(originOf(pushed).z, originOf(first_).z);
	EXPECT_EQ(pushed["look"]["camera"], first_["look"]["camera"]);
	moveTo({950, 650});
	wheel(2);
	const nlohmann::json zoomed = settle();
	EXPECT_EQ(zoomed["probe"], pushed["probe"]);
	EXPECT_NE(zoomed["look"]["camera"], first_["look"]["camera"]);
	close();
}

} // namespace view
