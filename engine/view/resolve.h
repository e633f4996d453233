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

/// The particles that start on the sheets, resolved.
struct LaunchChoice
{
	grid::FieldChoice array; // the array that moves the particles
	TraceKind kind = TraceKind::tufts;
	vectors::LatticeChoice lattice;
	double steps = 1.0;
	std::optional<double> dt; // time of a step; if empty, it follows from the fastest vector and `spacing`
	double spacing = 1.0;     // approximate distance of the lattice's points in the grid's units; widths follow from it
	vectors::Direction direction = vectors::Direction::forward;
	vectors::VectorPart part = vectors::VectorPart::whole;
	bool path_lines = false;
};

/// A ViewSpec applied to a data set: every name has been looked up, and everything has its place.
struct ResolvedView
{
	std::optional<grid::FieldChoice> field;
	probe::Probe probe; // without its hidden sheets
	std::vector<std::optional<grid::FieldChoice>> sheet_fields;
	mesh::Corners corners = mesh::Corners::keep;
	mesh::Hanging hanging = mesh::Hanging::keep;
	seed::SeedOptions seeds;
	SurfaceSpec surface; // the surface that replaces the sheets, or planes; the sheets hold any other surface
	bool crinkle = false;
	std::optional<find::Threshold> threshold;
	std::optional<grid::FieldChoice> vector_array; // filled if the settings ask for it or need it
	std::optional<LaunchChoice> launch;
	read::TimeChoice time;
};

/// Applies the settings to a data set: looks up the arrays, and builds the probe in the bounds. The spec must pass
/// validate(). Returns an input error if the data set lacks something, and a usage error if a setting is impossible for
/// it.
Result<ResolvedView> resolve(const ViewSpec& spec, const grid::BlockSet& blocks);

/// Builds the probe in the bounds, hidden sheets included. The spec must pass validate().
probe::Probe makeProbe(const ProbeSpec& spec, const Box& bounds);

/// Takes the place of a probe: where it is, its window, and its sheets. Everything else stays.
void takePlace(ProbeSpec& spec, const ProbeSpec& from);

/// Returns the surface that replaces the sheets, at a place in its range from 0 to 1. Returns nothing if there are
/// sheets.
std::optional<find::ListedSurface> listedSurface(const SurfaceSpec& surface, double done);

/// A LookSpec with its color maps read.
struct ResolvedLook
{
	LookSpec spec;
	render::Look look;                             // what is drawn of it without a further choice
	std::optional<render::ColorMap> vector_colors; // the map of the particles; if empty, see VectorLookSpec
	bool captions = true;                          // show the place of the first sheet
	bool window_rims = true;                       // draw lines around windows

	bool byGeneration() const { return spec.color_by == ColorBy::generation; }
};

/// Resolves the look, which needs no data set, so it can run before a large file is read. Reads color maps; a file that
/// is not a color map is an input error. The spec must pass validate().
Result<ResolvedLook> resolveLook(const ViewSpec& spec);

/// Returns the path of a sweep.
probe::Path pathOf(const SweepSpec& sweep);

/// Returns the frames per second of the settings, else 25, or 2 over the input's times.
double framesPerSecond(const SweepSpec& sweep);
/// Returns the frames per second of a film of so many frames.
double filmSpeed(const SweepSpec& sweep, int frames);

/// Returns the number of frames that the spec or the path gives, or a usage error if neither does. Returns 0 for a
/// sweep over the input's times.
Result<int> frameCount(const SweepSpec& sweep);

} // namespace vp::view
