#pragma once

#include "base/result.h"
#include "viewer/document/document.h"
#include "viewer/screen/gpu_screen.h"
#include "viewer/screen/gpu_window.h"

#include <cstdio>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace vp::app
{

// Carries out the lines of --commands, which docs/VIEWER.md explains. A thread of its own reads the lines, and the
// window's thread carries them out, one after the other. If a line fails, an error is printed on standard error, and
// the next line follows.
class Script
{
public:
	// A FIFO is read until the window closes; "-" is standard input. Returns an error if the file cannot be read.
	static Result<std::shared_ptr<std::FILE>> open(const std::string& file);

	// wake: called on the reading thread when a line has come.
	Script(std::shared_ptr<std::FILE> file, std::function<void()> wake);
	~Script();
	Script(const Script&) = delete;
	Script& operator=(const Script&) = delete;

	struct Stage
	{
		Document& document;
		Window& window;
		Screen& screen;
		bool shows_newest;    // the window shows the document's picture
		std::uint64_t frames; // frames of the window so far
	};
	// Carries out the lines that have come, up to one that has to wait. Returns true if anything was done or has to
	// wait.
	bool run(const Stage& stage);
	// Returns true if the script needs a frame of the window, even if nothing moves.
	bool wantsFrame() const { return captures_; }
	// Prints the errors since the last call.
	void tellErrors(const Document& document);

private:
	using Words = std::vector<std::string>;
	struct Waiting
	{
		std::function<bool(const Stage&)> done;
		std::optional<Moment> until; // after this time it has failed
		std::string failure;
	};

	void read();
	void take(std::string_view bytes, std::string& line);
	std::optional<std::string> next();
	bool isWaiting(const Stage& stage);

	void waitForPicture(const Stage& stage);
	Status carryOut(const std::string& line, const Stage& stage);
	Status act(const Words& words, const Stage& stage);
	Status saveState(const std::string& file, const Stage& stage) const;
	Status capture(const std::string& file, const Stage& stage);
	Status savePicture(const Words& words, const Stage& stage);
	Status resize(const Words& words, const Stage& stage);
	void waitFor(std::function<bool(const Stage&)> done, std::string failure);

	std::shared_ptr<std::FILE> file_;
	int ends_; // an eventfd, written to when the reading is to end
	std::function<void()> wake_;

	// Only the window's thread uses these.
	std::optional<Waiting> waiting_;
	bool captures_ = false;
	Moment told_;

	std::mutex mutex_;
	std::deque<std::string> lines_;
	std::thread thread_; // must be the last member
};

} // namespace vp::app
