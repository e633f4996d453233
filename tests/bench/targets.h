#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <string>

namespace vp::bench
{

// Collects the figures of a run's benchmarks, by their names.
class Figures : public benchmark::ConsoleReporter
{
public:
	void ReportRuns(const std::vector<Run>& runs) override;

	std::optional<double> ms(const std::string& name) const;
	std::optional<double> counter(const std::string& name, const std::string& of) const;

private:
	struct Figure
	{
		double ms;
		std::map<std::string, double> counters;
	};
	std::map<std::string, Figure> figures_; // the fastest of several repetitions
};

// Each aim of the program beside what was measured, as far as its benchmarks were run.
void printTargets(const Figures& figures);

} // namespace vp::bench
