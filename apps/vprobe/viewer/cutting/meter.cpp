#include "viewer/cutting/meter.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace vp::app
{

namespace
{

// Two cuts that are further apart than this do not belong to one drag.
constexpr double kPause = 500.0;

double milliseconds(std::chrono::steady_clock::duration time)
{
	return std::chrono::duration<double, std::milli>(time).count();
}

nlohmann::json summary(const Figure& figure)
{
	return {{"count", figure.count()},        {"mean", figure.mean()},          {"median", figure.percentile(0.5)},
	        {"p95", figure.percentile(0.95)}, {"p99", figure.percentile(0.99)}, {"max", figure.most()}};
}

} // namespace

void Figure::add(double ms)
{
	kept_[count_ % kKept] = static_cast<float>(ms);
	++count_;
	sum_ += ms;
	most_ = std::max(most_, ms);
	++bins_[std::min(static_cast<std::size_t>(std::max(0.0, 10.0 * ms)), kBins - 1)];
}

double Figure::percentile(double part) const
{
	const auto wanted = static_cast<std::size_t>(part * static_cast<double>(count_));
	std::size_t below = 0;
	for (std::size_t bin = 0; bin < kBins && count_ > 0; ++bin)
		if (below += bins_[bin]; below > wanted || below == count_)
			return 0.1 * (static_cast<double>(bin) + 0.5);
	return 0.0;
}

std::vector<float> Figure::history() const
{
	std::vector<float> all;
	const std::size_t kept = std::min(count_, kKept);
	for (std::size_t i = 0; i < kept; ++i)
		all.push_back(kept_[(count_ - kept + i) % kKept]);
	return all;
}

void Meter::frame(Moment now, std::optional<Moment> awake_since)
{
	if (last_frame_ && awake_since)
		frames_.add(milliseconds(now - std::max(*last_frame_, *awake_since)));
	last_frame_ = now;
}

void Meter::picture(const std::shared_ptr<const PresentedFrame>& shown, Moment now)
{
	if (!shown || shown == last_)
		return;
	const bool new_cut = !last_ || shown->cuts != last_->cuts;
	last_ = shown;
	draws_.add(shown->draw_ms);
	drafts_ += shown->draft ? 1 : 0;
	if (shown->wish.number != last_number_)
		answers_.add(milliseconds(now - shown->wish.since));
	last_number_ = shown->wish.number;
	if (!new_cut)
		return;
	cuts_.add(shown->cut_ms);
	if (last_cut_ && milliseconds(now - *last_cut_) < kPause)
		cut_gaps_.add(milliseconds(now - *last_cut_));
	last_cut_ = now;
}

double Meter::cutsPerSecond() const
{
	return cut_gaps_.count() == 0 ? 0.0 : 1000.0 / cut_gaps_.mean();
}

nlohmann::json Meter::json() const
{
	return {{"window_frame_ms", summary(frames_)},
	        {"cut_ms", summary(cuts_)},
	        {"draw_ms", summary(draws_)},
	        {"input_to_picture_ms", summary(answers_)},
	        {"new_cuts_per_second", cutsPerSecond()},
	        {"drafts", drafts_}};
}

} // namespace vp::app
