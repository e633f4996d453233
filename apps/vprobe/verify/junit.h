#pragma once

#include "verify/verdict.h"

#include <string>
#include <vector>

namespace vp::app
{

// Returns a JUnit file with one test case a judgment, as CI servers show it. A file that was updated counts as passed.
// The format is that of Apache Ant's task and Jenkins' xUnit plugin; python3-junitparser reads it.
std::string junitText(const std::vector<Judgment>& judgments);

} // namespace vp::app
