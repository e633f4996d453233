#include "options/option_values.h"

namespace vp::app
{

namespace
{

const char* const kVectorGroup = "Vectors";

void addDrawnOptions(CLI::App& command, view::VectorLookSpec& look)
{
	command
	    .add_option("--vector-color", look.color,
	                "Color of the particles: an array, or one color: white, black, grey, #RRGGBB (default: the "
	                "vector's length)")
	    ->type_name("[point:|cell:]NAME|COLOR")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-colormap", look.colormap,
	                "Color map of the particles (default: the sheets' map if they show the same array; otherwise "
	                "turbo, or grey beside turbo)")
	    ->type_name("NAME|FILE.json[:PRESET]")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-width", look.width,
	                "Width of a tube, ribbon, line or tuft's shaft, in the grid's units (default: a share of the "
	                "lattice's spacing)")
	    ->type_name("W")
	    ->group(kVectorGroup);
	command.add_option("--vector-opacity", look.opacity, "Opacity of the particles, 0 to 1")
	    ->capture_default_str()
	    ->group(kVectorGroup);
}

} // namespace

void addVectorOptions(CLI::App& command, SpecOptions& options, LookScope scope)
{
	view::VectorSpec& vectors = options.spec.probe.vectors;
	addWord(command, "--vectors", vectors.kind,
	        "Launch particles from a lattice of points on each sheet, and draw their paths: tufts (arrows of one "
	        "step), lines, ribbons (which turn with the flow) or tubes (docs/VECTORS.md)")
	    ->group(kVectorGroup);
	command
	    .add_option(
	        "--vector-array", vectors.array,
	        "Vector array that moves the particles (default: the first array of three components, point arrays first)")
	    ->type_name("[point:|cell:]NAME")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-lattice", vectors.lattice,
	                fmt::format("Number of launch points along the longer side of a window, or of the cut if there is "
	                            "no window, 1 to {}",
	                            view::kMaxLattice))
	    ->type_name("N")
	    ->capture_default_str()
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-jitter", vectors.jitter,
	                "Random shift of the points from the lattice: 0 is none, 1 is anywhere in their squares")
	    ->type_name("J")
	    ->capture_default_str()
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-steps", vectors.steps,
	                "Number of steps that a particle goes; fractions are allowed (default: 1 for tufts, otherwise 200)")
	    ->type_name("X")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-dt", vectors.dt,
	                "Time of a step (default: the time in which the fastest particle moves by one spacing of the "
	                "lattice; --stats has it)")
	    ->type_name("DT")
	    ->group(kVectorGroup);
	addWord(command, "--vector-direction", vectors.direction, "Particles follow the flow, go against it, or both")
	    ->group(kVectorGroup);
	addWord(command, "--vector-part", vectors.part,
	        "Part of the vector that moves the particles: the whole vector, its part in the sheet, or its part through "
	        "the sheet")
	    ->group(kVectorGroup);
	command
	    .add_flag("--path-lines", vectors.path_lines,
	              "Particles move while the field changes through the input's times, starting at --time. Without this "
	              "option the field stands still")
	    ->group(kVectorGroup);
	if (scope == LookScope::space)
		addDrawnOptions(command, options.spec.look.vectors);
}

} // namespace vp::app
