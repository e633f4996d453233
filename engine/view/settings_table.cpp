#include "read/formats.h"
#include "render/color/color_map.h"
#include "render/scene/levels.h"
#include "view/setting_places.h"
#include "view/settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

namespace vp::view
{

namespace
{

constexpr double kAny = std::numeric_limits<double>::max();
constexpr double kMaxSteps = 1e6;
constexpr Limits kShare{0.0, 1.0};
constexpr Limits kAboveZero{std::numeric_limits<double>::min(), kAny};
constexpr Limits kSheets{1, probe::kMaxSheets};
constexpr Limits kLevels{0, render::kMaxLevels};
constexpr const char* kArrayName = "[point:|cell:]NAME";
constexpr const char* kMapName = "NAME|FILE.json[:PRESET]";

Section inputSection(InputSpec& input)
{
	read::RawLayout& raw = input.raw;
	return {
	    "input",
	    "",
	    {{"files", Files{&input.files},
	      "A file, or demo:NAME[:N]. Several inputs make one data set, volume or series. Reads " +
	          read::readableEndings(),
	      "INPUT"},
	     {"inputs", word(&input.inputs_as),
	      "What several inputs are to each other. blocks: together they are one data set; times: each is a time of a "
	      "series; stack: each is a slice of one volume. auto: stack if they are pictures of two dimensions, times if "
	      "their names differ by a number alone and their grids are the same, else blocks"},
	     {"time", written(&input.time, read::parseTime, read::timeText),
	      "Time to read: last, first, a time (the nearest one that the file has), or #INDEX from 0"},
	     {"solution", File{&input.solution},
	      "File with the values, if its name does not follow: PLOT3D's q, Fluent's .dat, the quads of CAM"},
	     {"refine", &input.refine,
	      fmt::format("Cut curved cells (quadratic, Lagrange, Bezier) into finer linear parts: halve the parts this "
	                  "many times more, 0 to {} (default: 0). Or, between 0 and 1, refine curved cells where a "
	                  "sheet meets them, until they are off by no more than this share of their size and of the "
	                  "array's range",
	                  read::kMaxRefine),
	      "LEVEL|TOL", Limits{0, read::kMaxRefine}},
	     {"level", &input.level,
	      "Level to read of images that hold several resolutions (OME-Zarr): 0 is the finest, and vprobe info tells "
	      "how "
	      "many there are. Figures are those of this level",
	      "N", Limits{0, read::kMaxLevel}},
	     {"cell_to_point", &input.cell_to_point,
	      "Take the values of cells to the points, for smooth colors: each point has the mean of its cells. NaN and "
	      "hidden "
	      "cells do not count, and names of categories stay in the cells"},
	     {"displace", &input.displace,
	      "Move the points by their displacements times this factor (default: 0, or 1 with `displace_by`)", "SCALE"},
	     {"displace_by", &input.displace_by,
	      "Point array of three components that holds the displacements (default: the one whose name says so, such as "
	      "displacement, DISP or DEPL, or U of a solid)",
	      "NAME"},
	     {"format", format(&input.format),
	      "Read INPUT as this format, which vprobe info `formats` lists; otherwise the file tells", "NAME"},
	     {"raw_size", ofRaw(input, &raw.size, read::parseRawSize, read::rawSizeText),
	      "Read INPUT as a raw volume of so many values; x runs fastest, and what precedes them is skipped",
	      "NXxNYxNZ"},
	     {"raw_type", ofRaw(input, &raw.type, read::parseRawType, read::rawTypeText),
	      "Type of the values of a raw volume"},
	     {"raw_spacing", ofRaw(input, &raw.spacing, read::parseRawSpacing, read::rawSpacingText),
	      "Distances of the values of a raw volume", "DXxDYxDZ"},
	     {"raw_order", ofRaw(input, &raw.is_big_endian, read::parseRawOrder, read::rawOrderText),
	      "Byte order of a raw volume, little or big"}}};
}

Section probeSection(ProbeSpec& probe)
{
	return {
	    "probe",
	    "Probe",
	    {{"probe", ProbeChoice{&probe}, "The probe: single, trihedral, paddlewheel, stack, or a file (docs/PROBES.md)",
	      "NAME|FILE.json"},
	     {"origin", vector(&probe.origin), "Place of the probe's hot spot (default: the center of the bounds)",
	      "X Y Z"},
	     {"normal", direction(&probe.normal), "The probe's normal: x, y, z, -x, -y, -z or three numbers (default: z)",
	      "X Y Z|x|y|z|-x|-y|-z"},
	     {"up", vector(&probe.up), "The probe's y axis, made perpendicular to the normal (default: 0 1 0)", "X Y Z"},
	     {"window", pair(&probe.window),
	      "Size of the sheets' windows along their x and y axes (default: the sheets cover the whole cut)", "W H"},
	     {"vanes", &probe.vanes, "Number of a paddlewheel's vanes (default: 3)", "N", kSheets},
	     {"offsets", list(&probe.offsets), "Places of a stack's sheets along the normal", "D..."},
	     {"sheets", &probe.sheets, "Number of a stack's sheets, spread evenly over the bounds (default: 5)", "N",
	      kSheets},
	     {"surface", surface(&probe.surface),
	      "Cut by another surface instead of a plane: a sphere, cylinder or cone (by its half angle) about the origin "
	      "and the normal, ellipsoid:A,B,C, quadric: with ten numbers, or an expression of x, y and z. Or show a grid "
	      "surface of structured blocks: i, j or k=INDEX counts its points from 0, a fraction lies between two; a "
	      "sweep "
	      "goes from FIRST to LAST. Or show a part of the boundary that the file names",
	      "EXPR|sphere:R|cylinder:R|cone:DEGREES|i=INDEX|i=FIRST..LAST|patch=NAME"},
	     {"iso", isoValue(&probe.surface),
	      "Cut by the surface where a point array has this value, instead of by a plane", "VALUE"},
	     {"crinkle", &probe.crinkle,
	      "Show the cut cells whole instead of the cut: all their faces except those between two cut cells"},
	     {"corners", word(&probe.corners), "Polygons that hold a corner of a window: keep (the default) or skip them"},
	     {"hanging", word(&probe.hanging),
	      "Values where a cell meets several smaller ones, as between levels of refinement. keep: each side has its "
	      "own; interpolate: both have that of the larger cell, linear along its polygon, for smooth pictures"},
	     {"array", &probe.array, "Array to show (default: the first point array, else the first cell array)",
	      kArrayName},
	     {"component", component(&probe.component),
	      "Component to show: magnitude (the default), x, y or z of a vector, xx, xy and so on of a tensor, or a "
	      "number from 0",
	      "N|x|y|z|xx|xy|...|magnitude"},
	     {"interpolate", word(&probe.interpolate),
	      "Values between points. nearest: a place has the value of the nearest point; linear: values between those of "
	      "the points. auto: nearest for labels, which the file calls so, or whose name or few integer values tell it; "
	      "linear for others"},
	     {"threshold", pair(&probe.threshold),
	      "Stop the traversal at cells whose values all lie below LO, or all above HI", "LO HI"},
	     {"seeds", word(&probe.seeds),
	      "Where the traversal starts. auto: hot spot and boundary, every piece; hotspot: the piece that holds the hot "
	      "spot"},
	     {"outside", word(&probe.outside),
	      "What happens when the hot spot lies outside the grid. nearest: it moves to the nearest point of the sheet "
	      "inside; refuse: an error; report: only a warning"}}};
}

Section lookSection(LookSpec& look)
{
	return {
	    "look",
	    "Look",
	    {{"size", written(&look.size, parseSize, sizeText), "Size of the picture in pixels", "WxH"},
	     {"colormap", NameOrFile{&look.colormap},
	      fmt::format(
	          "{}, or a file of ParaView's presets, with :PRESET where it holds several; NAME_r and FILE.json_r "
	          "are the reverse (default: grey for scans and images of small integers, otherwise viridis)",
	          fmt::join(render::colorMapNames(), ", ")),
	      kMapName},
	     {"opacity_points", list(&look.opacity_points),
	      "Opacity by value instead of that of the color map: for each point a place between the ends of the map, 0 to "
	      "1, and an opacity, 0 to 1. Between two points it is linear. It is multiplied by `opacity`",
	      "X A...", kShare},
	     {"color_by", word(&look.color_by),
	      "Color the polygons by the array, or by the generation in which the traversal met their cells (`seeds` "
	      "hotspot shows the front)"},
	     {"range", pair(&look.range), "Values at the ends of the color map (default: those of the whole array)",
	      "LO HI"},
	     {"range_of", word(&look.range_of),
	      "Range of the color map: the values of the whole array (data), those that the sheets show (slice), or those "
	      "of "
	      "the array at all times of the input, which are read first (times). auto: of a scan the window that the file "
	      "names, or all but the outer 0.5 percent of its values; of others data"},
	     {"window_level", windowLevel(&look.range),
	      "The range of the colors as radiologists give it: its width, and the value in its middle", "W L"},
	     {"mark_out_of_range", &look.mark_out_of_range,
	      "Give values outside the range colors of their own, instead of those of its ends"},
	     {"symmetric", &look.symmetric, "Make the range symmetric about 0, so that 0 has the middle color"},
	     {"log", &look.logarithmic, "Color by the logarithm of the values"},
	     {"lines", &look.lines, "Draw about N contour lines, at round values", "N", kLevels},
	     {"no_legend", &look.no_legend, "Draw no legend"},
	     {"no_labels", &look.no_labels, "Draw contour lines without their values"},
	     {"bands", &look.bands, "Draw bands of one color each, with about N round values between them", "N", kLevels},
	     {"mesh", &look.mesh, "Draw the edges of the cut's polygons"},
	     {"background", written(&look.background, render::parseBackground, render::backgroundText),
	      "Background of the picture: gradient, white, black, gray, transparent, #RGB or #RRGGBB", "COLOR"},
	     {"camera", written(&look.camera, render::parseCamera, [](const auto& choice) { return choice.text; }),
	      "The camera: auto (obliquely onto the sheet), x, -x, y, -y, z, -z, iso, sheet, azimuth and elevation in "
	      "degrees, or nine numbers for position, focal point and up",
	      "VIEW|AZ,EL|9 NUMBERS"},
	     {"projection", word(&look.projection),
	      "How the camera sees space. parallel: sizes do not change with the distance, and parallel lines stay "
	      "parallel"},
	     {"outline", word(&look.outline),
	      "Lines around the sheets: the box of the data, the feature edges of its boundary, or none"},
	     {"units", &look.units, "Units of the array, shown behind its name (default: those that the file names)",
	      "TEXT"},
	     {"length_units", &look.length_units,
	      "Units of the grid's coordinates, shown on the axes (default: those that the file names)", "TEXT"},
	     {"title", &look.title, "Title above the picture (default: the input's name; \"\" for none)", "TEXT"},
	     {"samples", &look.samples, "Samples per pixel, for smooth edges", "", Limits{1, render::kMaxSamples},
	      Offer::in_space},
	     {"opacity", &look.opacity, "Opacity of every sheet, 0 to 1. Opacities of the color map are multiplied by it",
	      "", kShare, Offer::in_space},
	     {"lit",
	      &look.lit,
	      "Shade the sheets: the more a sheet turns away from the light, the darker it is",
	      "",
	      {},
	      Offer::in_space},
	     {"axes",
	      word(&look.axes),
	      "Axes: corner (arrows in a corner of the picture), box (numbers along the edges of the bounds) or none",
	      "",
	      {},
	      Offer::in_space},
	     {"context",
	      contexts(&look.context),
	      "Draw a translucent surface around the sheets. May be given several times. boundary: the boundary of the "
	      "domain; i, j, k: a grid surface; patch: a part of the boundary that the file names",
	      contextForms(),
	      {},
	      Offer::in_space}}};
}

// The settings of the text in and around a picture.
std::vector<Setting> textSettings(LookSpec& look)
{
	return {
	    {"legend_title", &look.legend_title,
	     "Title above the legend of the array (default: its name and units; \"\" for none)", "TEXT"},
	    {"text_size", written(&look.text_size, render::parseTextSize, textSizeText),
	     "Size of the text in pixels, or with pt in points of 4/3 pixels, which is their size on the page of a .pdf "
	     "(default: it follows from `size`)",
	     "N|Npt"},
	    {"font", NameOrFile{&look.font},
	     "Font of all text: a family that is installed, or a .ttf, .otf or .ttc file (default: DejaVu Sans). Letters "
	     "that it lacks are taken from other fonts",
	     "FAMILY|FILE"},
	    {"no_footer", &look.no_footer, "Leave out the line below the picture that tells the place of the sheet"},
	    {"no_inset",
	     &look.no_inset,
	     "Leave out the small view of the grid beside a flat picture",
	     "",
	     {},
	     Offer::flat}};
}

Section vectorSection(VectorSpec& vectors, VectorLookSpec& look)
{
	return {
	    "vectors",
	    "Vectors",
	    {{"vectors", word(&vectors.kind),
	      "Launch particles from a lattice of points on each sheet, and draw their paths: tufts (arrows of one step), "
	      "lines, ribbons (which turn with the flow) or tubes (docs/VECTORS.md)"},
	     {"vector_array", &vectors.array,
	      "Vector array that moves the particles (default: the velocity by its name or units, else the first array of "
	      "three components, point arrays first)",
	      kArrayName},
	     {"vector_lattice", &vectors.lattice,
	      fmt::format("Number of launch points along the longer side of a window, or of the cut if there is no window, "
	                  "1 to {}",
	                  kMaxLattice),
	      "N", Limits{1, kMaxLattice}},
	     {"vector_jitter", &vectors.jitter,
	      "Random shift of the points from the lattice: 0 is none (the default), 1 is anywhere in their squares", "J",
	      kShare},
	     {"vector_steps", &vectors.steps,
	      "Number of steps that a particle goes; fractions are allowed (default: 1 for tufts, otherwise 200)", "X",
	      Limits{0.0, kMaxSteps, "; `vector_direction` backward goes against the flow"}},
	     {"vector_dt", &vectors.dt,
	      "Time of a step (default: the time in which the fastest particle moves by one spacing of the lattice; "
	      "`stats` has it)",
	      "DT", kAboveZero},
	     {"vector_direction", word(&vectors.direction), "Particles follow the flow, go against it, or both"},
	     {"vector_part", word(&vectors.part),
	      "Part of the vector that moves the particles: the whole vector, its part in the sheet, or its part through "
	      "the sheet"},
	     {"path_lines", &vectors.path_lines,
	      "Particles move while the field changes through the input's times, starting at `time`. Without this option "
	      "the field stands still"},
	     {"vector_color",
	      &look.color,
	      "Color of the particles: an array, or one color: white, black, gray, #RRGGBB (default: the vector's length)",
	      "[point:|cell:]NAME|COLOR",
	      {},
	      Offer::in_space},
	     {"vector_colormap",
	      NameOrFile{&look.colormap},
	      "Color map of the particles (default: the sheets' map if they show the same array; otherwise turbo, or grey "
	      "beside turbo)",
	      kMapName,
	      {},
	      Offer::in_space},
	     {"vector_width", &look.width,
	      "Width of a tube, ribbon, line or tuft's shaft, in the grid's units (default: a share of the lattice's "
	      "spacing)",
	      "W", kAboveZero, Offer::in_space},
	     {"vector_opacity", &look.opacity, "Opacity of the particles, 0 to 1", "", kShare, Offer::in_space}}};
}

Section contourSection(ContourSpec& contour)
{
	return {"contours",
	        "Contours",
	        {{"contour", list(&contour.values),
	          "Draw the surfaces where the point array has these values, as far as they lie within the sheets' windows "
	          "and the depth in front of and behind them",
	          "VALUE..."},
	         {"contour_at", pair(&contour.at),
	          "Draw the surface of the value that the first sheet has at this place: 0 to 1 across its window, or "
	          "across its cut if it has no window",
	          "U V"},
	         {"contour_depth", &contour.depth,
	          "How far contours reach along the normal, half to each side (default, or 0: the smaller side of the "
	          "window, or half the smaller side of the cut if there is no window)",
	          "D", Limits{0.0, kAny}},
	         {"contour_opacity", &contour.opacity, "Opacity of the contours, 0 to 1", "A", kShare}}};
}

Section sweepSection(SweepSpec& sweep)
{
	return {"sweep",
	        "Sweep",
	        {{"path", PathChoice{&sweep},
	          "translate along the normal, rotate about the up axis, spin about the normal, revolve from vane to vane, "
	          "profile (the benchmark's), times (a frame for each time of the input), or a file (docs/PROBES.md)",
	          "NAME|FILE.json"},
	         {"frames", &sweep.frames, "Number of frames", "N", Limits{1, probe::kMaxFrames}},
	         {"fps", &sweep.frames_per_second,
	          "Frames per second, for films and for paths whose times are in seconds (default: 25, over times 2)", "",
	          kAboveZero},
	         {"seconds", &sweep.seconds, "Length of a film; `fps` follows from it", "S", kAboveZero},
	         {"there_and_back", &sweep.there_and_back, "Go back to the start at the end"}}};
}

} // namespace

std::vector<Section> sectionsOf(ViewSpec& spec)
{
	Section look = lookSection(spec.look);
	for (Setting& setting : textSettings(spec.look))
		look.settings.push_back(std::move(setting));
	return {inputSection(spec.input),
	        probeSection(spec.probe),
	        std::move(look),
	        vectorSection(spec.probe.vectors, spec.look.vectors),
	        contourSection(spec.look.contour),
	        sweepSection(spec.sweep)};
}

Section machineSection(ViewSpec& spec)
{
	MachineSpec& machine = spec.machine;
	return {"machine",
	        "Probe",
	        {{"visited",
	          word(&machine.visited),
	          "Traverse by generations, and remember the cells in the queue by stamps (one byte per cell of the grid) "
	          "or by octants (a search of the queue, without memory over the grid). Without this option the CPU finds "
	          "cells in the fastest way",
	          "",
	          {},
	          Offer::with_cuts},
	         {"strategy",
	          word(&machine.strategy),
	          "How cut cells are found, instead of the best way for each block, which `explain` shows",
	          "",
	          {},
	          Offer::with_cuts},
	         {"classify", word(&machine.classify),
	          "Where cells are classified. auto: where it is faster, which is the CPU unless there is a hardware "
	          "device; gpu: on the Vulkan device; cpu: on the CPU"},
	         {"device", &machine.device, "The Vulkan device: a part of its name, or its number", "NAME|INDEX"},
	         {"device_memory", Bytes{&machine.device_memory},
	          "Memory of the device that may be used, in bytes or as 1G, 512M. A picture that needs more is drawn in "
	          "parts (default: half of what the device has)",
	          "BYTES", Limits{0.0, kAny}},
	         {"memory", Bytes{&machine.memory},
	          "Memory for what is read of files part by part, in bytes or as 1G, 512M. Images that do not fit stay in "
	          "their file where that has them unpacked, and a cut reads what it meets (default: half of what is free)",
	          "BYTES", Limits{0.0, kAny}},
	         {"threads", &machine.threads, "Largest number of threads (default: all cores)", "", Limits{0, 4096}}}};
}

} // namespace vp::view
