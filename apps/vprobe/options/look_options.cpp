#include "options/option_values.h"
#include "render/color/color_map.h"
#include "view/context_spec.h"

#include <fmt/ranges.h>

namespace vp::app
{

namespace
{

const char* const kLookGroup = "Look";

void addColorOptions(CLI::App& command, SpecOptions& options)
{
	view::LookSpec& look = options.spec.look;
	command
	    .add_option("--colormap", look.colormap,
	                fmt::format("{}, or a file of ParaView's presets, with :PRESET where it holds several; NAME_r and "
	                            "FILE.json_r are the reverse",
	                            fmt::join(render::colorMapNames(), ", ")))
	    ->type_name("NAME|FILE.json[:PRESET]")
	    ->capture_default_str()
	    ->group(kLookGroup);
	addWord(command, "--color-by", look.color_by,
	        "Color the polygons by the array, or by the generation in which the traversal met their cells (--seeds "
	        "hotspot shows the front)")
	    ->group(kLookGroup);
	addNumbers(command, "--range", 2, look.range, pairOf<std::pair<double, double>>,
	           "Values at the ends of the color map (default: those of the whole array)")
	    ->type_name("LO HI")
	    ->group(kLookGroup);
	addWord(command, "--range-of", look.range_of,
	        "Range of the color map: the values of the whole array (data), or those that the sheets show (slice)")
	    ->group(kLookGroup);
	command.add_flag("--symmetric", look.symmetric, "Make the range symmetric about 0, so that 0 has the middle color")
	    ->group(kLookGroup);
	command.add_flag("--log", look.logarithmic, "Color by the logarithm of the values")->group(kLookGroup);
	command.add_option("--lines", look.lines, "Draw about N contour lines, at round values")
	    ->type_name("N")
	    ->group(kLookGroup);
	command.add_flag("--no-legend", look.no_legend, "Draw no legend")->group(kLookGroup);
	command.add_flag("--no-labels", look.no_labels, "Draw contour lines without their values")->group(kLookGroup);
	command.add_option("--bands", look.bands, "Draw bands of one color each, with about N round values between them")
	    ->type_name("N")
	    ->group(kLookGroup);
	command.add_flag("--mesh", look.mesh, "Draw the edges of the cut's polygons")->group(kLookGroup);
}

// Adds the options that only pictures in space have.
void addSpaceOptions(CLI::App& command, SpecOptions& options)
{
	view::LookSpec& look = options.spec.look;
	command.add_option("--samples", look.samples, "Samples per pixel, for smooth edges")
	    ->capture_default_str()
	    ->group(kLookGroup);
	command
	    .add_option("--opacity", look.opacity,
	                "Opacity of every sheet, 0 to 1. Opacities of the color map are multiplied by it")
	    ->capture_default_str()
	    ->group(kLookGroup);
	command
	    .add_flag("--lit", look.lit, "Shade the sheets: the more a sheet turns away from the light, the darker it is")
	    ->group(kLookGroup);
	addWord(command, "--axes", look.axes,
	        "Axes: corner (arrows in a corner of the picture), box (numbers along the edges of the bounds) or none")
	    ->group(kLookGroup);
	command
	    .add_option_function<std::vector<std::string>>(
	        "--context",
	        [&options](const std::vector<std::string>& words)
	        {
		        options.spec.look.context.clear();
		        for (const std::string& word : words)
			        if (Result<view::ContextSpec> context = view::parseContext(word); context)
				        options.spec.look.context.push_back(std::move(*context));
			        else if (!options.wrong)
				        options.wrong =
				            Error{ErrorKind::usage, fmt::format("`context` {}: {}", word, context.error().message)};
	        },
	        "Draw a translucent surface around the sheets. May be given several times. boundary: the boundary of the "
	        "domain; i, j, k: a grid surface; patch: a part of the boundary that the file names")
	    ->allow_extra_args(false)
	    ->type_name(view::contextForms())
	    ->group(kLookGroup);
}

} // namespace

void addLookOptions(CLI::App& command, SpecOptions& options, LookScope scope)
{
	view::LookSpec& look = options.spec.look;
	addText(command, options, "--size", look.size, view::parseSize, "Size of the picture in pixels")
	    ->type_name("WxH")
	    ->default_str(view::sizeText(look.size))
	    ->group(kLookGroup);
	addColorOptions(command, options);
	addText(command, options, "--background", look.background, render::parseBackground,
	        "Background of the picture: gradient, white, black, grey, transparent, #RGB or #RRGGBB")
	    ->type_name("COLOR")
	    ->default_str(render::backgroundText(look.background))
	    ->group(kLookGroup);
	addText(command, options, "--camera", look.camera, render::parseCamera,
	        "The camera: auto (obliquely onto the sheet), x, -x, y, -y, z, -z, iso, sheet, azimuth and elevation in "
	        "degrees, or nine numbers for position, focal point and up")
	    ->type_name("VIEW|AZ,EL|9 NUMBERS")
	    ->default_str(look.camera.text)
	    ->group(kLookGroup);
	addWord(command, "--outline", look.outline,
	        "Lines around the sheets: the box of the data, the feature edges of its boundary, or none")
	    ->group(kLookGroup);
	command
	    .add_option("--units", look.units,
	                "Units of the array, shown behind its name (default: those that the file names)")
	    ->type_name("TEXT")
	    ->group(kLookGroup);
	command
	    .add_option("--length-units", look.length_units,
	                "Units of the grid's coordinates, shown on the axes (default: those that the file names)")
	    ->type_name("TEXT")
	    ->group(kLookGroup);
	command.add_option("--title", look.title, "Title above the picture (default: the input's name; \"\" for none)")
	    ->type_name("TEXT")
	    ->group(kLookGroup);
	if (scope == LookScope::space)
		addSpaceOptions(command, options);
}

} // namespace vp::app
