#include "probe_options.h"

#include "read/read.h"

#include <CLI/CLI.hpp>

namespace vp::app
{

CLI::Option* addInputs(CLI::App& command, ProbeOptions& options)
{
	CLI::Option* inputs =
	    command
	        .add_option("INPUT", options.inputs,
	                    "File, or demo:NAME[:N]; several make one block set. Reads " + read::readableEndings())
	        ->required();
	command
	    .add_option("--time", options.time, "last, first, a time (the nearest there is is taken), or #INDEX, from 0")
	    ->capture_default_str();
	command.add_option("--solution", options.solution,
	                   "PLOT3D solution (q) file, where its name does not follow from the grid's");
	command
	    .add_option("--refine", options.refine,
	                "Curved (quadratic, Lagrange, Bezier) cells: halve their linear parts so many times more, along "
	                "the cell's shape")
	    ->check(CLI::Range(0, read::kMaxRefine))
	    ->type_name("LEVEL")
	    ->capture_default_str();
	command
	    .add_option("--displace", options.displace,
	                "Moves the points of Exodus files by their displacements, times this")
	    ->check(CLI::Number)
	    ->type_name("SCALE");
	return inputs;
}

void addProbeOptions(CLI::App& command, ProbeOptions& options)
{
	const char* group = "Probe";
	command
	    .add_option("--probe", options.probe,
	                "Sheets that move as one: single, trihedral, paddlewheel, stack, or a file (docs/PROBES.md)")
	    ->type_name("NAME|FILE.json")
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--origin", options.origin, "Where the probe stands, its hot spot (default: centre of the bounds)")
	    ->expected(3)
	    ->allow_extra_args(false)
	    ->type_name("X Y Z")
	    ->group(group);
	command.add_option("--normal", options.normal, "The probe's normal: x, y, z or three numbers (default: z)")
	    ->type_name("X Y Z|x|y|z")
	    ->group(group);
	command.add_option("--up", options.up, "The probe's y axis, made perpendicular to the normal (default: 0 1 0)")
	    ->expected(3)
	    ->allow_extra_args(false)
	    ->type_name("X Y Z")
	    ->group(group);
	command
	    .add_option("--window", options.window,
	                "Size of the windows, along the sheets' x and y axes (default: sheets cover the whole slice)")
	    ->expected(2)
	    ->allow_extra_args(false)
	    ->type_name("W H")
	    ->group(group);
	command.add_option("--vanes", options.vanes, "Of a paddlewheel (default: 3)")
	    ->check(CLI::Range(1, static_cast<int>(probe::kMaxSheets)))
	    ->type_name("N")
	    ->group(group);
	command.add_option("--offsets", options.offsets, "Of a stack: where its sheets lie along the normal")
	    ->type_name("D...")
	    ->group(group);
	command.add_option("--sheets", options.sheets, "Of a stack: so many, spread evenly over the bounds (default: 5)")
	    ->check(CLI::Range(1, static_cast<int>(probe::kMaxSheets)))
	    ->type_name("N")
	    ->group(group);
	CLI::Option* surface =
	    command
	        .add_option(
	            "--surface", options.surface,
	            "In place of a plane: a surface about the origin and the normal (half angle of a cone; "
	            "ellipsoid:A,B,C and quadric: with ten numbers too). Or a grid surface of structured blocks, i, j "
	            "or k=INDEX of its points from 0, between two with a fraction; a sweep goes from FIRST to LAST. Or "
	            "a part of the boundary that the file names")
	        ->type_name("EXPR|sphere:R|cylinder:R|cone:DEGREES|i=INDEX|i=FIRST..LAST|patch=NAME")
	        ->group(group);
	command
	    .add_option_function<std::string>(
	        "--iso", [&options](const std::string& value) { options.surface = "iso:" + value; },
	        "In place of a plane: the surface where the array, of points, has this value")
	    ->excludes(surface)
	    ->type_name("VALUE")
	    ->group(group);
	command
	    .add_flag("--crinkle", options.crinkle,
	              "The cells that are cut, whole: their faces, but for those between two of them, in place of the cut")
	    ->group(group);
	command
	    .add_option("--corners", options.corners,
	                "Polygons that hold a corner of a window: keep (the default) or skip them")
	    ->check(CLI::IsMember({"keep", "skip"}))
	    ->group(group);
	command
	    .add_option("--array", options.array,
	                "Array to show (default: the first point array, else the first cell array)")
	    ->type_name("[point:|cell:]NAME")
	    ->group(group);
	command
	    .add_option("--component", options.component,
	                "Of a vector: a number from 0, x, y, z or magnitude (the default)")
	    ->type_name("N|x|y|z|magnitude")
	    ->group(group);
	command
	    .add_option("--threshold", options.threshold,
	                "Ends the traversal at cells whose values all lie below LO, or all above HI")
	    ->expected(2)
	    ->allow_extra_args(false)
	    ->type_name("LO HI")
	    ->group(group);
	command
	    .add_option("--seeds", options.seeds,
	                "Where the traversal starts. auto: hot spot and boundary, every piece; hotspot: the piece that "
	                "holds the hot spot")
	    ->check(CLI::IsMember({"auto", "hotspot", "boundary"}))
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option("--outside", options.outside,
	                "A hot spot outside the grid: nearest moves it to the nearest point of the sheet inside, refuse is "
	                "an error, report "
	                "only says so")
	    ->check(CLI::IsMember({"nearest", "refuse", "report"}))
	    ->capture_default_str()
	    ->group(group);
	command
	    .add_option(
	        "--visited", options.visited,
	        "Traverses by generations, and knows queued cells by stamps, a byte a cell, or by a search of the queue's "
	        "octants, without memory over the grid. Without the option the CPU finds cells in whatever way is "
	        "fastest")
	    ->check(CLI::IsMember({"stamps", "octants"}))
	    ->group(group);
	command
	    .add_option("--strategy", options.strategy,
	                "How cut cells are found, in place of the best way for each block; --explain shows that one")
	    ->check(CLI::IsMember({"rows", "spans", "cells", "generations", "listed", "scan"}))
	    ->group(group);
	addDeviceOptions(command, options);
}

void addDeviceOptions(CLI::App& command, ProbeOptions& options)
{
	const char* group = "Probe";
	command
	    .add_option("--classify", options.classify,
	                "Where cells are classified. auto: where it is faster, which is the CPU unless there is a hardware "
	                "device; gpu: on the Vulkan device; cpu: on the CPU")
	    ->check(CLI::IsMember({"auto", "gpu", "cpu"}))
	    ->capture_default_str()
	    ->group(group);
	command.add_option("--device", options.device, "Vulkan device, by part of its name or by number")
	    ->type_name("NAME|INDEX")
	    ->group(group);
	command.add_option("--threads", options.threads, "Most threads to use (default: all cores)")
	    ->check(CLI::Range(1, 4096))
	    ->group(group);
}

void addExplain(CLI::App& command, ProbeOptions& options)
{
	command
	    .add_flag("--explain", options.explain, "Prints how each sheet will be cut in each block, and why, and ends")
	    ->group("Probe");
}

} // namespace vp::app
