#pragma once

#include "grid/field.h"
#include "parts/file_extents.h"
#include "read/manifest.h"
#include "read/mapping.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>

namespace vp::read
{

// The files that a child could read.
struct ReadableFiles
{
	std::string input;
	std::string follow;    // as followArgument() gives it
	std::string indexed{}; // the file whose index the input is; mostly empty
};

// Opens a file in which data stay. Throws Unusable if the child could not read it, and parts::Unreadable if it cannot
// be opened.
std::shared_ptr<const parts::OpenFile> openedFile(const std::string& name, const ReadableFiles& files);

// Returns the array of a lattice that stays in its file, whose place the manifest describes (protocol.h). Checks that
// all of its parts lie within the file, which must be one of `files`. Throws
// Unusable, and parts::Unreadable if the file cannot be opened.
std::shared_ptr<const parts::PartStore> storedArray(const nlohmann::json& place, const grid::Field& field,
                                                    const decltype(CheckedBlock::mesh)& mesh, const SharedBytes& arrays,
                                                    const ReadableFiles& files);

} // namespace vp::read
