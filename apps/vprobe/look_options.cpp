#include "look_options.h"

#include "base/messages.h"
#include "input_title.h"
#include "render/color/color_map_file.h"
#include "render/scene/least_positive.h"
#include "render/scene/levels.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace vp::app
{

namespace
{

// Of the highest value: where a logarithmic scale begins in data that reach 0.
constexpr double kLogReach = 1e-6;

Status setRange(const LookOptions& options, render::Look& look)
{
	if (options.symmetric && options.logarithmic)
		return Error{ErrorKind::usage, "--symmetric: there is no logarithm below 0; leave it out, or --log"};
	if (options.range.empty())
		return Nothing{};
	const double lo = options.range[0];
	const double hi = options.range[1];
	if (!(lo < hi) || !std::isfinite(hi - lo))
		return Error{ErrorKind::usage, fmt::format("--range {} {}: the first number must be below the second", lo, hi)};
	if (options.logarithmic && lo <= 0.0)
		return Error{ErrorKind::usage,
		             fmt::format("--range {} {}: --log needs a range above 0; raise the first number", lo, hi)};
	look.range = {lo, hi};
	return Nothing{};
}

// A map of categories has no values in between.
Status checkCategories(const LookOptions& options, const render::Look& look)
{
	if (look.colors.categories.empty())
		return Nothing{};
	const char* option = options.logarithmic      ? "--log"
	                     : options.lines > 0      ? "--lines"
	                     : options.bands > 0      ? "--bands"
	                     : !options.range.empty() ? "--range"
	                     : options.symmetric      ? "--symmetric"
	                                              : nullptr;
	if (!option)
		return Nothing{};
	return Error{ErrorKind::usage, fmt::format("{}: means nothing to the categories of --colormap {}; leave it out",
	                                           option, options.colormap)};
}

void addColorOptions(CLI::App& command, LookOptions& options, const char* group)
{
	command
	    .add_option("--colormap", options.colormap,
	                fmt::format("{}, or a file of ParaView's presets, with :PRESET where it holds several; NAME_r and "
	                            "FILE.json_r are the reverse",
	                            fmt::join(render::colorMapNames(), ", ")))
	    ->type_name("NAME|FILE.json[:PRESET]")
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--color-by", options.color_by,
	                "array, or generation: when the traversal met a polygon's cell (--seeds hotspot shows the front)")
	    ->check(CLI::IsMember({"array", "generation"}))
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--range", options.range,
	                "Values at the ends of the colour map (default: those of the whole array)")
	    ->expected(2)
	    ->allow_extra_args(false)
	    ->type_name("LO HI")
	    ->group(group);
	command
	    .add_option(
	        "--range-of", options.range_of,
	        "Whose lowest and highest value are at the ends: data (the whole array) or slice (what the sheets show)")
	    ->check(CLI::IsMember({"data", "slice"}))
	    ->capture_default_str()
	    ->group(group);
	command.add_flag("--symmetric", options.symmetric, "The ends lie alike about 0, so 0 has the middle colour")
	    ->group(group);
	command.add_flag("--log", options.logarithmic, "Colours follow the values' logarithm")->group(group);
	command.add_option("--lines", options.lines, "About N contour lines, at round values")
	    ->check(CLI::Range(0, render::kMaxLevels))
	    ->type_name("N")
	    ->group(group);
	command.add_flag("--no-legend", options.no_legend, "Leaves the legend out")->group(group);
	command.add_flag("--no-labels", options.no_labels, "Contour lines without their values")->group(group);
	command.add_option("--bands", options.bands, "Bands of one colour, parted at about N round values")
	    ->check(CLI::Range(0, render::kMaxLevels))
	    ->type_name("N")
	    ->group(group);
	command.add_flag("--mesh", options.mesh, "Draws the edges of the cut's polygons")->group(group);
}

// Of what has a depth.
void addSpaceOptions(CLI::App& command, LookOptions& options, const char* group)
{
	command.add_option("--samples", options.samples, "Samples per pixel, for smooth edges")
	    ->check(CLI::Range(1, render::kMaxSamples))
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--opacity", options.opacity,
	                "Of every sheet, 0 to 1; a colour map with opacities is a factor on it")
	    ->check(CLI::Range(0.0, 1.0))
	    ->capture_default_str()
	    ->group(group);
	command.add_flag("--lit", options.lit, "Sheets are darker the more they are turned from the light")->group(group);
	command
	    .add_option("--axes", options.axes,
	                "corner (where x, y and z point), box (numbers along edges of the bounds) or none")
	    ->check(CLI::IsMember({"corner", "box", "none"}))
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option(
	        "--context", options.context,
	        "A translucent surface around the sheets; may be given several times. boundary: that of the domain; i, "
	        "j, k: a grid surface; patch: a part of the boundary that the file names")
	    ->allow_extra_args(false)
	    ->type_name(contextForms())
	    ->group(group);
}

} // namespace

