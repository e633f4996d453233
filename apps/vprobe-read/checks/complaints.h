#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::checks
{

// VTK's readers report trouble through the output window, and often continue with whatever they have. After this call,
// the messages are kept. An error means that values may be missing or made up, so the input is refused. A warning is
// only reported, unless it is one of those that lose values.
void installComplaints();

// Throws a Refusal if there was an error, in our own words, or std::bad_alloc if memory ran out.
void refuseOnComplaint();

bool hasComplaint();

// Returns true if a warning with these words was kept.
bool wasNoted(std::string_view words);

// Returns the warnings: each once, shortened, and a line that counts those that were left out.
std::vector<std::string> takeNotes();

} // namespace vp::reader::checks
