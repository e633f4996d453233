#pragma once

#include "base/result.h"
#include "find/listed.h"
#include "find/plan.h"
#include "find/threshold.h"
#include "find/visited.h"
#include "mesh/clip.h"
#include "mesh/hanging_vertices.h"
#include "probe/path.h"
#include "probe/presets.h"
#include "probe/probe_file.h"
#include "read/read.h"
#include "read/series.h"
#include "render/scene/camera.h"
#include "render/scene/look.h"
#include "seed/seeds.h"
#include "surface/grid_index.h"
#include "surface/implicit_surface.h"
#include "vectors/particle.h"
#include "view/context_spec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vp::view
{

// Everything that a user can set, as typed values. A command line, the panels of a window, a state file and a program
// that embeds the library all make a ViewSpec. The defaults apply to what is not set.
//
// validate() (validate.h) checks the values; settings.h says how each value is written as text; resolve() applies them
// to a data set.

struct InputSpec
{
	std::vector<std::string> files;                       // or demo:NAME[:N]
	read::InputsAs inputs_as = read::InputsAs::automatic; // what several files are to each other
	read::TimeChoice time{};
	std::string solution; // PLOT3D solution file, if its name does not follow from the grid's name
	// How often the linear parts of curved cells are halved, 0 to read::kMaxRefine; or a tolerance, read::isTolerance()
	double refine = 0.0;
	int level = 0;                  // which of several resolutions of an image; 0 is the finest
	bool cell_to_point = false;     // arrays of cells become arrays of points
	std::optional<double> displace; // factor for the displacements of points; empty: 1 if an array is named, else 0
	std::string displace_by;        // the array of displacements; if empty, its name tells
	std::string format;             // a name in read::formats(); if empty, the file tells
	read::RawLayout raw{};          // layout of raw volumes

	bool operator==(const InputSpec&) const = default;
};

enum class ProbeShape : std::uint8_t
{
	single,
	trihedral,
	paddlewheel,
	stack,
	own // ProbeSpec::own
};

/// The surface that replaces the planes of a probe: none, a surface about the frame of each sheet, grid surfaces from
/// one index to another, or patches of the boundary. The last two replace the sheets as well.
using SurfaceSpec = std::variant<std::monostate, surface::ImplicitSurface, surface::GridIndexRange, find::PatchName>;

/// Returns true if the surface replaces the sheets, so that no sheet is cut.
bool replacesSheets(const SurfaceSpec& surface);

/// Returns the implicit surface, or null.
const surface::ImplicitSurface* implicitSurface(const SurfaceSpec& surface);

enum class TraceKind : std::uint8_t
{
	tufts, // arrows of one step
	lines,
	ribbons, // they turn with the flow
	tubes
};

/// The particles that start on the sheets.
struct VectorSpec
{
	std::optional<TraceKind> kind; // empty: nothing is launched
	std::string array;           // an array of three components, "[point:|cell:]NAME"; empty: vectors::chooseVectors()
	int lattice = 20;            // points along the longer side of a window, 1 to kMaxLattice
	double jitter = 0.0;         // 0 to 1: random shift of the points within their squares
	std::optional<double> steps; // 0 or more; if empty, it depends on the kind
	std::optional<double>
	    dt; // time of a step, above 0; if empty, it follows from the fastest particle and the lattice's spacing
	vectors::Direction direction = vectors::Direction::forward;
	vectors::VectorPart part = vectors::VectorPart::whole;
	bool path_lines = false; // the field changes while particles move

	bool on() const { return kind.has_value(); }
	/// A tuft shows one step; the other kinds follow particles a long way.
	double stepsOrDefault() const { return steps.value_or(kind == TraceKind::tufts ? 1.0 : 200.0); }
	bool operator==(const VectorSpec&) const = default;
};

constexpr int kMaxLattice = 1000; // a screen has fewer pixels than points beyond this

enum class Interpolate : std::uint8_t
{
	automatic, // arrays that name categories are not interpolated
	nearest,   // no array is: a place has the value of the nearest point
	linear     // every array is
};

/// The probe that cuts, and the values that it shows.
struct ProbeSpec
{
	ProbeShape shape = ProbeShape::single;
	std::optional<probe::ProbeFile> own{};   // filled if the shape is `own`
	std::optional<Vec3> origin;              // place of the hot spot; empty: the center of the bounds
	std::optional<Vec3> normal;              // not zero; empty: z
	std::optional<Vec3> up;                  // not zero, made perpendicular to the normal; empty: y
	std::optional<probe::WindowSize> window; // empty: sheets cover the whole cut
	SurfaceSpec surface{};
	bool crinkle = false;                 // show the cut cells whole
	std::optional<int> vanes;             // for a paddlewheel, 1 to kMaxSheets
	std::vector<double> offsets;          // for a stack, along the normal
	std::optional<int> sheets;            // for a stack: number of sheets, spread evenly over the bounds
	std::optional<mesh::Corners> corners; // empty: keep
	mesh::Hanging hanging = mesh::Hanging::keep;
	std::string array;            // the shown array, "[point:|cell:]NAME"; empty: the first array
	std::optional<int> component; // from 0, or grid::kMagnitude; empty: the magnitude of a vector
	Interpolate interpolate = Interpolate::automatic;
	std::optional<find::Threshold> threshold;
	seed::SeedMode seeds = seed::SeedMode::automatic;
	seed::OutsidePolicy outside = seed::OutsidePolicy::nearest;
	VectorSpec vectors{};

	bool operator==(const ProbeSpec&) const = default;
};

enum class Classify : std::uint8_t
{
	automatic, // where it is faster
	gpu,
	cpu
};

/// Settings of the machine, which no state file holds.
struct MachineSpec
{
	Classify classify = Classify::automatic;
	std::string device;                        // a part of its name, or its number; empty: the best
	double device_memory = 0.0;                // bytes of the device that may be used; 0: half of what it has
	double memory = 0.0;                       // bytes for parts of arrays that stay in files; 0: half of what is free
	int threads = 0;                           // largest number of threads; 0: one per core
	std::optional<find::Strategy> strategy{};  // empty: the plan chooses
	std::optional<find::VisitedSet> visited{}; // if given, cells are found by generations

	bool operator==(const MachineSpec&) const = default;
};

struct PictureSize
{
	std::uint32_t width = 1280; // pixels, 1 to render::kMaxPictureSize
	std::uint32_t height = 720;

	bool operator==(const PictureSize&) const = default;
};

enum class ColorBy : std::uint8_t
{
	array,
	generation // the generation in which the traversal met the cell
};

enum class RangeOf : std::uint8_t
{
	automatic, // the window of a scan, otherwise the whole array
	data,      // the whole array
	slice,     // what the sheets show
	times      // the array at all times
};

enum class AxesStyle : std::uint8_t
{
	corner, // arrows of x, y and z in a corner
	box,    // numbers along the edges of the bounds
	none
};

/// The look of particles.
struct VectorLookSpec
{
	std::string color; // name of an array, or a color; empty: the length of the vector
	std::string
	    colormap; // like LookSpec::colormap; empty: the map of the sheets for the same array, otherwise another map
	std::optional<double> width; // in the grid's units, above 0; empty: a share of the lattice's spacing
	double opacity = 1.0;        // 0 to 1

	bool operator==(const VectorLookSpec&) const = default;
};

/// Surfaces of one value that grow from the sheets.
struct ContourSpec
{
	std::vector<double> values;                  // for every sheet
	std::optional<std::pair<double, double>> at; // U and V on the first sheet; the value at this place is used
	double depth = 0.0;                          // depth of the box in the grid's units; 0: it follows from the window
	double opacity = 1.0;                        // 0 to 1

	bool isGiven() const { return !values.empty() || at; }
	bool operator==(const ContourSpec&) const = default;
};

/// The look of the picture.
struct LookSpec
{
	PictureSize size{};
	int samples = 8; // per pixel, 1 to render::kMaxSamples
	// A name, or FILE.json[:PRESET]; a following _r reverses it. Empty: gray for scans, otherwise viridis.
	std::string colormap;
	// A place between the ends of the colors and an opacity for each point (render/color/opacity_points.h). Empty: the
	// opacities of the color map.
	std::vector<double> opacity_points{};
	ColorBy color_by = ColorBy::array;
	std::optional<std::pair<double, double>> range; // range of the colors, lower value first
	RangeOf range_of = RangeOf::automatic;
	bool mark_out_of_range = false; // values outside the range get colors of their own
	bool symmetric = false;         // the range of the colors is symmetric about 0
	bool logarithmic = false;
	double opacity = 1.0; // 0 to 1, for every sheet
	int lines = 0;        // approximate number of contour lines, 0 to render::kMaxLevels
	int bands = 0;        // approximate number of bounds between bands
	bool mesh = false;    // draw the edges of polygons
	bool lit = false;
	render::Background background{};
	render::CameraChoice camera{};
	render::Projection projection = render::Projection::perspective;
	render::Outline outline = render::Outline::box;
	std::vector<ContextSpec> context{}; // surfaces around the sheets
	AxesStyle axes = AxesStyle::corner;
	bool no_legend = false;
	bool no_labels = false;
	bool no_footer = false;                    // leave out the line with the sheet's place
	bool no_inset = false;                     // leave out the small view of a flat picture
	double text_size = 0.0;                    // pixels of an em; 0: it follows from the size of the picture
	std::string font{};                        // a family, or a file; empty: the font of the program
	std::optional<std::string> legend_title{}; // empty: the array's name and units
	std::string units{};                       // units of the array; empty: those of the file
	std::string length_units{};                // units of the coordinates; empty: those of the file
	std::optional<std::string> title{};        // empty: the name of the input
	VectorLookSpec vectors{};
	ContourSpec contour{};

	bool operator==(const LookSpec&) const = default;
};

/// The sweep of a probe.
struct SweepSpec
{
	std::optional<probe::Path> own{}; // takes precedence over `kind`
	probe::PathKind kind = probe::PathKind::translate;
	bool over_times = false; // the probe stands still while the input's times go by
	std::optional<int> frames{};
	std::optional<double> frames_per_second{}; // above 0; empty: framesPerSecond()
	std::optional<double> seconds{};           // length of a film, above 0
	bool there_and_back = false;

	bool operator==(const SweepSpec&) const = default;
};

struct ViewSpec
{
	InputSpec input;
	ProbeSpec probe;
	MachineSpec machine;
	LookSpec look;
	SweepSpec sweep;

	bool operator==(const ViewSpec&) const = default;
};

} // namespace vp::view
