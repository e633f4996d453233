#include "desktop.h"

#include "write/png.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace view
{

namespace
{

// No frames, no keys but that of closing, nothing that the mouse does.
constexpr const char* kManagerSettings = R"(<?xml version="1.0"?>
<openbox_config xmlns="http://openbox.org/3.4/rc">
  <focus><focusNew>yes</focusNew></focus>
  <keyboard><keybind key="A-F4"><action name="Close"/></keybind></keyboard>
  <mouse><context name="Client"><mousebind button="Left" action="Press"><action name="Focus"/></mousebind></context></mouse>
  <applications>
    <application class="*"><decor>no</decor><focus>yes</focus>
      <position force="yes"><x>0</x><y>0</y></position></application>
  </applications>
</openbox_config>
)";

// Returns the driver file of lavapipe, which is used if no other device is chosen.
std::string lavapipe()
{
	for (const auto& entry : std::filesystem::directory_iterator("/usr/share/vulkan/icd.d"))
		if (entry.path().filename().string().starts_with("lvp_icd"))
			return entry.path();
	return {};
}

// The line that Xvfb writes when it is ready.
std::string readLine(int descriptor)
{
	std::string line;
	pollfd source{descriptor, POLLIN, 0};
	char byte = 0;
	while (poll(&source, 1, static_cast<int>(1000.0 * kPatience)) > 0 && read(descriptor, &byte, 1) == 1 &&
	       byte != '\n')
		line += byte;
	return line;
}

} // namespace

void Desktop::SetUp()
{
	for (const char* needed : {"Xvfb", "xdotool", "openbox"})
		if (!isInstalled(needed))
			GTEST_SKIP() << needed << " is not installed";
	if (!std::getenv("VK_DRIVER_FILES") && lavapipe().empty())
		GTEST_SKIP() << "lavapipe is not installed";
	startScreen();
	startManager();
}

void Desktop::TearDown()
{
	if (HasFailure() && program_ && program_->runs())
		keepFailure();
	program_.reset();
	manager_.reset();
	screen_.reset();
}

void Desktop::startScreen()
{
	std::filesystem::create_directory(path("screen"));
	std::array<int, 2> ready{};
	ASSERT_EQ(pipe2(ready.data(), O_CLOEXEC), 0);
	const std::string size = std::to_string(kScreenWidth) + "x" + std::to_string(kScreenHeight) + "x24";
	screen_ = std::make_unique<Process>(std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ready[1]),
	                                                             "-screen", "0", size, "-fbdir", path("screen"),
	                                                             "-nolisten", "tcp", "-noreset"},
	                                    Process::Setting{.err = path("screen.err"), .kept = ready[1]});
	::close(ready[1]);
	display_ = readLine(ready[0]).insert(0, 1, ':');
	::close(ready[0]);
	ASSERT_NE(display_, ":") << cli::contents(path("screen.err"));
}

// A window that is opened while the manager starts may wait for ever to be told that it is seen (GLFW 3.3).
void Desktop::startManager()
{
	write("openbox.xml", kManagerSettings);
	for (const char* folder : {"home", "config", "state"})
		std::filesystem::create_directory(path(folder));
	// Somebody who knows the window: hints would lie over the picture.
	std::filesystem::create_directory(path("config/volume-probes"));
	write("config/volume-probes/view.json", R"({"hints": false})");
	manager_ = std::make_unique<Process>(std::vector<std::string>{"openbox", "--config-file", path("openbox.xml")},
	                                     Process::Setting{.environment = surroundings()});
	const auto answers = [this]
	{
		Process question({"xdotool", "get_num_desktops"}, {.environment = surroundings()});
		return question.waitFor(kPatience) == 0;
	};
	ASSERT_TRUE(eventually(answers)) << "openbox does not manage windows";
}

std::map<std::string, std::string> Desktop::surroundings() const
{
	std::map<std::string, std::string> all{{"DISPLAY", display_},
	                                       {"HOME", path("home")},
	                                       {"XDG_CONFIG_HOME", path("config")},
	                                       {"XDG_STATE_HOME", path("state")},
	                                       {"XDG_RUNTIME_DIR", path("home")},
	                                       {"MESA_SHADER_CACHE_DIR", VPROBE_VIEW_OUTPUT "/shaders"},
	                                       {"LC_ALL", "C.UTF-8"}};
	all["VPROBE_VALIDATION"] = validates_ && !std::getenv("VPROBE_LAYER_FAULT") ? "1" : "0";
	if (!std::getenv("VK_DRIVER_FILES"))
		all["VK_DRIVER_FILES"] = all["VK_ICD_FILENAMES"] = lavapipe();
	return all;
}

void Desktop::open(const cli::Arguments& arguments)
{
	ASSERT_EQ(mkfifo(path("commands").c_str(), 0600), 0);
	std::vector<std::string> line{VPROBE_PROGRAM, "view"};
	line.insert(line.end(), arguments.begin(), arguments.end());
	line.insert(line.end(), {"--commands", path("commands"), "--stats", path("stats.json")});
	if (std::ranges::find(arguments, "--size") == arguments.end())
		line.insert(line.end(), {"--size", std::to_string(kWidth) + "x" + std::to_string(kHeight)});
	program_ = std::make_unique<Process>(
	    line, Process::Setting{.environment = surroundings(), .out = path("out"), .err = path("err")});
	const auto found = [this]
	{
		Process search({"xdotool", "search", "--name", "^Volume Probes"},
		               {.environment = surroundings(), .out = path("window")});
		search.waitFor(kPatience);
		window_ = cli::contents(path("window"));
		return !window_.empty() || !program_->runs();
	};
	ASSERT_TRUE(eventually(found)) << err();
	ASSERT_TRUE(program_->runs()) << err();
	window_.erase(window_.find('\n'));
	settle();
}

