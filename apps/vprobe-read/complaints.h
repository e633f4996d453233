#pragma once

// VTK's readers report trouble through the output window and often go on with whatever they have. From installing on,
// what they say is kept, so that an input that raised an error is refused instead of shown as garbage.
void installComplaints();

// Takes warnings for errors as well.
void takeWarningsToo();

// Throws a Refusal if there was an error.
void refuseOnComplaint();
