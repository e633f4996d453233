#include "grid/field_choice.h"
#include "options/option_values.h"
#include "read/formats.h"
#include "read/read.h"

namespace vp::app
{

namespace
{

const char* const kProbeGroup = "Probe";

// Takes the name of a built-in probe, or reads a probe file.
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
	           "Place of the probe's hot spot (default: the center of the bounds)")
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
	           "Size of the sheets' windows along their x and y axes (default: the sheets cover the whole cut)")
	    ->type_name("W H")
	    ->group(kProbeGroup);
	command.add_option("--vanes", probe.vanes, "Number of a paddlewheel's vanes (default: 3)")
	    ->type_name("N")
	    ->group(kProbeGroup);
	command.add_option("--offsets", probe.offsets, "Places of a stack's sheets along the normal")
	    ->type_name("D...")
	    ->group(kProbeGroup);
	command
	    .add_option("--sheets", probe.sheets, "Number of a stack's sheets, spread evenly over the bounds (default: 5)")
	    ->type_name("N")
	    ->group(kProbeGroup);
}

void addSurfaceOptions(CLI::App& command, SpecOptions& options)
{
	view::ProbeSpec& probe = options.spec.probe;
	CLI::Option* surface =
	    addText(command, options, "--surface", probe.surface, view::parseSurface,
	            "Cut by another surface instead of a plane: a sphere, cylinder or cone (by its half angle) about the "
	            "origin and the normal, ellipsoid:A,B,C, quadric: with ten numbers, or an expression of x, y and z. Or "
	            "show a grid surface of structured blocks: i, j or k=INDEX counts its points from 0, a fraction lies "
	            "between two; a sweep goes from FIRST to LAST. Or show a part of the boundary that the file names")
	        ->type_name("EXPR|sphere:R|cylinder:R|cone:DEGREES|i=INDEX|i=FIRST..LAST|patch=NAME")
	        ->group(kProbeGroup);
	addText(
	    command, options, "--iso", probe.surface,
	    [](const std::string& value) { return view::parseSurface("iso:" + value); },
	    "Cut by the surface where a point array has this value, instead of by a plane")
	    ->excludes(surface)
	    ->type_name("VALUE")
	    ->group(kProbeGroup);
	command
	    .add_flag("--crinkle", probe.crinkle,
	              "Show the cut cells whole instead of the cut: all their faces except those between two cut cells")
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
	           "Stop the traversal at cells whose values all lie below LO, or all above HI")
	    ->type_name("LO HI")
	    ->group(kProbeGroup);
	addWord(command, "--seeds", probe.seeds,
	        "Where the traversal starts. auto: hot spot and boundary, every piece; hotspot: the piece that "
	        "holds the hot spot")
	    ->group(kProbeGroup);
	addWord(command, "--outside", probe.outside,
	        "What happens when the hot spot lies outside the grid. nearest: it moves to the nearest point of the sheet "
	        "inside; refuse: an error; report: only a warning")
	    ->group(kProbeGroup);
	addWord(command, "--visited", machine.visited,
	        "Traverse by generations, and remember the cells in the queue by stamps (one byte per cell of the grid) or "
	        "by octants (a search of the queue, without memory over the grid). Without this option the CPU finds cells "
	        "in the fastest way")
	    ->group(kProbeGroup);
	addWord(command, "--strategy", machine.strategy,
	        "How cut cells are found, instead of the best way for each block, which --explain shows")
	    ->group(kProbeGroup);
}

} // namespace

