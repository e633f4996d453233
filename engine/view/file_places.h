#pragma once

#include <string>

namespace vp::view
{

// Returns the name of an input as a state file keeps it: relative to the folder of the state. Links in folders are
// followed; if the input itself is a link, it keeps its name. demo:NAME does not change.
std::string relativeTo(const std::string& state, const std::string& input);

// The reverse: returns the name as seen from the working folder.
std::string fromState(const std::string& state, const std::string& input);

} // namespace vp::view
