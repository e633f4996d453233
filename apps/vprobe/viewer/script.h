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

// What --commands says, line by line, as docs/VIEWER.md explains it. Lines are read on a thread of their own and
// carried out, one after the other, on the window's. What fails is told in a line on standard error; the next one
// follows.
class Script
{
public:
	// A FIFO is listened to until the window closes; "-" is standard input. An error where it cannot be read.
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
		std::uint64_t frames; // of the window, shown so far
	};
	// Carries out what has come, up to what has to wait. True where anything was done or is waited for.
	bool run(const Stage& stage);
	// A frame of the window is needed, whether or not anything moves.
	bool wantsFrame() const { return captures_; }
	// Tells what went wrong since the last look.
	void tellErrors(const Document& document);

private:
	using Words = std::vector<std::string>;
	struct Waiting
	{
		std::function<bool(const Stage&)> done;
		std::optional<Moment> until; // then it has failed
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

	// Of the window's thread.
	std::optional<Waiting> waiting_;
	bool captures_ = false;
	Moment told_;

	std::mutex mutex_;
	std::deque<std::string> lines_;
	std::thread thread_; // must be the last member
};

} // namespace vp::app
