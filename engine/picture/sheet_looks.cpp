#include "picture/sheet_looks.h"

#include "base/digits.h"
#include "picture/facing.h"
#include "probe/presets.h"
#include "render/color/color_map_file.h"
#include "render/color/label_colors.h"
#include "render/color/opacity_points.h"
#include "session/categories.h"
#include "session/scan_values.h"
#include "session/time_steps.h"
#include "session/value_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace vp::picture
{

namespace
{

constexpr double kRounding = 1e-6; // rounding error of single precision after a few operations

double largest(const Vec3& v)
{
	return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

Vec3 withoutSmall(Vec3 v, double least)
{
	for (int axis = 0; axis < 3; ++axis)
		if (!(std::abs(v[axis]) >= least))
			v[axis] = 0.0;
	return v;
}

render::ValueScale generationScale(const cut::Cut& slice)
{
	std::size_t generations = 2; // a scale has two ends
	for (const cut::SheetCut& sheet : slice.sheets)
		for (const find::BlockCut& cut : sheet.cuts)
			if (!cut.hasSpans())
				generations = std::max(generations, cut.cells().generations());
	const auto last = static_cast<double>(generations - 1);
	return {.title = "generation", .hi = last, .per_cell = true, .log_lo = 1.0, .reach = std::pair{0.0, last}};
}

} // namespace

std::string caption(const probe::Sheet& sheet, const Box& bounds)
{
	const double size = bounds.empty() ? largest(sheet.origin) : largest(bounds.hi - bounds.lo);
	const Vec3 origin = withoutSmall(sheet.origin, kRounding * size);
	const Vec3 normal = withoutSmall(sheet.normal, 0.5e-3); // no negative zero
	const auto number = [&](double place) { return fmt::format("{:.{}g}", place, digitsFor(place, 1e-2 * size, 4)); };
	return fmt::format("origin {}, {}, {}   normal {:.3f}, {:.3f}, {:.3f}", number(origin.x), number(origin.y),
	                   number(origin.z), normal.x, normal.y, normal.z);
}

std::string withTime(const session::Session& session, const std::string& caption)
{
	const std::string time = session::timeText(session);
	return time.empty() ? caption : fmt::format("{}   {}", time, caption);
}

std::vector<grid::FieldChoice> shownFields(const session::Session& session)
{
	std::vector<grid::FieldChoice> fields;
	const auto add = [&](const std::optional<grid::FieldChoice>& field)
	{
		if (field && std::ranges::find(fields, *field) == fields.end())
			fields.push_back(*field);
	};
	add(session.view().field);
	for (const std::optional<grid::FieldChoice>& field : session.view().sheet_fields)
		add(field);
	return fields;
}

bool hasNan(const session::SheetStats& sheet)
{
	constexpr double kRoundedUp = 1.0 + 1e-9;
	return sheet.measure.nan_area > kRoundedUp * sheet.area_left_out;
}

SheetLooks::SheetLooks(const session::Session& session, view::ResolvedLook choice)
    : session_(session), choice_(std::move(choice))
{
	takeFromFile();
}

void SheetLooks::setChoice(view::ResolvedLook choice)
{
	const bool same_scales = choice.look.logarithmic == choice_.look.logarithmic &&
	                         choice.spec.units == choice_.spec.units && choice.spec.range_of == choice_.spec.range_of &&
	                         choice.spec.symmetric == choice_.spec.symmetric &&
	                         choice.spec.legend_title == choice_.spec.legend_title;
	choice_ = std::move(choice);
	takeFromFile();
	if (!same_scales)
		forgetScales();
}

void SheetLooks::forgetScales()
{
	scales_.clear();
	takeFromFile();
}

bool SheetLooks::usesScanWindow() const
{
	return choice_.spec.range_of == view::RangeOf::automatic && !choice_.look.logarithmic && !choice_.spec.symmetric;
}

namespace
{

// Puts the names of labels behind their values.
render::ColorMap withNames(render::ColorMap map, const std::vector<std::pair<double, std::string>>& names)
{
	for (render::Category& category : map.categories)
		if (const auto named = std::ranges::find(names, category.value, &std::pair<double, std::string>::first);
		    named != names.end())
			category.name += " " + named->second;
	return map;
}

} // namespace

// The colors of an array where the settings name none. Categories have no values in between, and so no range.
render::ColorMap SheetLooks::colorsByFile(const std::optional<grid::FieldChoice>& field) const
{
	const view::LookSpec& spec = choice_.spec;
	const bool wants_values = spec.range || spec.logarithmic || spec.symmetric || spec.lines > 0 || spec.bands > 0 ||
	                          !spec.opacity_points.empty();
	if (!wants_values && grid::isCategorical(session_.blocks(), field))
		for (const session::CategoryArray& array : session_.categories())
			if (array.name == field->name && array.association == field->association && !array.values.empty())
				return withNames(render::labelColors(array.values), session::labelNames(session_.blocks(), *field));
	return render::withOpacity(
	    *render::makeColorMap(session::beginsGray(session_.blocks(), field) ? "grey" : "viridis"),
	    render::opacityPoints(spec.opacity_points));
}

// Takes what the settings leave to the file: units and the patient's sides where all of it agrees, and the colors of a
// scan.
void SheetLooks::takeFromFile()
{
	if (choice_.spec.colormap.empty() && !choice_.byGeneration())
		choice_.look.colors = colorsByFile(session_.view().field);
	if (const auto patient = orientationOf(session_.blocks()).patient)
		for (int axis = 0; axis < 3; ++axis)
		{
			Vec3 direction(0.0);
			direction[axis] = 1.0;
			choice_.look.axis_names[static_cast<std::size_t>(axis)] = grid::sideOf(*patient, direction);
		}
	std::string& units = choice_.look.length_units;
	const auto& blocks = session_.blocks().blocks;
	if (units.empty() && !blocks.empty() &&
	    std::ranges::all_of(blocks, [&](const auto& b) { return b.length_units == blocks[0].length_units; }))
		units = blocks[0].length_units;
}

// Those of the settings go before the file's.
std::string SheetLooks::unitsOf(const std::optional<grid::FieldChoice>& field) const
{
	if (field == session_.view().field && !choice_.spec.units.empty())
		return choice_.spec.units;
	if (field && !field->name.ends_with(']'))
		for (const grid::Field* of_block : field->inEach(session_.blocks()))
			if (of_block && !of_block->units.empty())
				return of_block->units;
	return {};
}

Status SheetLooks::seeTimesIfAsked()
{
	const std::size_t times = session_.blocks().times.size();
	if (times_seen_ || choice_.spec.range_of != view::RangeOf::times || times < 2)
		return Nothing{};
	std::vector<std::size_t> steps(times);
	std::iota(steps.begin(), steps.end(), std::size_t(0));
	auto seen = session::lookAtTimes(session_, steps, shownFields(session_));
	if (!seen)
		return seen.error();
	times_seen_ = std::make_shared<session::TimesSeen>(std::move(*seen));
	return Nothing{};
}

// The ends are those of all times that were seen. Values beyond them have the legend's pointed ends.
void SheetLooks::reachOverTimes(const grid::FieldChoice& field, render::ValueScale& scale)
{
	const session::TimesSeen::Array* seen = times_seen_ ? times_seen_->of(field) : nullptr;
	if (!seen || seen->span.empty())
		return;
	const bool is_scan_window = usesScanWindow() && scale.reach && std::pair(scale.lo, scale.hi) != *scale.reach;
	if (is_scan_window)
	{
		auto known = std::ranges::find(windows_, field, [](const auto& window) { return window.first; });
		if (known == windows_.end())
			known = windows_.insert(windows_.end(), {field, {scale.lo, scale.hi}});
		std::tie(scale.lo, scale.hi) = known->second;
		return;
	}
	const auto [lo, hi] = seen->span.range();
	scale.lo = lo;
	scale.hi = hi;
	if (seen->least_positive > 0.0)
		scale.log_lo = lo > 0.0 ? seen->least_positive : std::max(seen->least_positive, scale.log_lo);
	scale.empty = false;
}

// Worked out once: an array may be large, and what it lacks is told once.
Result<std::optional<render::ValueScale>> SheetLooks::scaleOf(const std::optional<grid::FieldChoice>& field,
                                                              bool has_nan)
{
	auto known = std::ranges::find(scales_, field, [](const auto& scale) { return scale.first; });
	if (known == scales_.end())
	{
		auto scale = session::valueScale(session_, field, choice_.look, usesScanWindow());
		if (!scale)
			return scale;
		if (*scale)
			reachOverTimes(*field, **scale);
		if (*scale && field == session_.view().field && choice_.spec.legend_title)
			(*scale)->title = *choice_.spec.legend_title;
		else if (const std::string units = unitsOf(field); *scale && !units.empty())
			(*scale)->title += fmt::format(" [{}]", units);
		known = scales_.insert(scales_.end(), {field, *scale});
	}
	std::optional<render::ValueScale> scale = known->second;
	if (scale)
		scale->has_nan = has_nan || (!scale->per_cell && (scale->below || scale->above)); // between finite and infinite
	return scale;
}

void SheetLooks::chooseEnds(const std::optional<grid::FieldChoice>& field, render::ValueScale& scale,
                            std::span<const session::SheetStats* const> sheets) const
{
	grid::ValueSpan shown;
	for (const session::SheetStats* sheet : sheets)
		for (const std::optional<double>& end : {sheet->measure.min, sheet->measure.max})
			if (end)
				shown.include(*end);
	const view::RangeOf asked = choice_.spec.range_of;
	const bool is_over_shown =
	    asked == view::RangeOf::slice || (asked == view::RangeOf::automatic && session_.colorsOverShown(field));
	if (is_over_shown && !shown.empty()) // where nothing is shown the array's ends serve
	{
		std::tie(scale.lo, scale.hi) = shown.range();
		if (scale.lo > 0.0)
			scale.log_lo = scale.lo;
	}
	if (choice_.spec.symmetric)
	{
		scale.hi = std::max(std::abs(scale.lo), std::abs(scale.hi));
		scale.lo = -scale.hi;
	}
}

Result<std::optional<render::ValueScale>> SheetLooks::scaleOf(const cut::Cut& slice,
                                                              std::span<const session::SheetStats> sheets, bool has_nan)
{
	if (choice_.byGeneration())
	{
		render::ValueScale scale = generationScale(slice);
		scale.title = choice_.spec.legend_title.value_or(scale.title);
		return std::optional(std::move(scale));
	}
	auto scale = scaleOf(session_.view().field, has_nan);
	if (!scale || !*scale)
		return scale;
	std::vector<const session::SheetStats*> of_array;
	for (std::size_t s = 0; s < sheets.size(); ++s)
		if (slice.sheets[s].field == session_.view().field)
			of_array.push_back(&sheets[s]);
	chooseEnds(session_.view().field, **scale, of_array);
	return scale;
}

Result<render::SheetDrawing> SheetLooks::drawing(const cut::SheetCut& sheet, const session::SheetStats& stats)
{
	const probe::SheetWishes& wishes = sheet.shown.wishes;
	render::SheetDrawing drawing{sheet.shown, nullptr, wishes.opacity.value_or(choice_.spec.opacity)};
	drawing.magnification = sheet.shown.fx.magnification;
	if (const std::optional<probe::Window>& window = sheet.sheet.window)
		drawing.window = render::WindowRect{window->x0, window->x1, window->y0, window->y1};
	drawing.rim = choice_.window_rims;
	if (drawing.window && probe::reachesAround(*sheet.sheet.window, session_.blocks().bounds()))
		drawing.rim = false;
	if (sheet.field != session_.view().field && !choice_.byGeneration())
	{
		auto scale = scaleOf(sheet.field, hasNan(stats));
		if (!scale)
			return scale.error();
		drawing.values = *scale;
		if (choice_.spec.colormap.empty())
			drawing.colors = colorsByFile(sheet.field);
		const session::SheetStats* const own[] = {&stats};
		if (drawing.values)
			chooseEnds(sheet.field, *drawing.values, own);
	}
	if (wishes.colormap)
	{
		auto known = colors_.find(*wishes.colormap);
		if (known == colors_.end())
		{
			Result<render::ColorMap> colors = render::chooseColorMap(*wishes.colormap);
			if (!colors)
				return Error{ErrorKind::input, fmt::format("a sheet of the probe: {}", colors.error().message)};
			known = colors_.emplace(*wishes.colormap, std::move(*colors)).first;
		}
		drawing.colors = known->second;
	}
	drawing.range = wishes.range;
	drawing.lines = wishes.lines;
	return drawing;
}

} // namespace vp::picture
