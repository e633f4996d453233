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
	                "What they are colored by: an array, or one color: white, black, grey, #RRGGBB (default: the "
	                "vector's length)")
	    ->type_name("[point:|cell:]NAME|COLOR")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-colormap", look.colormap,
	                "Their color map (default: that of the sheets for the array that these show, else turbo, or grey "
	                "beside turbo)")
	    ->type_name("NAME|FILE.json[:PRESET]")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-width", look.width,
	                "Of a tube or ribbon, a line or a tuft's shaft, in the grid's units (default: a share of the "
	                "lattice's spacing)")
	    ->type_name("W")
	    ->group(kVectorGroup);
	command.add_option("--vector-opacity", look.opacity, "0 to 1")->capture_default_str()->group(kVectorGroup);
}

} // namespace

void addVectorOptions(CLI::App& command, SpecOptions& options, LookScope scope)
{
	view::VectorSpec& vectors = options.spec.probe.vectors;
	addWord(command, "--vectors", vectors.kind,
	        "Launches particles from a lattice of points on each sheet, and shows their paths in the flow: tufts "
	        "(arrows, one step long), lines, ribbons (turned with the flow) or tubes (docs/VECTORS.md)")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-array", vectors.array,
	                "The array that moves them (default: the first of three components, those of points first)")
	    ->type_name("[point:|cell:]NAME")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-lattice", vectors.lattice,
	                fmt::format("Points along the longer side of a window, or of the cut where there is none, 1 to {}",
	                            view::kMaxLattice))
	    ->type_name("N")
	    ->capture_default_str()
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-jitter", vectors.jitter,
	                "How far points stray from the lattice: 0 not at all, 1 anywhere in their squares")
	    ->type_name("J")
	    ->capture_default_str()
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-steps", vectors.steps,
	                "How many steps a particle goes; fractions are allowed (default: 1 for tufts, else 200)")
	    ->type_name("X")
	    ->group(kVectorGroup);
	command
	    .add_option("--vector-dt", vectors.dt,
	                "Time of a step (default: the fastest particle goes as far as the lattice's points are apart; "
	                "--stats tells it)")
	    ->type_name("DT")
	    ->group(kVectorGroup);
	addWord(command, "--vector-direction", vectors.direction, "Whether they go with the flow, against it, or both")
	    ->group(kVectorGroup);
	addWord(command, "--vector-part", vectors.part,
	        "What of the vector moves them: the whole, its part in the sheet, or that through it")
	    ->group(kVectorGroup);
	command
	    .add_flag("--path-lines", vectors.path_lines,
	              "Particles go while the field changes from one of the input's times to the next, launched at --time; "
	              "without it the field stands still")
	    ->group(kVectorGroup);
	if (scope == LookScope::space)
		addDrawnOptions(command, options.spec.look.vectors);
}

} // namespace vp::app
