#include "look_options.h"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

namespace vp::app
{

Result<render::Look> makeLook(const LookOptions& options)
{
	render::Look look;
	Result<std::pair<std::uint32_t, std::uint32_t>> size = render::parseSize(options.size);
	if (!size)
		return size.error();
	std::tie(look.width, look.height) = *size;
	look.samples = options.samples;
	Result<render::ColorMap> colors = render::makeColorMap(options.colormap);
	if (!colors)
		return colors.error();
	look.colors = *colors;
	if (!options.range.empty())
	{
		if (!(options.range[0] < options.range[1]) || !std::isfinite(options.range[1] - options.range[0]))
			return Error{ExitCode::usage, fmt::format("--range {} {}: the first number must be below the second",
			                                          options.range[0], options.range[1])};
		look.range = {options.range[0], options.range[1]};
	}
	Result<render::Background> background = render::parseBackground(options.background);
	if (!background)
		return background.error();
	look.background = *background;
	Result<render::Outline> outline = render::parseOutline(options.outline);
	if (!outline)
		return outline.error();
	look.outline = *outline;
	return look;
}

void addLookOptions(CLI::App& command, LookOptions& options)
{
	const char* group = "Look";
	command.add_option("--size", options.size, "Of the picture in pixels")
	    ->type_name("WxH")
	    ->capture_default_str()
	    ->group(group);
	command.add_option("--samples", options.samples, "Samples per pixel, for smooth edges")
	    ->check(CLI::Range(1, render::kMaxSamples))
	    ->capture_default_str()
	    ->group(group);
	command.add_option("--colormap", options.colormap, fmt::format("{}", fmt::join(render::colorMapNames(), ", ")))
	    ->type_name("NAME")
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--range", options.range,
	                "Values at the ends of the colour map (default: those of the whole array)")
	    ->expected(2)
	    ->allow_extra_args(false)
	    ->type_name("LO HI")
	    ->group(group);
	command.add_option("--opacity", options.opacity, "Of the sheet, 0 to 1")
	    ->check(CLI::Range(0.0, 1.0))
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--background", options.background, "gradient, white, black, grey, transparent, #RGB or #RRGGBB")
	    ->type_name("COLOUR")
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--camera", options.camera,
	                "auto (obliquely onto the sheet), x, -x, y, -y, z, -z, iso, sheet, azimuth and elevation in "
	                "degrees, or position, focal "
	                "point and up as nine numbers")
	    ->type_name("VIEW|AZ,EL|9 NUMBERS")
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--outline", options.outline,
	                "What orients the sheet: box, edges (the boundary's feature edges) or none")
	    ->capture_default_str()
	    ->group(group);
	command.add_option("--title", options.title, "Above the picture (default: the input's name; \"\" for none)")
	    ->type_name("TEXT")
	    ->group(group);
}

} // namespace vp::app
