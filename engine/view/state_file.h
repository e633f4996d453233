#pragma once

#include "view/view_spec.h"

#include <string>
#include <string_view>

namespace vp::view
{

// Everything that a user set but what belongs to the machine, as JSON of a known version. docs/PROBES.md explains the
// file, docs/state.schema.json describes it to programs.

constexpr int kStateVersion = 1;

/// Names of files stand in the text as they are seen from the folder of `file`. Read again it is the same ViewSpec, to
/// the last bit.
std::string stateText(const ViewSpec& spec, const std::string& file);

/// The settings that the text has take the place of those in `spec`; the others stay. An input error names the file,
/// where in it (a JSON pointer) and the remedy; unknown keys, other versions and values that a setting cannot have are
/// such, and `spec` stays as it was.
Status readState(ViewSpec& spec, std::string_view text, const std::string& file);

/// The same with files. A file is written whole or not at all; an output error else.
Status saveState(const ViewSpec& spec, const std::string& file);
Status loadState(ViewSpec& spec, const std::string& file);

} // namespace vp::view
