#pragma once

#include "sample_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// The name of a test of the n-th of sampleFiles().
inline std::string nameOfSample(const testing::TestParamInfo<std::size_t>& info)
{
	std::string name = sampleFiles()[info.param].name;
	std::replace(name.begin(), name.end(), '.', '_');
	return name;
}
