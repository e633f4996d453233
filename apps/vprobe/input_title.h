#pragma once

#include <string>
#include <vector>

namespace vp::app
{

// What inputs are called in a word: the first one's name without its folder; empty without inputs.
std::string inputTitle(const std::vector<std::string>& inputs);

} // namespace vp::app
