#pragma once

#include <string>

// VTK's readers report trouble through the output window and often go on with whatever they have. From installing on,
// what they say is kept, so that an input that raised an error is refused instead of shown as garbage.
void installComplaints();

// The first error, without VTK's file names and addresses; empty where there was none.
const std::string& firstComplaint();

// Throws a Refusal if there was an error.
void refuseOnComplaint();
