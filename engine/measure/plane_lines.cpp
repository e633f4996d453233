#include "measure/plane_lines.h"

#include <algorithm>
#include <unordered_map>

namespace vp::measure
{

namespace
{

class Chains
{
public:
	explicit Chains(std::vector<PlaneStep> steps)
	    : steps_(std::move(steps)), used_(steps_.size()), passed_(steps_.size(), 0)
	{
		std::ranges::sort(steps_, {}, &PlaneStep::from);
		for (const PlaneStep& step : steps_)
			++ends_at_[step.to];
	}

	std::vector<std::vector<std::uint64_t>> all()
	{
		for (std::size_t i = 0; i < steps_.size(); ++i)
			if (!used_[i] && !ends_at_.contains(steps_[i].from))
				follow(i);
		for (std::size_t i = 0; i < steps_.size(); ++i)
			if (!used_[i])
				follow(i);
		return std::move(lines_);
	}

private:
	void follow(std::size_t step)
	{
		std::vector<std::uint64_t>& line = lines_.emplace_back();
		const std::uint64_t start = steps_[step].from;
		line.push_back(start);
		for (;;)
		{
			used_[step] = true;
			line.push_back(steps_[step].to);
			if (steps_[step].to == start)
				return;
			const auto first = std::ranges::lower_bound(steps_, steps_[step].to, {}, &PlaneStep::from);
			if (first == steps_.end())
				return;
			// Thousands of steps may begin at one place: the used ones are passed once.
			std::size_t next = static_cast<std::size_t>(first - steps_.begin());
			std::uint32_t& passed = passed_[next];
			for (next += passed; next < steps_.size() && steps_[next].from == first->from && used_[next]; ++next)
				++passed;
			if (next == steps_.size() || steps_[next].from != steps_[step].to)
				return;
			step = next;
		}
	}

	std::vector<PlaneStep> steps_;
	std::vector<bool> used_;
	std::vector<std::uint32_t> passed_; // at the first step from a place: how many are known to be used
	std::unordered_map<std::uint64_t, int> ends_at_;
	std::vector<std::vector<std::uint64_t>> lines_;
};

} // namespace

std::vector<std::vector<std::uint64_t>> chained(std::vector<PlaneStep> steps)
{
	return Chains(std::move(steps)).all();
}

std::vector<NetEdge> netEdges(std::vector<NetEdge> edges)
{
	const auto lower = [](const NetEdge& e) { return std::min(e.from, e.to); };
	const auto higher = [](const NetEdge& e) { return std::max(e.from, e.to); };
	std::ranges::sort(edges, {}, [&](const NetEdge& e) { return std::uint64_t(lower(e)) << 32 | higher(e); });
	std::vector<NetEdge> left;
	for (std::size_t first = 0, last = 0; first < edges.size(); first = last)
	{
		int net = 0;
		for (; last < edges.size() && lower(edges[last]) == lower(edges[first]) &&
		       higher(edges[last]) == higher(edges[first]);
		     ++last)
			net += edges[last].from < edges[last].to ? 1 : -1;
		NetEdge edge{lower(edges[first]), higher(edges[first])};
		if (net < 0)
			std::swap(edge.from, edge.to);
		left.insert(left.end(), static_cast<std::size_t>(std::abs(net)), edge);
	}
	return left;
}

std::vector<PlaneLine> linesOf(std::span<const NetEdge> edges, std::span<const glm::dvec2> points)
{
	std::vector<PlaneStep> steps;
	for (const NetEdge& edge : edges)
		steps.push_back({edge.from, edge.to});
	std::vector<PlaneLine> lines;
	for (const std::vector<std::uint64_t>& names : chained(std::move(steps)))
	{
		PlaneLine& line = lines.emplace_back();
		line.closed = names.front() == names.back();
		for (std::size_t i = 0; i + (line.closed ? 1 : 0) < names.size(); ++i)
			line.points.push_back(points[names[i]]);
	}
	return lines;
}

} // namespace vp::measure
