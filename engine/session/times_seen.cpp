#include "session/times_seen.h"

#include "base/progress.h"
#include "ranks/data/share.h"
#include "session/met_parts.h"
#include "session/time_steps.h"
#include "session/value_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace vp::session
{

const TimesSeen::Array* TimesSeen::of(const grid::FieldChoice& field) const
{
	const auto found = std::ranges::find(arrays, field, &Array::field);
	return found != arrays.end() ? &*found : nullptr;
}

namespace
{

// The file of a pack says the ranges at all times.
void takeFactsAt(std::size_t step, grid::BlockSet& blocks)
{
	for (grid::Block& block : blocks.blocks)
		if (block.runs)
			for (grid::Field& field : block.fields)
				field.facts = block.runs->factsAt(step, field);
}

} // namespace

Result<TimesSeen> lookAtTimes(const Session& session, std::span<const std::size_t> steps,
                              std::span<const grid::FieldChoice> fields)
{
	TimesSeen seen;
	for (const grid::FieldChoice& field : fields)
		if (!seen.of(field))
			seen.arrays.push_back({field});
	bool differ = false; // the bounds, from those of the session
	std::vector<read::InputToRead> readings;
	for (const std::size_t step : steps)
		for (const std::string& input : session.inputs())
			readings.push_back({input, session.readOptions(choiceOfStep(session.blocks().times, step))});
	const std::size_t inputs = session.inputs().size();
	// Nothing once a grid differs, since some of what was read is left then.
	std::optional<read::ReadAhead> ahead(std::in_place, std::move(readings),
	                                     inputs + (mayReadAhead(session.blocks()) ? 1 : 0));
	Progress progress("looking at times");
	for (std::size_t i = 0; i < steps.size(); ++i)
	{
		progress.say(fmt::format("looking at time {} of {}", i + 1, steps.size()));
		const read::ReadOptions at = session.readOptions(choiceOfStep(session.blocks().times, steps[i]));
		grid::BlockSet blocks = session.blocks();
		ranks::Ranks ranks = session.ranks();
		Result<bool> same_grid = ranks::hasTimeInRuns(ranks, blocks, steps[i]);
		const bool is_in_runs = *same_grid;
		if (is_in_runs)
			takeFactsAt(steps[i], blocks);
		else if (ahead && ranks.keepsParts())
			same_grid = read::readValues(*ahead, inputs, blocks, session.timeline());
		if (!same_grid)
			return same_grid.error();
		if (!*same_grid)
		{
			ahead.reset();
			Result<grid::BlockSet> read = ranks::readInputs(ranks, session.inputs(), at, session.timeline());
			if (!read)
				return read.error();
			blocks = std::move(*read);
		}
		const auto ofAllRanks = [&](const Box& own)
		{ return ranks.sum(own, [](Box& all, const Box& other) { all.include(other); }); };
		const Box bounds = ofAllRanks(blocks.bounds());
		const Box here = ofAllRanks(session.blocks().bounds());
		differ = differ || bounds.lo != here.lo || bounds.hi != here.hi;
		seen.bounds.include(bounds);
		for (TimesSeen::Array& array : seen.arrays)
		{
			array.span.include(spanOf(blocks, ranks, array.field));
			// Logarithms of packs that do not tell it are taken of what was read as a whole.
			if (is_in_runs && ranks.any(!knowsLeastPositive(blocks)))
				continue;
			const double least = leastPositive(blocks, ranks, array.field);
			if (least > 0.0 && !(array.least_positive > 0.0 && array.least_positive < least))
				array.least_positive = least;
		}
	}
	if (!differ)
		seen.bounds = Box();
	return seen;
}

std::vector<std::size_t> firstMiddleAndLast(std::size_t times)
{
	std::vector<std::size_t> steps;
	for (const std::size_t step : {std::size_t(0), times / 2, times - 1})
		if (step < times && std::ranges::find(steps, step) == steps.end())
			steps.push_back(step);
	return steps;
}

} // namespace vp::session
