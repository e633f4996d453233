#pragma once

#include "tecplot_file.h"
#include "tecplot_lexer.h"

#include <map>
#include <optional>
#include <vector>

namespace vp::reader::meshes
{

// How the values and elements of a zone are written.
struct TecplotZoneHead
{
	TecplotZone zone;
	bool in_blocks = false;   // variable by variable
	bool is_counted = false;  // its sizes are not written: it has as many points as values follow
	bool names_nodes = false; // it has a number of nodes
	std::vector<bool> passive;
	std::map<std::size_t, std::size_t> shared; // variable to zone
	std::optional<std::size_t> shared_corners; // zone
	bool has_neighbors = false;                // lists of neighbors follow its elements
	// The sizes of the lists of polygons and polyhedra.
	std::size_t faces = 0;
	std::optional<std::size_t> face_corners;
	bool has_outer_neighbors = false; // elements of other zones behind its faces
};

// Whether a word begins a record of a file.
bool isTecplotRecord(std::string_view word);

// Reads the text behind the word ZONE, up to the values. `file` has the zones before it.
TecplotZoneHead readTecplotZoneHead(TecplotLexer& at, const TecplotFile& file);

} // namespace vp::reader::meshes
