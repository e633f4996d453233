#pragma once

#include <string>
#include <string_view>
#include <vector>

// VTK's readers report trouble through the output window and often go on with whatever they have. From installing on,
// what they say is kept. An error means that values may be missing or made up, so the input is refused. A warning is
// only told, unless it is one of those that lose values.
void installComplaints();

// Throws a Refusal if there was an error, in our own words, or std::bad_alloc if memory ran out.
void refuseOnComplaint();

bool hasComplaint();

// Whether a warning with these words was kept.
bool wasNoted(std::string_view words);

// What was said that is no error: each once, shortened, and a line that counts the rest of them.
std::vector<std::string> takeNotes();
