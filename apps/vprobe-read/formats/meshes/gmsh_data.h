#pragma once

#include "gmsh_mesh.h"
#include "gmsh_section.h"

#include <optional>
#include <vector>

namespace vp::reader::meshes
{

// Reads $NodeData or $ElementData behind its name. Their tags are text in binary files too.
GmshData readGmshData(text::Cursor& at, GmshSection& section, bool of_nodes);

// The times of all steps. Steps that all have one time are numbered instead.
std::vector<double> gmshTimes(std::vector<GmshData>& all);

// The views at a time: of each name the latest step that is not after it, or else its first one. A step that is written
// in pieces, as of partitions, is one. `is_before` is set for
// those that begin later. Views of one name are told apart by a number behind it.
struct GmshView
{
	GmshData data;
	bool is_before = false;
};
std::vector<GmshView> gmshViewsAt(std::vector<GmshData> all, std::optional<double> time);

} // namespace vp::reader::meshes
