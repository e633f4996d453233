#pragma once

#include <cstddef>
#include <string>

// Trees on a lattice of 3 x 2 x 4 unit cells, split at random down to three levels. Returns the number of leaves.
std::size_t writeTrees(const std::string& path);
