#pragma once

#include <string>
#include <vector>

namespace vp::view
{

// Returns a short title for inputs: the name of the first one without its folder. Empty without inputs.
std::string inputTitle(const std::vector<std::string>& inputs);

} // namespace vp::view
