#pragma once

#include "base/result.h"
#include "find/listed.h"
#include "find/plan.h"
#include "find/threshold.h"
#include "find/visited.h"
#include "mesh/clip.h"
#include "probe/path.h"
#include "probe/presets.h"
#include "probe/probe_file.h"
#include "read/read.h"
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
// that embeds the library all make a ViewSpec. A default is what holds where nothing is set.
//
// validate() (validate.h) tells what cannot be; settings.h says how each value is written as text; resolve() places
// it all in a data set.

struct InputSpec
{
	std::vector<std::string> files; // or demo:NAME[:N]; several make one block set
	read::TimeChoice time{};
	std::string solution;  // of PLOT3D, where its name does not follow from the grid's
	int refine = 0;        // 0 to read::kMaxRefine: how often the linear parts of curved cells are halved
	double displace = 0.0; // points of Exodus files move by their displacements, times this

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

/// What takes the place of a probe's planes: nothing, a surface about each sheet's frame, grid surfaces from one index
/// to another, or patches of the boundary. The last two take the place of the sheets too.
using SurfaceSpec = std::variant<std::monostate, surface::ImplicitSurface, surface::GridIndexRange, find::PatchName>;

/// Whether the surface takes the place of the sheets, which then are not cut at all.
bool replacesSheets(const SurfaceSpec& surface);

/// Null where it is none.
const surface::ImplicitSurface* implicitSurface(const SurfaceSpec& surface);

enum class TraceKind : std::uint8_t
{
	tufts, // arrows, one step long
	lines,
	ribbons, // turned with the flow
	tubes
};

/// The particles that start on the sheets.
struct VectorSpec
{
	std::optional<TraceKind> kind; // none: nothing is launched
	std::string array;             // of three components, "[point:|cell:]NAME"; empty: the first there is
	int lattice = 20;              // points along the longer side of a window, 1 to kMaxLattice
	double jitter = 0.0;           // 0 to 1: how far points stray within their squares
	std::optional<double> steps;   // 0 or more; else by the kind
	std::optional<double> dt;      // time of a step, above 0; else from the fastest and the lattice's spacing
	vectors::Direction direction = vectors::Direction::forward;
	vectors::VectorPart part = vectors::VectorPart::whole;
	bool path_lines = false; // the field changes while particles go

	bool on() const { return kind.has_value(); }
	/// A tuft shows one step; what else there is follows particles a long way.
	double stepsOrDefault() const { return steps.value_or(kind == TraceKind::tufts ? 1.0 : 200.0); }
	bool operator==(const VectorSpec&) const = default;
};

constexpr int kMaxLattice = 1000; // more would be more points than a screen has pixels

/// What is cut, and what of it is shown.
struct ProbeSpec
{
	ProbeShape shape = ProbeShape::single;
	std::optional<probe::ProbeFile> own{};   // where the shape is `own`
	std::optional<Vec3> origin;              // where the hot spot stands; none: the center of the bounds
	std::optional<Vec3> normal;              // not zero; none: z
	std::optional<Vec3> up;                  // not zero, made perpendicular to the normal; none: y
	std::optional<probe::WindowSize> window; // none: sheets cover the whole slice
	SurfaceSpec surface{};
	bool crinkle = false;                 // the whole cells that are cut
	std::optional<int> vanes;             // of a paddlewheel, 1 to kMaxSheets
	std::vector<double> offsets;          // of a stack, along the normal
	std::optional<int> sheets;            // of a stack: so many, spread evenly over the bounds
	std::optional<mesh::Corners> corners; // none: keep
	std::string array;                    // that is shown, "[point:|cell:]NAME"; empty: the first there is
	std::optional<int> component;         // from 0, or grid::kMagnitude; none: the magnitude of a vector
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

/// What belongs to the machine, and is none of a state file.
struct MachineSpec
{
	Classify classify = Classify::automatic;
	std::string device;                        // a part of its name, or its number; empty: the best
	int threads = 0;                           // at most; 0: one a core
	std::optional<find::Strategy> strategy{};  // none: the plan's own choice
	std::optional<find::VisitedSet> visited{}; // given, cells are found by generations

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
	generation // when the traversal met a polygon's cell
};

enum class RangeOf : std::uint8_t
{
	data, // the whole array
	slice // what the sheets show
};

enum class AxesStyle : std::uint8_t
{
	corner, // where x, y and z point
	box,    // numbers along edges of the bounds
	none
};

/// How what is launched looks.
struct VectorLookSpec
{
	std::string color;           // an array's name, or a color; empty: the vector's length
	std::string colormap;        // as LookSpec::colormap; empty: that of the sheets for their array, else another
	std::optional<double> width; // in the grid's units, above 0; none: a share of the lattice's spacing
	double opacity = 1.0;        // 0 to 1

	bool operator==(const VectorLookSpec&) const = default;
};

/// Surfaces that grow from the sheets.
struct ContourSpec
{
	std::vector<double> values;                  // of every sheet
	std::optional<std::pair<double, double>> at; // U and V on the first sheet, whose value there is taken
	double depth = 0.0;                          // of the box, in the grid's units; 0: it follows from the window
	double opacity = 1.0;                        // 0 to 1

	bool isGiven() const { return !values.empty() || at; }
	bool operator==(const ContourSpec&) const = default;
};

/// How it looks.
struct LookSpec
{
	PictureSize size{};
	int samples = 8;                  // a pixel, 1 to render::kMaxSamples
	std::string colormap = "viridis"; // a name, or FILE.json[:PRESET]; with _r behind it reversed
	ColorBy color_by = ColorBy::array;
	std::optional<std::pair<double, double>> range; // of the colors, lower below higher
	RangeOf range_of = RangeOf::data;
	bool symmetric = false; // the ends of the colors lie alike about 0
	bool logarithmic = false;
	double opacity = 1.0; // 0 to 1, of every sheet
	int lines = 0;        // about so many contour lines, 0 to render::kMaxLevels
	int bands = 0;        // about so many bounds between bands
	bool mesh = false;    // the edges of polygons
	bool lit = false;
	render::Background background{};
	render::CameraChoice camera{};
	render::Outline outline = render::Outline::box;
	std::vector<ContextSpec> context{}; // drawn around the sheets
	AxesStyle axes = AxesStyle::corner;
	bool no_legend = false;
	bool no_labels = false;
	std::string units{};                // of the array; empty: the file's
	std::string length_units{};         // of the coordinates; empty: the file's
	std::optional<std::string> title{}; // none: the input's name
	VectorLookSpec vectors{};
	ContourSpec contour{};

	bool operator==(const LookSpec&) const = default;
};

/// How a probe is swept.
struct SweepSpec
{
	std::optional<probe::Path> own{}; // goes before `kind`
	probe::PathKind kind = probe::PathKind::translate;
	bool over_times = false; // the probe stands still, and the input's times go by
	std::optional<int> frames{};
	double frames_per_second = 25.0; // above 0
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
