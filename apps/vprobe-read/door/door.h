#pragma once

#include "base/sanitized.h"

#include <string>
#include <vector>

namespace vp::reader::door
{

// The sandbox of the reader, which it closes around itself: what follows can do no more than read the files that are
// named here, whatever a damaged file makes of it. Nothing of this touches the parent.

// Everything that stays possible behind the door.
struct Opening
{
	std::vector<std::string> read{}; // files, and folders with all below them; those that are missing are left out
	std::string write{};             // a folder in which files may be made; mostly empty
	std::string execute{};           // the one program that this one may become; may be empty
};

// Says how far the system could do that.
struct Hold
{
	int landlock = 0; // version; 0 where the system has none, or does not permit it
	bool seccomp = false;
	unsigned threads = 1; // when the door closed; only one of them is held
};

// As users read it: "landlock 7, seccomp", or "nothing".
std::string holdText(const Hold& hold);

// Call it while there is one thread, and before the first byte of the input is read.
Hold closeDoor(const Opening& opening);

// From now on, this process can become no other program. Does nothing where no door was closed.
void refuseExec();

// Sanitizers start another program for the names in their reports, and look at the process itself. So in such a build
// the door leaves processes and programs alone, and lets /proc and the system be read.
using vp::kSanitized;

} // namespace vp::reader::door
