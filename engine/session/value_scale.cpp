#include "session/value_scale.h"

#include "base/messages.h"
#include "grid/least_positive.h"
#include "session/scan_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace vp::session
{

namespace
{

// Share of the highest value at which a logarithmic scale begins if the data reach 0.
constexpr double kLogReach = 1e-6;

std::string inputName(const Session& session)
{
	const auto& files = session.spec().input.files;
	return files.empty() ? "the input" : files.front();
}

} // namespace

grid::ValueSpan spanOf(const grid::BlockSet& blocks, const ranks::Ranks& ranks, const grid::FieldChoice& field)
{
	grid::ValueSpan span;
	for (const grid::Field* of_block : field.inEach(blocks))
		if (of_block)
			span.include(grid::valueSpan(*of_block, field.component));
	return ranks.sum(span, [](grid::ValueSpan& sum, const grid::ValueSpan& other) { sum.include(other); });
}

grid::ValueSpan spanOf(const Session& session, const grid::FieldChoice& field)
{
	return spanOf(session.blocks(), session.ranks(), field);
}

double leastPositive(const grid::BlockSet& blocks, const ranks::Ranks& ranks, const grid::FieldChoice& field)
{
	double all = 0.0;
	const auto include = [](double& least, double other)
	{
		if (other > 0.0 && !(least > 0.0 && least < other))
			least = other;
	};
	for (const grid::Field* of_block : field.inEach(blocks))
		if (of_block)
			include(all, grid::leastPositive(*of_block, field.component));
	return ranks.sum(all, include);
}

Result<std::optional<render::ValueScale>> valueScale(const Session& session,
                                                     const std::optional<grid::FieldChoice>& field,
                                                     const render::Look& look, bool scan_window)
{
	const grid::BlockSet& blocks = session.blocks();
	const char* needed = look.logarithmic ? "`log`" : look.lines > 0 ? "`lines`" : look.bands > 0 ? "`bands`" : nullptr;
	if (!field)
	{
		if (needed)
			return Error{ErrorKind::input, fmt::format("{}: has no array for {} to show; leave the setting out",
			                                           inputName(session), needed)};
		return std::optional<render::ValueScale>();
	}
	const bool looks_at_all = session.spec().look.range_of == view::RangeOf::slice || !session.colorsOverShown(field);
	const grid::ValueSpan span = looks_at_all ? spanOf(session, *field) : grid::ValueSpan();
	const auto [lo, hi] = span.range();
	render::ValueScale scale{field->title(blocks), lo, hi};
	scale.per_cell = field->association == grid::Association::cell || grid::isCategorical(blocks, field);
	scale.below = span.minus_infinity;
	scale.above = span.plus_infinity;
	scale.empty = span.empty();
	// Between their nodes, the values of curved cells may lie beyond those of the nodes.
	if (!looks_at_all)
	{
		scale.empty = false;
		if (!session.spec().look.range)
		{
			scale.title += ", of the parts shown";
			note("`range`: '{}' stays in its file, so its colors reach over the values that are shown; `range_of` data "
			     "reads all of it first",
			     field->name);
		}
	}
	else if (std::ranges::none_of(blocks.blocks, [](const grid::Block& block) { return block.curved != nullptr; }))
		scale.reach = {lo, hi};
	if (const auto window = scan_window ? windowOfScan(session, *field, span) : std::nullopt)
		std::tie(scale.lo, scale.hi) = *window;
	if (!look.logarithmic)
		return std::optional(scale);
	scale.log_lo = leastPositive(blocks, session.ranks(), *field);
	if (!(scale.log_lo > 0.0))
		return Error{ErrorKind::input, fmt::format("`log`: '{}' has no value above 0 and so no logarithm; leave the "
		                                           "setting out or show another `array`",
		                                           field->name)};
	if (lo > 0.0)
		return std::optional(scale);
	// Rounding around 0 would stretch the scale over decades that hold nothing.
	scale.log_lo = std::max(scale.log_lo, kLogReach * hi);
	warn("`log`: '{}' has values of 0 or below, which have no logarithm; they and all below {:.4g} get the color below "
	     "the range",
	     field->name, look.range ? look.range->first : scale.log_lo);
	return std::optional(scale);
}

} // namespace vp::session
