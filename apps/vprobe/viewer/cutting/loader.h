#pragma once

#include "session/session.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace vp::app
{

// Opens sessions on a thread of its own, one at a time. Used by the window's thread only.
class Loader
{
public:
	// wake: called on the loader's thread when a session is ready or has failed.
	// keep: what the timelines of the sessions keep.
	Loader(std::shared_ptr<gpu::Device> device, std::function<void()> wake, Timeline::Keep keep);
	~Loader(); // cancels

	// Cancels a loading that is under way.
	void begin(view::ViewSpec spec);
	void cancel();
	bool isBusy() const { return job_ != nullptr; }
	double seconds() const; // since the loading began
	std::string what() const;

	struct Loaded
	{
		view::ViewSpec spec; // the settings of the session
		Result<std::unique_ptr<session::Session>> session;
	};
	std::optional<Loaded> take(); // the session, once, when it is ready

private:
	struct Job;

	void drop();

	std::shared_ptr<gpu::Device> device_;
	std::function<void()> wake_;
	Timeline::Keep keep_;
	std::unique_ptr<Job> job_;
	std::vector<std::unique_ptr<Job>> cancelled_; // cancelled, but not finished yet
};

} // namespace vp::app
