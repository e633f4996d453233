#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace vp::app
{

// Tells people how many frames are done, and how long the rest takes at the same speed.
class RemainingTime
{
public:
	explicit RemainingTime(std::size_t frames) : frames_(frames) {}

	void done() { ++drawn_; }
	void skip() { ++skipped_; } // counts a frame that took no time
	std::string line() const;   // "frame 3 of 10, 12 s left"

private:
	std::size_t frames_;
	std::size_t drawn_ = 0;
	std::size_t skipped_ = 0;
	std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace vp::app
