#pragma once

#include "profile/contender.h"
#include "profile/paired_ratios.h"

#include <cstddef>
#include <string>
#include <vector>

namespace vp::app
{

constexpr int kMinRounds = 10; // fewer say little about how much rounds differ
constexpr int kMaxRounds = 1000;

// Measures settings in turns. In each round, all programs start anew, since where the system puts a program and its
// memory makes it faster or slower by some percent as long as it runs. Then every setting measures each plane twice:
// once on the way through the settings and once on the way back, so that none has the better place. Who starts first,
// and begins, changes from round to round.
class Turns
{
public:
	explicit Turns(std::vector<Contender> contenders) : contenders_(std::move(contenders)) {}

	// Starts all programs. Afterwards the stages are known.
	Status begin();
	// Measures rounds until the frame's interval is narrower than 2 % for all settings, at most so many.
	Status run(int max_rounds);

	const std::vector<Contender>& contenders() const { return contenders_; }
	bool planeByPlane() const { return plane_by_plane_; } // false: each program runs as a whole, again and again
	std::size_t planes() const { return planes_; }
	std::size_t rounds() const { return rounds_; }
	double firstMs(std::size_t contender) const; // the median of the first frames

	// A stage that was measured. Another setting may lack it.
	struct Stage
	{
		std::string name;
		Timeline::Track track;
		std::uint32_t depth;

		std::string title() const { return track == Timeline::Track::gpu ? "gpu " + name : name; }
	};
	const std::vector<Stage>& stages() const { return stages_; }
	const std::vector<std::size_t>& order() const { return order_; } // stages in the order in which they begin

	// Returns the median of all times, and nothing if the setting lacks the stage.
	double medianMs(std::size_t contender, std::size_t stage) const;
	// contender: not the first one.
	const PairedRatios& ratios(std::size_t contender, std::size_t stage) const { return ratios_[contender][stage]; }

private:
	// ms[stage] of one plane, 0 where a stage is missing.
	using Times = std::vector<double>;

	// Returns the contenders in this round's order.
	std::vector<std::size_t> turns() const;
	Status start();
	Status measureFirst();
	Result<Times> measure(std::size_t contender, std::size_t plane);
	Times take(const std::vector<StageTime>& times);
	std::size_t stageOf(const StageTime& time);
	Status round();
	void pair(const std::vector<std::vector<Times>>& there, const std::vector<std::vector<Times>>& back);
	bool isDecided() const;
	std::string progressText(int max_rounds) const;

	std::vector<Contender> contenders_;
	bool plane_by_plane_ = true;
	std::size_t planes_ = 0;
	std::size_t rounds_ = 0;
	std::vector<std::vector<double>> first_ms_; // [contender]: of each start
	std::vector<Stage> stages_;
	std::vector<std::size_t> order_;
	std::vector<std::vector<std::vector<double>>> ms_; // ms_[contender][stage]: every time that was measured
	std::vector<std::vector<PairedRatios>> ratios_;    // ratios_[contender][stage]; none for the first
};

} // namespace vp::app
