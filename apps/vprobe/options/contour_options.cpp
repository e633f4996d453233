#include "options/option_values.h"

namespace vp::app
{

void addContourOptions(CLI::App& command, SpecOptions& options)
{
	view::ContourSpec& contour = options.spec.look.contour;
	const char* group = "Contours";
	command
	    .add_option("--contour", contour.values,
	                "Draw the surfaces where the point array has these values, as far as they lie within the sheets' "
	                "windows and the depth in front of and behind them")
	    ->type_name("VALUE...")
	    ->group(group);
	addNumbers(command, "--contour-at", 2, contour.at, pairOf<std::pair<double, double>>,
	           "Draw the surface of the value that the first sheet has at this place: 0 to 1 across its window, or "
	           "across its cut if it has no window")
	    ->type_name("U V")
	    ->group(group);
	command
	    .add_option("--contour-depth", contour.depth,
	                "How far contours reach along the normal, half to each side (default, or 0: the smaller side of "
	                "the window, or half the smaller side of the cut if there is no window)")
	    ->type_name("D")
	    ->group(group);
	command.add_option("--contour-opacity", contour.opacity, "Opacity of the contours, 0 to 1")
	    ->type_name("A")
	    ->capture_default_str()
	    ->group(group);
}

} // namespace vp::app
