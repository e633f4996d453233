#pragma once

#include "viewer/cutting/render_thread.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace vp::app
{

// Keeps the last values of a figure, and a histogram of all values in tenths of a millisecond.
class Figure
{
public:
	static constexpr std::size_t kKept = 240;

	void add(double ms);
	std::size_t count() const { return count_; }
	double last() const { return count_ == 0 ? 0.0 : kept_[(count_ - 1) % kKept]; }
	double mean() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
	double most() const { return most_; }
	double percentile(double part) const; // 0 to 1; to a tenth of a millisecond, at most 2 s
	std::vector<float> history() const;   // oldest first

private:
	static constexpr std::size_t kBins = 20'000;

	std::array<float, kKept> kept_{};
	std::vector<std::uint32_t> bins_ = std::vector<std::uint32_t>(kBins);
	std::size_t count_ = 0;
	double sum_ = 0.0;
	double most_ = 0.0;
};

// Measures how fast the window is. F2 shows these figures, and --stats writes them.
class Meter
{
public:
	// Call this when a frame of the window was presented. awake_since: when the window last began to draw frames one
	// after the other; empty while it rests, and draws one now and then.
	void frame(Moment now, std::optional<Moment> awake_since);
	// Call this with the picture of the frame; a new picture is counted.
	void picture(const std::shared_ptr<const PresentedFrame>& shown, Moment now);
	void forgetPicture() { last_.reset(); } // call this before the picture's device goes

	const Figure& frames() const { return frames_; } // from frame to frame while awake, the first one from waking on
	const Figure& cuts() const { return cuts_; }
	const Figure& draws() const { return draws_; }
	const Figure& answers() const { return answers_; } // from input to the picture that answers it
	double cutsPerSecond() const;                      // the rate in the last seconds in which there were cuts
	nlohmann::json json() const;

private:
	Figure frames_;
	Figure cuts_;
	Figure draws_;
	Figure answers_;
	Figure cut_gaps_; // between pictures of new cuts, while they follow each other
	std::optional<Moment> last_frame_;
	std::optional<Moment> last_cut_;
	std::shared_ptr<const PresentedFrame> last_;
	std::uint64_t last_number_ = 0;
	std::size_t drafts_ = 0; // pictures of a coarser level
};

} // namespace vp::app