void addLookOptions(CLI::App& command, LookOptions& options, LookScope scope)
{
	const char* group = "Look";
	command.add_option("--size", options.size, "Of the picture in pixels")
	    ->type_name("WxH")
	    ->capture_default_str()
	    ->group(group);
	addColorOptions(command, options, group);
	command
	    .add_option("--background", options.background, "gradient, white, black, grey, transparent, #RGB or #RRGGBB")
	    ->type_name("COLOUR")
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--camera", options.camera,
	                "auto (obliquely onto the sheet), x, -x, y, -y, z, -z, iso, sheet, azimuth and elevation in "
	                "degrees, or position, focal point and up as nine numbers")
	    ->type_name("VIEW|AZ,EL|9 NUMBERS")
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--outline", options.outline,
	                "What orients the sheet: box, edges (the boundary's feature edges) or none")
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--units", options.units,
	                "Of the array, told behind its name (default: the file's, where it names them)")
	    ->type_name("TEXT")
	    ->group(group);
	command
	    .add_option("--length-units", options.length_units,
	                "Of the grid's coordinates, told on axes (default: the file's, where it names them)")
	    ->type_name("TEXT")
	    ->group(group);
	command.add_option("--title", options.title, "Above the picture (default: the input's name; \"\" for none)")
	    ->type_name("TEXT")
	    ->group(group);
	if (scope == LookScope::space)
		addSpaceOptions(command, options, group);
}

bool needsNeighbors(const LookOptions& options)
{
	return options.color_by == "generation" || options.outline == "edges" || !options.context.empty() ||
	       options.contour.isGiven();
}

Result<LookChoice> parseLook(const LookOptions& options, const std::vector<std::string>& inputs)
{
	LookChoice choice;
	render::Look& look = choice.look;
	auto size = render::parseSize(options.size);
	if (!size)
		return size.error();
	std::tie(look.width, look.height) = *size;
	look.samples = options.samples;
	auto colors = render::chooseColorMap(options.colormap);
	if (!colors)
		return colors.error();
	look.colors = *colors;
	for (Status set : {setRange(options, look), checkCategories(options, look)})
		if (!set)
			return set.error();
	// Not a number passes every comparison with the ends of a range.
	if (!std::isfinite(options.opacity))
		return Error{ErrorKind::usage, "--opacity: nan is no opacity; give a number from 0 to 1"};
	choice.opacity = options.opacity;
	choice.range_of_slice = options.range_of == "slice";
	choice.symmetric = options.symmetric;
	choice.by_generation = options.color_by == "generation";
	look.logarithmic = options.logarithmic;
	look.lines = options.lines;
	look.bands = options.bands;
	look.mesh = options.mesh;
	look.lit = options.lit;
	look.legend = !options.no_legend;
	look.labels = !options.no_labels;
	look.length_units = options.length_units;
	choice.units = options.units;
	auto background = render::parseBackground(options.background);
	if (!background)
		return background.error();
	look.background = *background;
	auto outline = render::parseOutline(options.outline);
	if (!outline)
		return outline.error();
	look.outline = *outline;
	auto context = parseContexts(options.context);
	if (!context)
		return context.error();
	choice.context = std::move(*context);
	choice.contour = options.contour;
	look.axes = options.axes == "corner";
	look.box_axes = options.axes == "box";
	look.title = options.title.value_or(inputTitle(inputs));
	auto camera = render::parseCamera(options.camera);
	if (!camera)
		return camera.error();
	choice.camera = *camera;
	auto vectors = parseVectorLook(options.vectors);
	if (!vectors)
		return vectors.error();
	choice.vectors = std::move(*vectors);
	return choice;
}

Result<std::optional<render::ValueScale>> valueScale(const grid::BlockSet& blocks,
                                                     const std::optional<grid::FieldChoice>& field,
                                                     const std::vector<std::string>& inputs, const render::Look& look)
{
	const char* needed = look.logarithmic ? "--log" : look.lines > 0 ? "--lines" : look.bands > 0 ? "--bands" : nullptr;
	if (!field)
	{
		if (needed)
			return Error{ErrorKind::input,
			             fmt::format("{}: has no array for {} to show; leave the option out", inputs.front(), needed)};
		return std::optional<render::ValueScale>();
	}
	grid::ValueSpan span;
	for (const grid::Field* of_block : field->inEach(blocks))
		if (of_block)
			span.include(grid::valueSpan(*of_block, field->component));
	const auto [lo, hi] = span.range();
	render::ValueScale scale{field->title(blocks), lo, hi};
	scale.per_cell = field->association == grid::Association::cell;
	scale.below = span.minus_infinity;
	scale.above = span.plus_infinity;
	scale.empty = span.empty();
	if (!look.logarithmic)
		return std::optional(scale);
	scale.log_lo = render::leastPositive(blocks, *field);
	if (!(scale.log_lo > 0.0))
		return Error{ErrorKind::input, fmt::format("--log: '{}' has no value above 0 and so no logarithm; leave the "
		                                           "option out or show another --array",
		                                           field->name)};
	if (lo > 0.0)
		return std::optional(scale);
	// Rounding around 0 would stretch the scale over decades that hold nothing.
	scale.log_lo = std::max(scale.log_lo, kLogReach * hi);
	warn(
	    "--log: '{}' has values of 0 or below, which have no logarithm; they and all below {:.4g} get the colour below "
	    "the range",
	    field->name, look.range ? look.range->first : scale.log_lo);
	return std::optional(scale);
}

} // namespace vp::app
