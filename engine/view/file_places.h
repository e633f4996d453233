#pragma once

#include <string>

namespace vp::view
{

// The name of an input as the state beside it keeps it: relative to the state's folder. Links in folders are followed,
// a link that is the input itself keeps its name. demo:NAME stays as it is.
std::string relativeTo(const std::string& state, const std::string& input);

// And back: as seen from the working folder.
std::string fromState(const std::string& state, const std::string& input);

} // namespace vp::view
