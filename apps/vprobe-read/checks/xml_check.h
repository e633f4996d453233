#pragma once

#include <string>

namespace vp::reader::checks
{

// Throws a Refusal if a VTK XML file, or a piece that it names, was cut short, or if an appended array runs past its
// end. In these cases VTK's readers return uninitialized memory.
void refuseShortXml(const std::string& file);

// Throws a Refusal if elements are nested too deeply (nesting.h). VTK's parser would take kilobytes for each of them.
// refuseShortXml() does the same.
void refuseDeepXml(const std::string& file);

} // namespace vp::reader::checks
