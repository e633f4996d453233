#pragma once

#include "verify/verdict.h"

#include <string>
#include <vector>

namespace vp::app
{

// Returns a page that shows all judgments, and for each difference the expected picture, the drawn one and where they
// differ, or the figures that moved. It is one file that needs nothing else.
std::string reportPage(const std::vector<Judgment>& judgments);

} // namespace vp::app
