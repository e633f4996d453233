#include "options/option_values.h"

namespace vp::app
{

void addContourOptions(CLI::App& command, SpecOptions& options)
{
	view::ContourSpec& contour = options.spec.look.contour;
	const char* group = "Contours";
	command
	    .add_option("--contour", contour.values,
	                "Grows the surfaces where the array, of points, has these values from the sheets, within their "
	                "windows and the depth before and behind them")
	    ->type_name("VALUE...")
	    ->group(group);
	addNumbers(command, "--contour-at", 2, contour.at, pairOf<std::pair<double, double>>,
	           "The same of the value that the first sheet has at a place: 0 to 1 across its window, or, without "
	           "one, across its cut")
	    ->type_name("U V")
	    ->group(group);
	command
	    .add_option(
	        "--contour-depth", contour.depth,
	        "How far contours reach along the normal, half to each side (default, or 0: the smaller side of the "
	        "window; without one half the smaller side of the cut)")
	    ->type_name("D")
	    ->group(group);
	command.add_option("--contour-opacity", contour.opacity, "Of contours, 0 to 1")
	    ->type_name("A")
	    ->capture_default_str()
	    ->group(group);
}

} // namespace vp::app
