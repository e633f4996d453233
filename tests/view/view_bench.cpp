// How fast the window follows a hand: figures of --stats, and the time that an onlooker takes, beside their aims.
// Nothing else may run on the machine.
#include "desktop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include <X11/Xlib.h>
#include <fcntl.h>
#include <unistd.h>

namespace view
{

namespace
{

// A part of the screen in which the sheet is and the pointer is not, as bytes.
class Onlooker
{
public:
	explicit Onlooker(const std::string& file) : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
	~Onlooker() { ::close(descriptor_); }
	Onlooker(const Onlooker&) = delete;
	Onlooker& operator=(const Onlooker&) = delete;

	std::string sees() const
	{
		constexpr off_t kFirst = 4 * Screen::kWidth * Screen::kTop;
		std::string bytes(std::size_t(4) * Screen::kWidth * Screen::kRows, '\0');
		const ssize_t count = pread(descriptor_, bytes.data(), bytes.size(), kFirst);
		bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
		return bytes;
	}

private:
	struct Screen
	{
		static constexpr int kWidth = 1400, kTop = 180, kRows = 40;
	};
	int descriptor_;
};

struct Aims
{
	double cuts_per_second;
	double input_to_picture_ms; // 95th percentile
	double frame_ms;            // 99th
};

double milliseconds(std::chrono::steady_clock::duration time)
{
	return std::chrono::duration<double, std::milli>(time).count();
}

double percentile(std::vector<double> values, double part)
{
	if (values.empty())
		return 0.0;
	std::ranges::sort(values);
	return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

void tell(const char* what, double value, double aim, const char* relation)
{
	std::printf("%-44s %8.1f   aim %s %.0f\n", what, value, relation, aim);
}

// By 4 pixels to and fro, an event each 8 ms.
std::string dragScript(const glm::ivec2& from, int events)
{
	std::string script = "mousemove " + std::to_string(from.x) + " " + std::to_string(from.y) + "\nmousedown 1\n";
	constexpr int kWay = 40; // events from end to end
	for (int i = 0; i < events; ++i)
	{
		const int along = std::abs(i % (2 * kWay) - kWay) - kWay / 2;
		script += "mousemove " + std::to_string(from.x) + " " + std::to_string(from.y + 4 * along) + "\nsleep 0.008\n";
	}
	return script + "mouseup 1\n";
}

class ViewBench : public Desktop
{
protected:
	static constexpr glm::ivec2 kOnTheSheet{560, 480};

	// Steps of a hand that holds the sheet, each after the picture of the last has come to rest.
	std::vector<double> latencies(int steps)
	{
		Display* display = XOpenDisplay(displayName().c_str());
		const Onlooker onlooker(path("screen/Xvfb_screen0"));
		std::vector<double> times;
		xdotool("mousemove " + std::to_string(kOnTheSheet.x) + " " + std::to_string(kOnTheSheet.y) + "\nmousedown 1\n");
		for (int i = 0; i < steps; ++i)
		{
			rest({0, 150, 900, 400});
			const std::string before = onlooker.sees();
			const auto start = std::chrono::steady_clock::now();
			XWarpPointer(display, None, DefaultRootWindow(display), 0, 0, 0, 0, kOnTheSheet.x,
			             kOnTheSheet.y + (i % 2 ? 6 : -6));
			XFlush(display);
			auto now = start;
			while (onlooker.sees() == before && milliseconds(now - start) < 2000.0)
				now = std::chrono::steady_clock::now();
			times.push_back(milliseconds(now - start));
		}
		xdotool("mouseup 1\n");
		XCloseDisplay(display);
		return times;
	}

	// Drags what the options open, and tells the figures.
	void measure(std::vector<std::string> options, const Aims& aims)
	{
		validates_ = false; // as users run it
		double load = 0.0;
		getloadavg(&load, 1);
		const char* input = std::getenv("VPROBE_BENCH_INPUT");
		options.insert(options.begin(), input ? input : "demo:shell:256");
		options.insert(options.end(), {"--size", "1280x720"});
		open(options);
		constexpr int kSteps = 30;
		const std::vector<double> seen = latencies(kSteps);
		constexpr int kTenSeconds = 1250;
		xdotool(dragScript(kOnTheSheet, kTenSeconds));
		settle();
		const nlohmann::json stats = close();
		std::printf("load %.1f, %s\n", load, stats["device"].get<std::string>().c_str());
		tell("new cuts a second", stats["new_cuts_per_second"], aims.cuts_per_second, ">=");
		tell("input to picture, p95 [ms]", stats["input_to_picture_ms"]["p95"], aims.input_to_picture_ms, "<=");
		tell("frame of the window, p99 [ms]", stats["window_frame_ms"]["p99"], aims.frame_ms, "<=");
		tell("frame of the window, p95 [ms]", stats["window_frame_ms"]["p95"], 33, "<=");
		tell("frame of the window, slowest [ms]", stats["window_frame_ms"]["max"], 33, "<=");
		tell("seen from outside, from rest, median [ms]", percentile(seen, 0.5), 120, "<=");
		tell("seen from outside, from rest, p95 [ms]", percentile(seen, 0.95), 120, "<=");
		std::printf("cut %.1f ms, drawing %.1f ms (medians), %d cuts\n", stats["cut_ms"]["median"].get<double>(),
		            stats["draw_ms"]["median"].get<double>(), stats["cut_ms"]["count"].get<int>());
		EXPECT_GT(stats["cut_ms"]["count"].get<int>(), kSteps / 2) << "the drag did not move the sheet";
	}
};

} // namespace

TEST_F(ViewBench, DragOfASheet)
{
	measure({"--normal", "0.3", "0.5", "0.8"}, {20, 120, 33});
}

TEST_F(ViewBench, DragOfThreeVanes)
{
	measure({"--probe", "paddlewheel", "--opacity", "0.6"}, {40, 60, 50});
}

} // namespace view
