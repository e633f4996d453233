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
	        "array, or generation: when the traversal met a polygon's cell (--seeds hotspot shows the front)")
	    ->group(kLookGroup);
	addNumbers(command, "--range", 2, look.range, pairOf<std::pair<double, double>>,
	           "Values at the ends of the color map (default: those of the whole array)")
	    ->type_name("LO HI")
	    ->group(kLookGroup);
	addWord(command, "--range-of", look.range_of,
	        "Whose lowest and highest value are at the ends: data (the whole array) or slice (what the sheets show)")
	    ->group(kLookGroup);
	command.add_flag("--symmetric", look.symmetric, "The ends lie alike about 0, so 0 has the middle color")
	    ->group(kLookGroup);
	command.add_flag("--log", look.logarithmic, "Colors follow the values' logarithm")->group(kLookGroup);
	command.add_option("--lines", look.lines, "About N contour lines, at round values")
	    ->type_name("N")
	    ->group(kLookGroup);
	command.add_flag("--no-legend", look.no_legend, "Leaves the legend out")->group(kLookGroup);
	command.add_flag("--no-labels", look.no_labels, "Contour lines without their values")->group(kLookGroup);
	command.add_option("--bands", look.bands, "Bands of one color, parted at about N round values")
	    ->type_name("N")
	    ->group(kLookGroup);
	command.add_flag("--mesh", look.mesh, "Draws the edges of the cut's polygons")->group(kLookGroup);
}

// Of what has a depth.
void addSpaceOptions(CLI::App& command, SpecOptions& options)
{
	view::LookSpec& look = options.spec.look;
	command.add_option("--samples", look.samples, "Samples per pixel, for smooth edges")
	    ->capture_default_str()
	    ->group(kLookGroup);
	command
	    .add_option("--opacity", look.opacity, "Of every sheet, 0 to 1; a color map with opacities is a factor on it")
	    ->capture_default_str()
	    ->group(kLookGroup);
	command.add_flag("--lit", look.lit, "Sheets are darker the more they are turned from the light")->group(kLookGroup);
	addWord(command, "--axes", look.axes,
	        "corner (where x, y and z point), box (numbers along edges of the bounds) or none")
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
	        "A translucent surface around the sheets; may be given several times. boundary: that of the domain; i, "
	        "j, k: a grid surface; patch: a part of the boundary that the file names")
	    ->allow_extra_args(false)
	    ->type_name(view::contextForms())
	    ->group(kLookGroup);
}

} // namespace

void addLookOptions(CLI::App& command, SpecOptions& options, LookScope scope)
{
	view::LookSpec& look = options.spec.look;
	addText(command, options, "--size", look.size, view::parseSize, "Of the picture in pixels")
	    ->type_name("WxH")
	    ->default_str(view::sizeText(look.size))
	    ->group(kLookGroup);
	addColorOptions(command, options);
	addText(command, options, "--background", look.background, render::parseBackground,
	        "gradient, white, black, grey, transparent, #RGB or #RRGGBB")
	    ->type_name("COLOR")
	    ->default_str(render::backgroundText(look.background))
	    ->group(kLookGroup);
	addText(command, options, "--camera", look.camera, render::parseCamera,
	        "auto (obliquely onto the sheet), x, -x, y, -y, z, -z, iso, sheet, azimuth and elevation in "
	        "degrees, or position, focal point and up as nine numbers")
	    ->type_name("VIEW|AZ,EL|9 NUMBERS")
	    ->default_str(look.camera.text)
	    ->group(kLookGroup);
	addWord(command, "--outline", look.outline,
	        "What orients the sheet: box, edges (the boundary's feature edges) or none")
	    ->group(kLookGroup);
	command
	    .add_option("--units", look.units,
	                "Of the array, told behind its name (default: the file's, where it names them)")
	    ->type_name("TEXT")
	    ->group(kLookGroup);
	command
	    .add_option("--length-units", look.length_units,
	                "Of the grid's coordinates, told on axes (default: the file's, where it names them)")
	    ->type_name("TEXT")
	    ->group(kLookGroup);
	command.add_option("--title", look.title, "Above the picture (default: the input's name; \"\" for none)")
	    ->type_name("TEXT")
	    ->group(kLookGroup);
	if (scope == LookScope::space)
		addSpaceOptions(command, options);
}

} // namespace vp::app