CLI::Option* addInputs(CLI::App& command, SpecOptions& options)
{
	view::InputSpec& input = options.spec.input;
	CLI::Option* inputs =
	    command
	        .add_option("INPUT", input.files,
	                    "A file, or demo:NAME[:N]. Several inputs make one data set. Reads " + read::readableEndings())
	        ->required();
	addText(command, options, "--time", input.time, read::parseTime,
	        "Time to read: last, first, a time (the nearest one that the file has), or #INDEX from 0")
	    ->default_str(read::timeText(input.time));
	command.add_option(
	    "--solution", input.solution,
	    "File with the values, if its name does not follow: PLOT3D's q, Fluent's .dat, the quads of CAM");
	command
	    .add_option("--refine", input.refine,
	                fmt::format("Cut curved cells (quadratic, Lagrange, Bezier) into finer linear parts: halve the "
	                            "parts this many times more, 0 to {}. Or, between 0 and 1, refine curved cells "
	                            "where a sheet meets them, until they are off by no more than this share of "
	                            "their size and of the array's range",
	                            read::kMaxRefine))
	    ->type_name("LEVEL|TOL")
	    ->capture_default_str();
	command
	    .add_option("--displace", input.displace,
	                "Move the points of Exodus files by their displacements times this factor")
	    ->type_name("SCALE");
	command
	    .add_option("--format", input.format,
	                "Read INPUT as this format, which vprobe info --formats lists; otherwise the file tells")
	    ->type_name("NAME");
	addText(command, options, "--raw-size", input.raw.size, read::parseRawSize,
	        "Read INPUT as a raw volume of so many values; x runs fastest, and what precedes them is skipped")
	    ->type_name("NXxNYxNZ");
	addText(command, options, "--raw-type", input.raw.type, read::parseRawType, "Type of the values of a raw volume")
	    ->default_str(read::rawTypeText(input.raw.type));
	addText(command, options, "--raw-spacing", input.raw.spacing, read::parseRawSpacing,
	        "Distances of the values of a raw volume")
	    ->type_name("DXxDYxDZ")
	    ->default_str(read::rawSpacingText(input.raw.spacing));
	addText(command, options, "--raw-order", input.raw.is_big_endian, read::parseRawOrder,
	        "Byte order of a raw volume, little or big")
	    ->default_str(read::rawOrderText(input.raw.is_big_endian));
	return inputs;
}

void addProbeOptions(CLI::App& command, SpecOptions& options)
{
	view::ProbeSpec& probe = options.spec.probe;
	addText(
	    command, options, "--probe", [&probe](const std::string& name) { return chooseProbe(probe, name); },
	    "The probe: single, trihedral, paddlewheel, stack, or a file (docs/PROBES.md)")
	    ->type_name("NAME|FILE.json")
	    ->default_str(view::text(probe.shape))
	    ->group(kProbeGroup);
	addPlaceOptions(command, options);
	addSurfaceOptions(command, options);
	addWord(command, "--corners", probe.corners,
	        "Polygons that hold a corner of a window: keep (the default) or skip them")
	    ->group(kProbeGroup);
	addWord(
	    command, "--hanging", probe.hanging,
	    "Values where a cell meets several smaller ones, as between levels of refinement. keep: each side has its own; "
	    "interpolate: both have that of the larger cell, linear along its polygon, for smooth pictures")
	    ->group(kProbeGroup);
	command
	    .add_option("--array", probe.array, "Array to show (default: the first point array, else the first cell array)")
	    ->type_name("[point:|cell:]NAME")
	    ->group(kProbeGroup);
	addText(command, options, "--component", probe.component, parseComponent,
	        "Component of a vector to show: a number from 0, x, y, z or magnitude (the default)")
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
	command.add_option("--device", machine.device, "The Vulkan device: a part of its name, or its number")
	    ->type_name("NAME|INDEX")
	    ->group(kProbeGroup);
	command
	    .add_option(
	        "--device-memory", machine.device_memory,
	        "Memory of the device that may be used, in bytes or as 1G, 512M. A picture that needs more is drawn "
	        "in parts (default: half of what the device has)")
	    ->type_name("BYTES")
	    ->transform(CLI::AsSizeValue(false))
	    ->group(kProbeGroup);
	command.add_option("--threads", machine.threads, "Largest number of threads (default: all cores)")
	    ->group(kProbeGroup);
}

void addExplain(CLI::App& command, SpecOptions& options)
{
	command
	    .add_flag("--explain", options.explain, "Print how each sheet will be cut in each block, and why; cut nothing")
	    ->group(kProbeGroup);
}

} // namespace vp::app
