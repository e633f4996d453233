#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <string>
#include <vector>

namespace vp::app
{

struct ContextKind;

// What is drawn around the sheets, one --context: KIND[=ARGUMENT][:OPACITY].
struct ContextChoice
{
	const ContextKind* kind;
	std::string argument; // empty for a kind that takes none
	double opacity;
	std::string word; // as the user gave it, for errors
};

// A new kind of context is one entry of kKinds in context_options.cpp.
struct ContextKind
{
	const char* name;
	const char* argument; // what stands behind = in the help, as "N"; null: takes none
	double opacity;       // where the user says none
	// Polygons in world coordinates. An error names the argument and the remedy.
	Result<mesh::SheetMesh> (*mesh)(const grid::BlockSet& blocks, const ContextChoice& choice);
};

// For the help: boundary[:OPACITY], ...
std::string contextForms();

// In the order they were given. What is wrong with a word is a usage error.
Result<std::vector<ContextChoice>> parseContexts(const std::vector<std::string>& words);

// Whether one is a patch, for which the input's are to be read.
bool namesPatch(const std::vector<ContextChoice>& choices);

} // namespace vp::app
