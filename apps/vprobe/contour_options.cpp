#include "contour_options.h"

#include "make_probe.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace vp::app
{

void addContourOptions(CLI::App& command, ContourOptions& options)
{
	const char* group = "Contours";
	command
	    .add_option("--contour", options.values,
	                "Grows the surfaces where the array, of points, has these values from the sheets, within their "
	                "windows and the depth before and behind them")
	    ->type_name("VALUE...")
	    ->group(group);
	command
	    .add_option("--contour-at", options.at,
	                "The same of the value that the first sheet has at a place: 0 to 1 across its window, or, without "
	                "one, across its cut")
	    ->expected(2)
	    ->allow_extra_args(false)
	    ->type_name("U V")
	    ->group(group);
	command
	    .add_option(
	        "--contour-depth", options.depth,
	        "How far contours reach along the normal, half to each side (default, or 0: the smaller side of the "
	        "window; without one half the smaller side of the cut)")
	    ->check(CLI::NonNegativeNumber)
	    ->type_name("D")
	    ->group(group);
	command.add_option("--contour-opacity", options.opacity, "Of contours, 0 to 1")
	    ->check(CLI::Range(0.0, 1.0))
	    ->type_name("A")
	    ->capture_default_str()
	    ->group(group);
}

Status checkContours(const ContourOptions& options, const ProbeOptions& probe)
{
	for (const auto& [numbers, name] :
	     {std::pair{&options.values, "--contour"}, std::pair{&options.at, "--contour-at"}})
		if (Status finite = requireFinite(*numbers, name); !finite)
			return finite;
	if (Status finite = requireFinite({&options.depth, 1}, "--contour-depth"); !finite)
		return finite;
	if (options.isGiven() && probe.surface)
		return Error{ErrorKind::usage,
		             fmt::format("{}: grows from planes, and {} is none; leave one of the two out",
		                         options.values.empty() ? "--contour-at" : "--contour",
		                         probe.surface->starts_with("iso:") ? "--iso " + probe.surface->substr(4)
		                                                            : "--surface " + *probe.surface)};
	return Nothing{};
}

} // namespace vp::app
