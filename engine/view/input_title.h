#pragma once

#include <string>
#include <vector>

namespace vp::view
{

// What inputs are called in a word: the first one's name without its folder; empty without inputs.
std::string inputTitle(const std::vector<std::string>& inputs);

} // namespace vp::view
