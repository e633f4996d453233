#pragma once

#include <random>
#include <string>

namespace vp::test
{

// The text of a random expression with all that the grammar has, over some 2^depth operands. Each operation stands in
// parentheses where `bare` is false, else as often without.
std::string randomExpression(std::mt19937& random, int depth, bool bare = true);

} // namespace vp::test
