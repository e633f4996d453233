#pragma once

#include <string>

namespace vp::write
{

// Returns a name for use between the quotes of an XML attribute, which VTK 9.1 does not do. Characters with a meaning
// in XML are escaped, and characters that XML forbids are replaced.
std::string xmlText(const std::string& name);

} // namespace vp::write
