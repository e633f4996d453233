#include "profile/turns.h"

#include "base/messages.h"
#include "base/progress.h"
#include "profile/spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vp::app
{

namespace
{

constexpr double kDecidedWidth = 0.02;
constexpr std::size_t kFrame = 0; // every plane begins with this stage
constexpr double kFrameConfidence = 0.95;

// The same remark often comes from every setting; then it is told once.
void tellRemarks(const std::vector<Contender>& contenders)
{
	std::set<std::string> told;
	for (const Contender& contender : contenders)
		for (const std::string& line : contender.remarks())
		{
			const std::string text = line.starts_with("vprobe: ") ? line.substr(line.find(' ') + 1) : line;
			if (told.insert(text).second)
				warn("{}{}{}", contender.option(), contender.kind() == Contender::Kind::first ? "" : ": ", text);
		}
}

} // namespace

std::vector<std::size_t> Turns::turns() const
{
	std::vector<std::size_t> contenders;
	for (std::size_t k = 0; k < contenders_.size(); ++k)
		contenders.push_back((k + rounds_) % contenders_.size());
	return contenders;
}

Status Turns::start()
{
	for (const std::size_t c : turns())
		if (Status started = contenders_[c].start(); !started)
			return started;
	for (const std::size_t c : turns())
	{
		if (Status ready = contenders_[c].waitUntilReady(); !ready)
			return ready;
		plane_by_plane_ = plane_by_plane_ && contenders_[c].answersPlanes();
	}
	planes_ = plane_by_plane_ ? contenders_[0].planes() : 1;
	for (const Contender& contender : contenders_)
		if (plane_by_plane_ && contender.planes() != planes_)
			return Error{ErrorKind::input, fmt::format("{}: measures {} planes in place of {}; name a build that takes "
			                                           "the same --planes",
			                                           contender.option(), contender.planes(), planes_)};
	return Nothing{};
}

// Measures the first frame of each, which builds what is built once. The plane in the middle, mostly the largest, makes
// them take the memory that all others need.
Status Turns::measureFirst()
{
	for (const std::size_t c : turns())
	{
		if (!plane_by_plane_)
		{
			const Result<Contender::Whole> whole = contenders_[c].runWhole();
			if (!whole)
				return whole.error();
			first_ms_[c].push_back(whole->first_ms);
			take(whole->medians);
			continue;
		}
		const Result<Times> first = measure(c, 0);
		if (!first)
			return first.error();
		first_ms_[c].push_back((*first)[kFrame]);
		if (const Result<Times> middle = measure(c, planes_ / 2); !middle)
			return middle.error();
	}
	return Nothing{};
}

Status Turns::begin()
{
	const Progress progress("starting the programs");
	ms_.resize(contenders_.size());
	ratios_.resize(contenders_.size());
	first_ms_.resize(contenders_.size());
	if (Status started = start(); !started)
		return started;
	tellRemarks(contenders_);
	return measureFirst();
}

std::size_t Turns::stageOf(const StageTime& time)
{
	const auto known = std::ranges::find_if(stages_, [&](const Stage& stage)
	                                        { return stage.track == time.track && stage.name == time.name; });
	if (known != stages_.end())
		return static_cast<std::size_t>(known - stages_.begin());
	stages_.push_back({time.name, time.track, time.depth});
	return stages_.size() - 1;
}

Turns::Times Turns::take(const std::vector<StageTime>& times)
{
	Times ms(stages_.size(), 0.0);
	auto place = order_.begin(); // behind the stage before
	for (const StageTime& time : times)
	{
		const std::size_t stage = stageOf(time);
		ms.resize(stages_.size(), 0.0);
		ms[stage] = time.ms;
		const auto known = std::ranges::find(order_, stage);
		place = 1 + (known != order_.end() ? known : order_.insert(place, stage));
	}
	return ms;
}

Result<Turns::Times> Turns::measure(std::size_t contender, std::size_t plane)
{
	if (plane_by_plane_)
	{
		const auto times = contenders_[contender].measure(plane);
		return times ? Result<Times>(take(*times)) : times.error();
	}
	const auto whole = contenders_[contender].runWhole();
	return whole ? Result<Times>(take(whole->medians)) : whole.error();
}

Status Turns::round()
{
	if (rounds_ > 0 && plane_by_plane_)
	{
		if (Status started = start(); !started)
			return started;
		if (Status measured = measureFirst(); !measured)
			return measured;
	}
	std::vector<std::size_t> order = turns();
	// [plane][contender]
	std::vector<std::vector<Times>> there(planes_, std::vector<Times>(contenders_.size()));
	std::vector<std::vector<Times>> back = there;
	for (auto* way : {&there, &back})
	{
		for (std::size_t plane = 0; plane < planes_; ++plane)
			for (const std::size_t c : order)
			{
				Result<Times> times = measure(c, plane);
				if (!times)
					return times.error();
				(*way)[plane][c] = std::move(*times);
			}
		std::ranges::reverse(order);
	}
	pair(there, back);
	++rounds_;
	return Nothing{};
}

// A pair holds the geometric mean of two times of each of two settings, so that the order of the two cancels.
void Turns::pair(const std::vector<std::vector<Times>>& there, const std::vector<std::vector<Times>>& back)
{
	for (std::size_t c = 0; c < contenders_.size(); ++c)
	{
		ms_[c].resize(stages_.size());
		ratios_[c].resize(stages_.size());
	}
	const auto meanOf = [&](std::size_t plane, std::size_t c, std::size_t stage)
	{
		const Times& a = there[plane][c];
		const Times& b = back[plane][c];
		return stage < a.size() && stage < b.size() ? std::sqrt(a[stage] * b[stage]) : 0.0;
	};
	for (std::size_t plane = 0; plane < planes_; ++plane)
		for (std::size_t stage = 0; stage < stages_.size(); ++stage)
		{
			const double first = meanOf(plane, 0, stage);
			for (std::size_t c = 0; c < contenders_.size(); ++c)
			{
				const double ms = meanOf(plane, c, stage);
				if (ms > 0.0)
					ms_[c][stage].push_back(ms);
				if (c > 0 && ms > 0.0 && first > 0.0)
					ratios_[c][stage].add(rounds_, first, ms);
			}
		}
}

bool Turns::isDecided() const
{
	for (std::size_t c = 1; c < contenders_.size(); ++c)
	{
		const Interval interval = ratios_[c][kFrame].estimate().interval(kFrameConfidence);
		if (!(interval.high - interval.low < kDecidedWidth))
			return false;
	}
	return true;
}

std::string Turns::progressText(int max_rounds) const
{
	std::string text = fmt::format("round {} of at most {}", rounds_ + 1, max_rounds);
	if (rounds_ >= 2)
		for (std::size_t c = 1; c < contenders_.size(); ++c)
			text += fmt::format("{} {:.3f}", c == 1 ? ": frame" : ",", ratios_[c][kFrame].estimate().ratio());
	return text;
}

Status Turns::run(int max_rounds)
{
	// Looking after every round would stop at the first one whose interval happens to be narrow.
	constexpr std::size_t kLookEvery = 5;
	Progress progress(progressText(max_rounds));
	while (rounds_ < static_cast<std::size_t>(max_rounds))
	{
		progress.say(progressText(max_rounds));
		if (Status measured = round(); !measured)
			return measured;
		if (rounds_ >= kMinRounds && rounds_ % kLookEvery == 0 && isDecided())
			break;
	}
	return Nothing{};
}

double Turns::firstMs(std::size_t contender) const
{
	return medianOf(first_ms_[contender]);
}

double Turns::medianMs(std::size_t contender, std::size_t stage) const
{
	return medianOf(ms_[contender][stage]);
}

} // namespace vp::app
