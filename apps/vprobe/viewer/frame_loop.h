#pragma once

#include "interrupt.h"
#include "viewer/document/document.h"
#include "viewer/panels/panels.h"
#include "viewer/pointer/keyboard.h"
#include "viewer/screen/gpu_film_screen.h"
#include "viewer/screen/gpu_screen.h"
#include "viewer/screen/gpu_window.h"
#include "viewer/script.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// Holds what outlives a lost device.
struct Lasting
{
	interact::History<view::ViewSpec> history;
	OpenParts parts;
	std::optional<Script> commands;
	Meter meter;
	std::uint64_t frames = 0; // frames shown so far
	std::string notice;       // the first notice that the user sees
	bool lost_files = false;  // a file that was under way when the window closed was not written
	DeferredInterrupt interrupt;
	WindowTimes times;
};

// Shows frames in the window, on one device, and hands input to the document.
class FrameLoop
{
public:
	FrameLoop(Window& window, Screen& screen, std::shared_ptr<gpu::Device> device, const ReadState& read_state,
	          Lasting& lasting);
	~FrameLoop();
	FrameLoop(const FrameLoop&) = delete;
	FrameLoop& operator=(const FrameLoop&) = delete;

	// Returns an error if the device is lost. The state is then in `lasting`, and in the recovery file.
	Status run();

private:
	void listen();
	void heard();  // notes that input came
	void obey();   // carries out --commands
	bool goesOn(); // false when the window is to close, and nothing is left to write
	void tellUnsaved(const char* why);
	void drawInterface();
	Result<bool> present(const std::vector<Placement>& pictures);
	Status showFrame();
	Status showTimedFrame(bool has_new_picture);
	Status followScale();
	void followKeyboard();
	double secondsToNextFrame() const;
	bool isAwake() const;
	double frameSeconds() const;
	void noteWaking();

	Window& window_;
	Screen& screen_;
	gpu::Device& device_;
	Lasting& lasting_;
	Document document_;
	PointerController hand_{document_};
	Keyboard keyboard_{document_, hand_};
	double frame_seconds_;
	double scale_;
	bool dark_;
	ScenePart scene_;
	Moment frame_begin_ = std::chrono::steady_clock::now(); // begin of the last frame
	Moment last_frame_ = std::chrono::steady_clock::now();  // when the last frame had been presented
	Moment last_event_ = std::chrono::steady_clock::now();
	std::optional<Moment> awake_since_; // empty while nothing moves
	std::shared_ptr<const PresentedFrame> drawn_;
	FilmScreen film_screen_{device_};
};

} // namespace vp::app
