#pragma once

#include "random.h"

#include <string>

namespace fuzz
{

// Damages the contents of a file in one to three ways, as disks, transfers, editors and ill will do: cut short, bits
// flipped, bytes and numbers overwritten with extreme values, stretches moved, doubled or lost. Half of all places lie
// in the first bytes, where headers are. Gives what was done, for the report.
std::string damage(std::string& contents, Random& random);

} // namespace fuzz
