#pragma once

#include <gtest/gtest.h>

#include <string>

namespace cli
{

/// Whether two PNG files show the same: at most 2 of 255 apart in 99.9 % of their pixels. The bytes of pictures with
/// several samples may differ a little where samples are summed in another way.
testing::AssertionResult areSimilar(const std::string& path, const std::string& other_path);

} // namespace cli
