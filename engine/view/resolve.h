#pragma once

#include "find/listed.h"
#include "grid/field_choice.h"
#include "probe/path.h"
#include "render/color/color_map.h"
#include "render/scene/look.h"
#include "vectors/lattice.h"
#include "view/view_spec.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::view
{

/// What is launched from the sheets.
struct LaunchChoice
{
	grid::FieldChoice array; // that moves the particles
	TraceKind kind = TraceKind::tufts;
	vectors::LatticeChoice lattice;
	double steps = 1.0;
	std::optional<double> dt; // of a step; none: it follows from the fastest vector and `spacing`
	double spacing = 1.0;     // about how far the lattice's points are apart, in the grid's units: for widths
	vectors::Direction direction = vectors::Direction::forward;
	vectors::VectorPart part = vectors::VectorPart::whole;
	bool path_lines = false;
};

/// What a ViewSpec comes to in a data set: everything is found and placed, and no word is left to be looked up.
struct ResolvedView
{
	std::optional<grid::FieldChoice> field;
	probe::Probe probe; // without its hidden sheets
	std::vector<std::optional<grid::FieldChoice>> sheet_fields;
	mesh::Corners corners = mesh::Corners::keep;
	seed::SeedOptions seeds;
	SurfaceSpec surface; // where it replaces the sheets, else planes: what cuts is in the sheets
	bool crinkle = false;
	std::optional<find::Threshold> threshold;
	std::optional<grid::FieldChoice> vector_array; // where one is asked for, or needed
	std::optional<LaunchChoice> launch;
	read::TimeChoice time;
};

/// Places what the settings say in a data set: arrays are looked up, the probe is built in the bounds. The spec passes
/// validate(). An input error where the data set has not what is asked for, a usage error where that cannot be.
Result<ResolvedView> resolve(const ViewSpec& spec, const grid::BlockSet& blocks);

/// The probe where the settings put it in the bounds, hidden sheets included. The spec passes validate().
probe::Probe makeProbe(const ProbeSpec& spec, const Box& bounds);

/// The surface that replaces the sheets, so much of its way along, 0 to 1; none where there are sheets.
std::optional<find::ListedSurface> listedSurface(const SurfaceSpec& surface, double done);

/// How particles look, the color map read.
struct ResolvedVectorLook
{
	std::string color;                      // as VectorLookSpec has it
	std::optional<render::ColorMap> colors; // else see VectorLookSpec
	std::optional<double> width;
	double opacity = 1.0;
};

/// A LookSpec, its color maps read.
struct ResolvedLook
{
	render::Look look;
	render::CameraChoice camera;
	std::vector<ContextSpec> context;
	ContourSpec contour;
	double opacity = 1.0;        // of every sheet
	bool range_of_slice = false; // without a range: the colors' ends are those of what the sheets show
	bool symmetric = false;      // and lie alike about 0
	bool by_generation = false;  // colors tell when the traversal met a cell, instead of the array
	std::string units;           // of the array, told behind its name
	bool captions = true;        // where the first sheet is
	bool window_rims = true;     // lines around windows
	ResolvedVectorLook vectors;
};

/// Needs no data set, so it can be done before a large file is read. Reads color maps: an input error where a file does
/// not serve. The spec passes validate().
Result<ResolvedLook> resolveLook(const ViewSpec& spec);

/// The path of a sweep.
probe::Path pathOf(const SweepSpec& sweep);

/// How many frames the spec or the path says; a usage error where neither does. 0 over the input's times.
Result<int> frameCount(const SweepSpec& sweep);

} // namespace vp::view
