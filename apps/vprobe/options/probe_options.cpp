#include "grid/field_choice.h"
#include "options/option_values.h"
#include "read/read.h"

namespace vp::app
{

namespace
{

const char* const kProbeGroup = "Probe";

// One of a kind, or the file of one's own.
Status chooseProbe(view::ProbeSpec& probe, const std::string& name)
{
	const Result<view::ProbeShape> shape = view::parse<view::ProbeShape>(name);
	probe.own.reset();
	if (shape)
		probe.shape = *shape;
	else if (!name.ends_with(".json"))
		return Error{ErrorKind::usage,
		             fmt::format("takes {} or a .json file", fmt::join(view::wordsOf<view::ProbeShape>(), ", "))};
	if (shape)
		return Nothing{};
	Result<probe::ProbeFile> file = probe::readProbe(name);
	if (!file)
		return file.error();
	probe.own = std::move(*file);
	probe.shape = view::ProbeShape::own;
	return Nothing{};
}

void addPlaceOptions(CLI::App& command, SpecOptions& options)
{
	view::ProbeSpec& probe = options.spec.probe;
	addNumbers(command, "--origin", 3, probe.origin, vectorOf,
	           "Where the probe stands, its hot spot (default: center of the bounds)")
	    ->type_name("X Y Z")
	    ->group(kProbeGroup);
	addText(command, options, "--normal", probe.normal, view::parseDirection,
	        "The probe's normal: x, y, z or three numbers (default: z)")
	    ->type_name("X Y Z|x|y|z")
	    ->group(kProbeGroup);
	addNumbers(command, "--up", 3, probe.up, vectorOf,
	           "The probe's y axis, made perpendicular to the normal (default: 0 1 0)")
	    ->type_name("X Y Z")
	    ->group(kProbeGroup);
	addNumbers(command, "--window", 2, probe.window, pairOf<probe::WindowSize>,
	           "Size of the windows, along the sheets' x and y axes (default: sheets cover the whole slice)")
	    ->type_name("W H")
	    ->group(kProbeGroup);
	command.add_option("--vanes", probe.vanes, "Of a paddlewheel (default: 3)")->type_name("N")->group(kProbeGroup);
	command.add_option("--offsets", probe.offsets, "Of a stack: where its sheets lie along the normal")
	    ->type_name("D...")
	    ->group(kProbeGroup);
	command.add_option("--sheets", probe.sheets, "Of a stack: so many, spread evenly over the bounds (default: 5)")
	    ->type_name("N")
	    ->group(kProbeGroup);
}

void addSurfaceOptions(CLI::App& command, SpecOptions& options)
{
	view::ProbeSpec& probe = options.spec.probe;
	CLI::Option* surface =
	    addText(command, options, "--surface", probe.surface, view::parseSurface,
	            "In place of a plane: a surface about the origin and the normal (half angle of a cone; "
	            "ellipsoid:A,B,C and quadric: with ten numbers too). Or a grid surface of structured blocks, i, j "
	            "or k=INDEX of its points from 0, between two with a fraction; a sweep goes from FIRST to LAST. Or "
	            "a part of the boundary that the file names")
	        ->type_name("EXPR|sphere:R|cylinder:R|cone:DEGREES|i=INDEX|i=FIRST..LAST|patch=NAME")
	        ->group(kProbeGroup);
	addText(
	    command, options, "--iso", probe.surface,
	    [](const std::string& value) { return view::parseSurface("iso:" + value); },
	    "In place of a plane: the surface where the array, of points, has this value")
	    ->excludes(surface)
	    ->type_name("VALUE")
	    ->group(kProbeGroup);
	command
	    .add_flag("--crinkle", probe.crinkle,
	              "The cells that are cut, whole: their faces, but for those between two of them, in place of the cut")
	    ->group(kProbeGroup);
}

Result<std::optional<int>> parseComponent(const std::string& word)
{
	if (const std::optional<int> component = grid::parseComponent(word))
		return component;
	return Error{ErrorKind::usage, "not a component; use magnitude, x, y, z or a number from 0"};
}

void addSearchOptions(CLI::App& command, SpecOptions& options)
{
	view::ProbeSpec& probe = options.spec.probe;
	view::MachineSpec& machine = options.spec.machine;
	addNumbers(command, "--threshold", 2, probe.threshold, pairOf<find::Threshold>,
	           "Ends the traversal at cells whose values all lie below LO, or all above HI")
	    ->type_name("LO HI")
	    ->group(kProbeGroup);
	addWord(command, "--seeds", probe.seeds,
	        "Where the traversal starts. auto: hot spot and boundary, every piece; hotspot: the piece that "
	        "holds the hot spot")
	    ->group(kProbeGroup);
	addWord(command, "--outside", probe.outside,
	        "A hot spot outside the grid: nearest moves it to the nearest point of the sheet inside, refuse is "
	        "an error, report only says so")
	    ->group(kProbeGroup);
	addWord(command, "--visited", machine.visited,
	        "Traverses by generations, and knows queued cells by stamps, a byte a cell, or by a search of the queue's "
	        "octants, without memory over the grid. Without the option the CPU finds cells in whatever way is fastest")
	    ->group(kProbeGroup);
	addWord(command, "--strategy", machine.strategy,
	        "How cut cells are found, in place of the best way for each block; --explain shows that one")
	    ->group(kProbeGroup);
}

} // namespace

CLI::Option* addInputs(CLI::App& command, SpecOptions& options)
{
	view::InputSpec& input = options.spec.input;
	CLI::Option* inputs =
	    command
	        .add_option("INPUT", input.files,
	                    "File, or demo:NAME[:N]; several make one block set. Reads " + read::readableEndings())
	        ->required();
	addText(command, options, "--time", input.time, read::parseTime,
	        "last, first, a time (the nearest there is is taken), or #INDEX, from 0")
	    ->default_str(read::timeText(input.time));
	command.add_option("--solution", input.solution,
	                   "PLOT3D solution (q) file, where its name does not follow from the grid's");
	command
	    .add_option("--refine", input.refine,
	                fmt::format("Curved (quadratic, Lagrange, Bezier) cells: halve their linear parts so many times "
	                            "more, up to {}, along the cell's shape",
	                            read::kMaxRefine))
	    ->type_name("LEVEL")
	    ->capture_default_str();
	command
	    .add_option("--displace", input.displace, "Moves the points of Exodus files by their displacements, times this")
	    ->type_name("SCALE");
	return inputs;
}

void addProbeOptions(CLI::App& command, SpecOptions& options)
{
	view::ProbeSpec& probe = options.spec.probe;
	addText(
	    command, options, "--probe", [&probe](const std::string& name) { return chooseProbe(probe, name); },
	    "Sheets that move as one: single, trihedral, paddlewheel, stack, or a file (docs/PROBES.md)")
	    ->type_name("NAME|FILE.json")
	    ->default_str(view::text(probe.shape))
	    ->group(kProbeGroup);
	addPlaceOptions(command, options);
	addSurfaceOptions(command, options);
	addWord(command, "--corners", probe.corners,
	        "Polygons that hold a corner of a window: keep (the default) or skip them")
	    ->group(kProbeGroup);
	command
	    .add_option("--array", probe.array, "Array to show (default: the first point array, else the first cell array)")
	    ->type_name("[point:|cell:]NAME")
	    ->group(kProbeGroup);
	addText(command, options, "--component", probe.component, parseComponent,
	        "Of a vector: a number from 0, x, y, z or magnitude (the default)")
	    ->type_name("N|x|y|z|magnitude")
	    ->group(kProbeGroup);
	addSearchOptions(command, options);
	addMachineOptions(command, options);
}

void addMachineOptions(CLI::App& command, SpecOptions& options)
{
	view::MachineSpec& machine = options.spec.machine;
	addWord(command, "--classify", machine.classify,
	        "Where cells are classified. auto: where it is faster, which is the CPU unless there is a hardware "
	        "device; gpu: on the Vulkan device; cpu: on the CPU")
	    ->group(kProbeGroup);
	command.add_option("--device", machine.device, "Vulkan device, by part of its name or by number")
	    ->type_name("NAME|INDEX")
	    ->group(kProbeGroup);
	command.add_option("--threads", machine.threads, "Most threads to use (default: all cores)")->group(kProbeGroup);
}

void addExplain(CLI::App& command, SpecOptions& options)
{
	command
	    .add_flag("--explain", options.explain, "Prints how each sheet will be cut in each block, and why, and ends")
	    ->group(kProbeGroup);
}

} // namespace vp::app
