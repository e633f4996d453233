#pragma once

#include <string>

namespace vp::write
{

// Files and folders that are not finished have names of their own, which say whose they are: the machine's, the
// process's. The process holds a lock on each (flock). So the next run can tell what a run left that was killed.

// Returns a new name in a folder.
std::string newHeldName(const std::string& folder);

// Takes the lock of a file or folder that was just made under such a name. Returns false if another run has removed it
// meanwhile; then make another one. The lock goes when the descriptor is closed.
bool holdName(int descriptor);

// Removes what runs of this user on this machine left in a folder, if nobody holds it. Once a process for each folder.
void removeLeftovers(const std::string& folder);

} // namespace vp::write
