#pragma once

#include "base/result.h"

#include <nlohmann/json.hpp>

#include <string>

namespace vp::app
{

// What `vprobe profile --json` wrote; an input error names the file and what is wrong with it.
Result<nlohmann::json> readProfile(const std::string& file);

// What differs between two profiles, largest first: both values of each figure and their ratio. Differences that chance
// explains are marked; so is where the two are not of the same work. file_a, file_b: their names.
std::string compareProfiles(const nlohmann::json& a, const nlohmann::json& b, const std::string& file_a,
                            const std::string& file_b);

} // namespace vp::app
