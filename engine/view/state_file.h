#pragma once

#include "view/view_spec.h"

#include <string>
#include <string_view>

namespace vp::view
{

// Returns everything that a user set, except settings of the machine, as versioned JSON. docs/PROBES.md explains the
// file; state_schema.h describes it for programs.

constexpr int kStateVersion = 1;

/// Names of files are relative to the folder of `file`. Reading the text gives the same ViewSpec, to the last bit.
std::string stateText(const ViewSpec& spec, const std::string& file);

/// Replaces the settings in `spec` that the text contains; the others stay. Unknown keys, other versions and impossible
/// values are an input error, which names the file, the place in it (a JSON pointer) and the remedy. After an error
/// `spec` is unchanged.
Status readState(ViewSpec& spec, std::string_view text, const std::string& file);

/// The same with files. A file is written whole or not at all; a failure is an output error.
Status saveState(const ViewSpec& spec, const std::string& file);
Status loadState(ViewSpec& spec, const std::string& file);

} // namespace vp::view
