#pragma once

#include "base/result.h"

#include <nlohmann/json.hpp>

#include <string>

namespace vp::app
{

// Reads a file that `vprobe profile --json` wrote. An input error names the file and what is wrong with it.
Result<nlohmann::json> readProfile(const std::string& file);

// Lists the differences between two profiles, largest first: both values of each figure and their ratio. Marks
// differences that may be chance, and says where the profiles measured different work. file_a and file_b are the names
// of the files.
std::string compareProfiles(const nlohmann::json& a, const nlohmann::json& b, const std::string& file_a,
                            const std::string& file_b);

} // namespace vp::app
