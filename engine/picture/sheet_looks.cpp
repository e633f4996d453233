#include "picture/sheet_looks.h"

#include "base/digits.h"
#include "render/color/color_map_file.h"
#include "session/scan_values.h"
#include "session/value_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
	return {.title = "generation", .hi = static_cast<double>(generations - 1), .per_cell = true, .log_lo = 1.0};
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

bool hasNan(const session::SheetStats& sheet)
{
	return sheet.measure.nan_area > 0.0;
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
	                         choice.spec.symmetric == choice_.spec.symmetric;
	choice_ = std::move(choice);
	takeFromFile();
	if (!same_scales)
		forgetScales();
}

bool SheetLooks::usesScanWindow() const
{
	return choice_.spec.range_of == view::RangeOf::automatic && !choice_.look.logarithmic && !choice_.spec.symmetric;
}

// Takes what the settings leave to the file: units where all of it agrees, and the colors of a scan.
void SheetLooks::takeFromFile()
{
	if (choice_.spec.colormap.empty() && !choice_.byGeneration() &&
	    session::beginsGray(session_.blocks(), session_.view().field))
		choice_.look.colors = *render::makeColorMap("grey");
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
		if (const std::string units = unitsOf(field); *scale && !units.empty())
			(*scale)->title += fmt::format(" [{}]", units);
		known = scales_.insert(scales_.end(), {field, *scale});
	}
	std::optional<render::ValueScale> scale = known->second;
	if (scale)
		scale->has_nan = has_nan || (!scale->per_cell && (scale->below || scale->above)); // between finite and infinite
	return scale;
}

void SheetLooks::chooseEnds(render::ValueScale& scale, std::span<const session::SheetStats* const> sheets) const
{
	grid::ValueSpan shown;
	for (const session::SheetStats* sheet : sheets)
		for (const std::optional<double>& end : {sheet->measure.min, sheet->measure.max})
			if (end)
				shown.include(*end);
	if (choice_.spec.range_of == view::RangeOf::slice &&
	    !shown.empty()) // where nothing is shown the array's ends serve
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
		return std::optional(generationScale(slice));
	auto scale = scaleOf(session_.view().field, has_nan);
	if (!scale || !*scale)
		return scale;
	std::vector<const session::SheetStats*> of_array;
	for (std::size_t s = 0; s < sheets.size(); ++s)
		if (slice.sheets[s].field == session_.view().field)
			of_array.push_back(&sheets[s]);
	chooseEnds(**scale, of_array);
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
	if (sheet.field != session_.view().field && !choice_.byGeneration())
	{
		auto scale = scaleOf(sheet.field, hasNan(stats));
		if (!scale)
			return scale.error();
		drawing.values = *scale;
		const session::SheetStats* const own[] = {&stats};
		if (drawing.values)
			chooseEnds(*drawing.values, own);
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