void Desktop::command(const std::string& line) const
{
	// Without a reader there is nobody to wait for.
	const int fifo = ::open(path("commands").c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
	if (fifo < 0)
		throw std::runtime_error("the program does not listen; it said: " + err());
	const std::string bytes = line + "\n";
	EXPECT_EQ(::write(fifo, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
	::close(fifo);
}

nlohmann::json Desktop::settle()
{
	command("wait");
	return state();
}

nlohmann::json Desktop::state()
{
	const std::string file = path("state_" + std::to_string(states_++) + ".json");
	command("save-state " + file);
	eventually([&] { return std::filesystem::exists(file) || !program_->runs(); });
	if (!std::filesystem::exists(file))
		throw std::runtime_error("the window does not answer; it said: " + err());
	return nlohmann::json::parse(cli::contents(file));
}

std::string Desktop::err() const
{
	return cli::contents(path("err"));
}

void Desktop::keepFailure() const
{
	std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
	std::ranges::replace(name, '/', '_');
	keepPicture("failed_" + name);
}

nlohmann::json Desktop::close(const std::string& spoken)
{
	if (HasFailure())
		keepFailure();
	command("quit");
	const std::optional<int> status = program_->waitFor(kPatience);
	EXPECT_EQ(status, 0) << err();
	EXPECT_EQ(err(), spoken);
	nlohmann::json stats = nlohmann::json::parse(cli::contents(path("stats.json")));
	EXPECT_EQ(stats.value("validation_messages", -1), 0) << stats.dump(1);
	return stats;
}

void Desktop::xdotool(const std::string& script) const
{
	const std::string file = write("script", script);
	Process hand({"xdotool", "-"}, {.environment = surroundings(), .in = file, .err = path("script.err")});
	EXPECT_EQ(hand.waitFor(kPatience), 0) << cli::contents(path("script.err"));
}

void Desktop::moveTo(const glm::ivec2& at) const
{
	xdotool("mousemove " + std::to_string(at.x) + " " + std::to_string(at.y) + "\n");
}

void Desktop::drag(const glm::ivec2& from, const glm::ivec2& to, int button) const
{
	constexpr int kSteps = 20;
	const std::string number = std::to_string(button);
	const auto move = [](const glm::ivec2& at)
	{ return "mousemove " + std::to_string(at.x) + " " + std::to_string(at.y) + "\n"; };
	std::string script = move(from) + "mousedown " + number + "\n";
	for (int step = 1; step <= kSteps; ++step)
		script += move(from + (to - from) * step / kSteps);
	xdotool(script + "mouseup " + number + "\n");
}

void Desktop::wheel(int notches) const
{
	xdotool("click --repeat " + std::to_string(std::abs(notches)) + " " + (notches > 0 ? "4" : "5") + "\n");
}

void Desktop::press(const std::string& keys) const
{
	xdotool("key " + keys + "\n");
}

void Desktop::searchFor(const std::string& text)
{
	const Area field{310, 70, 390, 60};
	const vp::render::Picture before = rest(field);
	press("ctrl+k");
	if (!eventually([&] { return difference(before, seen(field)) > 0.3; }))
		throw std::runtime_error("the search for commands does not open");
	rest(field);
	xdotool("type --delay 60 '" + text + "'\n");
	settle();
}

vp::render::Picture Desktop::rest(const Area& area) const
{
	constexpr double kQuiet = 0.3; // the window shows what it has at least this often
	vp::render::Picture last = seen(area);
	auto since = std::chrono::steady_clock::now();
	eventually(
	    [&]
	    {
		    vp::render::Picture now = seen(area);
		    const auto moment = std::chrono::steady_clock::now();
		    if (difference(last, now) > 0.0)
		    {
			    last = std::move(now);
			    since = moment;
		    }
		    return std::chrono::duration<double>(moment - since).count() > kQuiet;
	    });
	return last;
}

// The menu bar has one color at its right end.
Area Desktop::scene() const
{
	const vp::render::Picture picture = screen();
	constexpr std::uint32_t kBelowItsRim = 3;
	std::uint32_t top = kBelowItsRim;
	while (top < kHeight && picture.pixel(kWidth - 8, top) == picture.pixel(kWidth - 8, kBelowItsRim))
		++top;
	return {0, top, kWidth, kHeight - top};
}

void Desktop::keepPicture(const std::string& name) const
{
	const vp::Status written = vp::write::writePng(screen(), std::string(VPROBE_VIEW_OUTPUT "/") + name + ".png");
	EXPECT_TRUE(written) << (written ? std::string() : written.error().message);
}

void Desktop::keepWindow(const std::string& name) const
{
	const std::string file = VPROBE_VIEW_OUTPUT "/" + name + ".png";
	std::filesystem::remove(file);
	command("screenshot " + file);
	EXPECT_TRUE(eventually([&] { return std::filesystem::exists(file); })) << file;
}

} // namespace view
