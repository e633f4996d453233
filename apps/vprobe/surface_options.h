#pragma once

#include "base/result.h"
#include "find/listed.h"
#include "grid/field_choice.h"
#include "path_options.h"
#include "probe_options.h"
#include "surface/grid_index.h"
#include "surface/implicit_surface.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace vp::app
{

// What --surface says: grid surfaces from one index to another, or patches of the boundary.
using SurfaceChoice = std::variant<surface::GridIndexRange, find::PatchName>;

// None where the option is not given, or gives a form. A usage error where it cannot be, or beside an option that
// places a plane.
Result<std::optional<SurfaceChoice>> surfaceOf(const ProbeOptions& options);

// What --surface or --iso says that the probe's sheets are to cut by in place of their planes; none where neither does.
Result<std::optional<surface::ImplicitSurface>> formOf(const ProbeOptions& options);

// Tells whether the blocks have what the forms of the sheets look at. fields: per sheet.
Status checkForms(const std::vector<probe::Sheet>& sheets, std::span<const std::optional<grid::FieldChoice>> fields);

// Whether --surface names what takes the place of the sheets, which then are not cut at all.
bool replacesSheets(const ProbeOptions& options);

// Whether it leaves nothing for a device to classify: neither what replaces sheets nor an iso value is.
bool leavesDeviceIdle(const ProbeOptions& options);

// Whether it names a patch, for which the input's are to be read.
bool namesPatch(const ProbeOptions& options);

// Tells whether the blocks have it. text: as the option was given.
Status checkSurface(const grid::BlockSet& blocks, const SurfaceChoice& choice, const std::string& text);

// done: how far along its range, 0 to 1.
find::ListedSurface surfaceAt(const SurfaceChoice& choice, double done);

// Colors by generation are of traversals, and a surface is found without: a usage error.
Status refuseGenerations(const ProbeOptions& options, bool by_generation);

// Of commands that show one surface: a usage error where a range is given.
Status requireOneSurface(const ProbeOptions& options);

// Of a sweep: a usage error where the path is none for a surface.
Status requirePathOfSurface(const ProbeOptions& options, const PathOptions& path);

} // namespace vp::app
