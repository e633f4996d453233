#include "time_choice.h"

#include "manifest_writer.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/complaints.h"

#include <vtkAlgorithm.h>
#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace vp::reader::manifest
{

namespace
{

// Returns the nearest of ascending times. It does not compare distances, because far from all times these are equal in
// floating point.
std::size_t nearest(const std::vector<double>& times, double wanted)
{
	const auto above = std::lower_bound(times.begin(), times.end(), wanted);
	const bool is_below = above != times.begin() && (above == times.end() || wanted - above[-1] <= *above - wanted);
	const double time = is_below ? above[-1] : *above;
	return static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
}

} // namespace

std::vector<double> inOrder(std::vector<double> times)
{
	std::erase_if(times, [](double time) { return !std::isfinite(time); });
	std::sort(times.begin(), times.end());
	times.erase(std::unique(times.begin(), times.end()), times.end());
	return times;
}

StepsInTime stepsInTime(const std::vector<double>& times, Writer& manifest)
{
	StepsInTime all{times, std::vector<std::size_t>(times.size())};
	std::iota(all.steps.begin(), all.steps.end(), std::size_t(0));
	const auto missing = std::ranges::count_if(times, [](double time) { return !std::isfinite(time); });
	if (missing > 0)
	{
		manifest.warn(
		    fmt::format("{} of its {} times are missing; its steps are numbered from 0", missing, times.size()));
		std::iota(all.times.begin(), all.times.end(), 0.0);
		return all;
	}
	std::ranges::stable_sort(all.steps, {}, [&](std::size_t step) { return times[step]; });
	std::ranges::sort(all.times);
	return all;
}

std::optional<std::size_t> offerSteps(const std::vector<double>& times, const Request& request, Writer& manifest)
{
	StepsInTime in_order = stepsInTime(times, manifest);
	if (!chooseIfAny(in_order.times, request))
		return std::nullopt;
	const std::size_t step = in_order.steps[chooseStep(in_order.times, request)];
	manifest.offerTimes(std::move(in_order.times));
	return step;
}

std::vector<double> unitedTimes(const std::vector<std::vector<double>>& lists)
{
	std::map<double, std::ptrdiff_t> repeats;
	for (const std::vector<double>& list : lists)
		for (const double time : inOrder(list))
			repeats[time] = std::max(repeats[time], std::ranges::count(list, time));
	std::vector<double> united;
	for (const auto& [time, count] : repeats)
		united.insert(united.end(), static_cast<std::size_t>(count), time);
	return united;
}

std::optional<std::size_t> TimeInList::placeIn(const std::vector<double>& list) const
{
	std::optional<std::size_t> place;
	std::size_t seen = 0;
	for (std::size_t i = 0; i < list.size() && seen <= repeat; ++i)
		if (list[i] == time)
		{
			place = i;
			++seen;
		}
	return place;
}

std::optional<TimeInList> chooseInLists(const std::vector<double>& united, const Request& request)
{
	if (!chooseIfAny(united, request))
		return std::nullopt;
	const std::size_t chosen = chooseStep(united, request);
	const auto first = std::ranges::lower_bound(united, united[chosen]);
	return TimeInList{united[chosen], chosen - static_cast<std::size_t>(first - united.begin())};
}

std::size_t chooseStep(const std::vector<double>& times, const Request& request)
{
	switch (request.time)
	{
	case Request::Time::first:
		return 0;
	case Request::Time::nearest:
		return nearest(times, request.time_value);
	case Request::Time::index:
		if (request.time_index >= times.size())
			throw Refusal(fmt::format("--time #{}: there {} {} time{}, from #0 to #{}", request.time_index,
			                          times.size() == 1 ? "is" : "are", times.size(), times.size() == 1 ? "" : "s",
			                          times.size() - 1));
		return request.time_index;
	default:
		return times.size() - 1;
	}
}

double chooseTime(const std::vector<double>& times, const Request& request)
{
	return times[chooseStep(times, request)];
}

std::optional<double> chooseIfAny(const std::vector<double>& times, const Request& request)
{
	if (!times.empty())
		return chooseTime(times, request);
	if (request.time == Request::Time::index && request.time_index > 0)
		throw Refusal(fmt::format("--time #{}: it has no times", request.time_index));
	return std::nullopt;
}

std::optional<double> updateAtTime(vtkAlgorithm& reader, const Request& request, Writer& manifest)
{
	reader.UpdateInformation();
	checks::refuseOnComplaint();

	std::vector<double> times;
	vtkInformation* about = reader.GetOutputInformation(0);
	const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
	if (about && about->Has(key))
		times.assign(about->Get(key), about->Get(key) + about->Length(key));
	times = inOrder(std::move(times));
	if (times.size() == 1 && times[0] == 0.0 && reader.IsA("vtkSimpleReader"))
		times.clear(); // the legacy readers make up a time 0

	const std::optional<double> chosen = chooseIfAny(times, request);
	if (chosen)
		reader.UpdateTimeStep(*chosen);
	else
		reader.Update();
	checks::refuseOnComplaint();
	if (reader.GetErrorCode() != 0)
		throw damaged("the reader gave up");
	manifest.offerTimes(std::move(times));
	return chosen;
}

} // namespace vp::reader::manifest
