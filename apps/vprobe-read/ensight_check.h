#pragma once

#include <optional>
#include <string>

// Throws a Refusal where a file of an EnSight Gold case, text or C binary, ends early at the given time: VTK's readers
// repeat the last value they saw, or go without. What is not understood (Fortran records, several times in a file,
// partial arrays) is taken as it is. Returns whether a text file ends inside a line.
bool refuseShortEnSight(const std::string& case_file, std::optional<double> time);
