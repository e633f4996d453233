#pragma once

#include <string>

// Throws a Refusal where a VTK XML file, or a piece it names, was cut short, or where an appended array runs past its
// end: VTK's readers then leave what happens to be in memory.
void refuseShortXml(const std::string& file);
