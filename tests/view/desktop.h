#pragma once

#include "patience.h"
#include "pixels.h"
#include "process.h"
#include "program.h"

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <string>

namespace view
{

// A desktop of the test's own, and vprobe view on it: Xvfb with a window manager that gives windows no frame and puts
// them into the screen's upper left corner, so that the window's pixels are the screen's. Hands and keys are xdotool's.
// What does not fit the program's folder, such as its settings, is in the folder as well. All ends with the test; a
// failed test leaves a picture of the screen in the build folder.
class Desktop : public cli::Program
{
protected:
	void SetUp() override; // skips where a program is missing that a desktop needs
	void TearDown() override;

	// --- vprobe view. Opens it with --commands and --stats on top of the arguments; returns when all is shown.
	void open(const cli::Arguments& arguments);
	void command(const std::string& line) const; // a line of --commands
	void act(const std::string& action) const { command("do " + action); }
	nlohmann::json settle(); // when all is done and shown: the state
	nlohmann::json state();  // as it is now
	std::string err() const; // what it said so far
	Process& program() { return *program_; }
	// Ends it by Ctrl+Q, and holds it to exit code 0 without validation messages: what --stats says. spoken: what it
	// must have said on standard error.
	nlohmann::json close(const std::string& spoken = {});

	// --- The hand; positions are the screen's.
	void xdotool(const std::string& script) const;
	void moveTo(const glm::ivec2& at) const;
	// In steps of a few pixels. button: 1 left, 2 middle, 3 right.
	void drag(const glm::ivec2& from, const glm::ivec2& to, int button = 1) const;
	void wheel(int notches) const;             // > 0: away from the user
	void press(const std::string& keys) const; // as xdotool writes them: "ctrl+s"
	void searchFor(const std::string& text);   // types into the search for commands, once it is there
	std::string window() const { return window_; }
	std::string displayName() const { return display_; }

	// --- The screen.
	vp::render::Picture screen() const { return readScreen(path("screen/Xvfb_screen0")); }
	vp::render::Picture seen(const Area& area) const { return part(screen(), area); }
	vp::render::Picture rest(const Area& area) const; // when it no longer changes
	Area scene() const;                               // the window below the menu, while panels are off
	void keepPicture(const std::string& name) const;  // in the build folder: NAME.png
	void keepWindow(const std::string& name) const;   // the same, of the window alone

	bool validates_ = true; // by the layers of Vulkan, unless faults are made; before open()

	static constexpr int kScreenWidth = 1400;
	static constexpr int kScreenHeight = 900;
	static constexpr int kWidth = 1000; // size of the window, until it gets another size
	static constexpr int kHeight = 700;

private:
	void keepFailure() const;
	void startScreen();
	void startManager();
	std::map<std::string, std::string> surroundings() const;

	std::string display_;
	std::string window_;
	int states_ = 0;
	std::unique_ptr<Process> screen_; // ends last
	std::unique_ptr<Process> manager_;
	std::unique_ptr<Process> program_;
};

} // namespace view
