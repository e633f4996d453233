// A device that cannot present to windows draws all the same; the host sends the rows that have changed.
#include "desktop.h"
#include "faulty_device.h"

#include <cstdlib>

namespace view
{

namespace
{

class WindowWithoutPresenting : public Desktop
{
protected:
	WindowWithoutPresenting()
	{
		for (const auto& [name, value] : vp::layer::restrictedDevice("no-windows"))
			setenv(name.c_str(), value.c_str(), 1);
	}
	~WindowWithoutPresenting() override
	{
		for (const auto& [name, value] : vp::layer::restrictedDevice({}))
			unsetenv(name.c_str());
	}
};

} // namespace

TEST_F(WindowWithoutPresenting, ShowsTheSameAndSendsFewRows)
{
	open({"demo:shell:16", "--normal", "0.3", "0.5", "0.8"});
	const Area left{100, 100, 500, 450};
	const vp::render::Picture first = rest(left);
	EXPECT_GT(shareOf(*vp::render::makeColorMap("viridis"), first), 0.1);
	act("push_forward");
	EXPECT_TRUE(eventually([&] { return difference(first, seen(left)) > 0.01; }));
	act("undo");
	EXPECT_TRUE(eventually([&] { return difference(first, seen(left)) < 0.001; }));
	// While nothing changes nothing is sent, and a menu is a small part of the window.
	moveTo({30, 10});
	rest({0, 0, kWidth, kHeight});
	const nlohmann::json stats = close();
	ASSERT_TRUE(stats.contains("rows_sent")) << stats.dump(1);
	const auto frames = stats["window_frame_ms"]["count"].get<std::uint64_t>();
	const auto rows = stats["rows_sent"].get<std::uint64_t>();
	EXPECT_GE(rows, std::uint64_t(kHeight));
	EXPECT_LT(rows, frames * kHeight / 2) << stats.dump(1);
}

} // namespace view
