#pragma once

#include <string>

namespace vp::write
{

// A name as it may stand between the quotes of an XML attribute, which VTK 9.1 does not see to: what XML gives a
// meaning to is escaped, what it does not allow is replaced.
std::string xmlText(const std::string& name);

} // namespace vp::write
