#pragma once

#include <random>

namespace vp::render::test
{

inline double uniform(std::mt19937& random, double from, double to)
{
	return std::uniform_real_distribution<double>(from, to)(random);
}

} // namespace vp::render::test
