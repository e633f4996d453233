#include "vector_options.h"

#include "render/color/color_map_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>

namespace vp::app
{

namespace
{

const char* const kGroup = "Vectors";

// More would be more than a screen has pixels.
constexpr int kMaxLattice = 1000;

void addDrawnOptions(CLI::App& command, VectorLookOptions& look)
{
	command
	    .add_option("--vector-color", look.color,
	                "What they are coloured by: an array, or one colour: white, black, grey, #RRGGBB (default: the "
	                "vector's length)")
	    ->type_name("[point:|cell:]NAME|COLOUR")
	    ->group(kGroup);
	command
	    .add_option("--vector-colormap", look.colormap,
	                "Their colour map (default: that of the sheets for the array that these show, else turbo, or grey "
	                "beside turbo)")
	    ->type_name("NAME|FILE.json[:PRESET]")
	    ->group(kGroup);
	command
	    .add_option("--vector-width", look.width,
	                "Of a tube or ribbon, a line or a tuft's shaft, in the grid's units (default: a share of the "
	                "lattice's spacing)")
	    ->type_name("W")
	    ->group(kGroup);
	command.add_option("--vector-opacity", look.opacity, "0 to 1")
	    ->check(CLI::Range(0.0, 1.0))
	    ->capture_default_str()
	    ->group(kGroup);
}

} // namespace

void addVectorOptions(CLI::App& command, VectorOptions& options, VectorLookOptions* look)
{
	command
	    .add_option(
	        "--vectors", options.kind,
	        "Launches particles from a lattice of points on each sheet, and shows their paths in the flow: tufts "
	        "(arrows, one step long), lines, ribbons (turned with the flow) or tubes (docs/VECTORS.md)")
	    ->check(CLI::IsMember({"none", "tufts", "lines", "ribbons", "tubes"}))
	    ->capture_default_str()
	    ->group(kGroup);
	command
	    .add_option("--vector-array", options.array,
	                "The array that moves them (default: the first of three components, those of points first)")
	    ->type_name("[point:|cell:]NAME")
	    ->group(kGroup);
	command
	    .add_option("--vector-lattice", options.lattice,
	                "Points along the longer side of a window, or of the cut where there is none")
	    ->check(CLI::Range(1, kMaxLattice))
	    ->type_name("N")
	    ->capture_default_str()
	    ->group(kGroup);
	command
	    .add_option("--vector-jitter", options.jitter,
	                "How far points stray from the lattice: 0 not at all, 1 anywhere in their squares")
	    ->check(CLI::Range(0.0, 1.0))
	    ->type_name("J")
	    ->capture_default_str()
	    ->group(kGroup);
	command
	    .add_option("--vector-steps", options.steps,
	                "How many steps a particle goes; fractions are allowed (default: 1 for tufts, else 200)")
	    ->type_name("X")
	    ->group(kGroup);
	command
	    .add_option("--vector-dt", options.dt,
	                "Time of a step (default: the fastest particle goes as far as the lattice's points are apart; "
	                "--stats tells it)")
	    ->type_name("DT")
	    ->group(kGroup);
	command.add_option("--vector-direction", options.direction, "Whether they go with the flow, against it, or both")
	    ->check(CLI::IsMember({"forward", "backward", "both"}))
	    ->capture_default_str()
	    ->group(kGroup);
	command
	    .add_option("--vector-part", options.part,
	                "What of the vector moves them: the whole, its part in the sheet, or that through it")
	    ->check(CLI::IsMember({"whole", "tangential", "normal"}))
	    ->capture_default_str()
	    ->group(kGroup);
	command
	    .add_flag("--path-lines", options.path_lines,
	              "Particles go while the field changes from one of the input's times to the next, launched at --time; "
	              "without it the field stands still")
	    ->group(kGroup);
	if (look)
		addDrawnOptions(command, *look);
}

Status checkVectorOptions(const VectorOptions& options)
{
	constexpr double kMaxSteps = 1e6;
	// Not a number passes every comparison with the ends of a range.
	if (!(options.jitter >= 0.0 && options.jitter <= 1.0))
		return Error{ErrorKind::usage, fmt::format("--vector-jitter {}: give a number from 0 to 1", options.jitter)};
	if (options.steps && !(*options.steps >= 0.0 && *options.steps <= kMaxSteps))
		return Error{ErrorKind::usage, fmt::format("--vector-steps {}: give a number from 0 to {}; --vector-direction "
		                                           "backward goes against the flow",
		                                           *options.steps, kMaxSteps)};
	if (options.dt && !(*options.dt > 0.0 && std::isfinite(*options.dt)))
		return Error{
		    ErrorKind::usage,
		    fmt::format("--vector-dt {}: a step takes some time; give a number above 0, or leave the option out",
		                *options.dt)};
	return Nothing{};
}

Result<VectorLook> parseVectorLook(const VectorLookOptions& options)
{
	VectorLook look{options.color, {}, options.width, options.opacity};
	if (!options.colormap.empty())
	{
		Result<render::ColorMap> colors = render::chooseColorMap(options.colormap);
		if (!colors)
			return Error{colors.error().kind, fmt::format("--vector-colormap: {}", colors.error().message)};
		look.colors = std::move(*colors);
	}
	if (options.width && !(*options.width > 0.0 && std::isfinite(*options.width)))
		return Error{ErrorKind::usage,
		             fmt::format("--vector-width {}: give a number above 0, or leave the option out", *options.width)};
	if (!std::isfinite(options.opacity))
		return Error{ErrorKind::usage, "--vector-opacity: nan is no opacity; give a number from 0 to 1"};
	return look;
}

} // namespace vp::app
