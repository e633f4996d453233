#pragma once

#include "base/ids.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vp::grid
{

// Faces that three or more cells have, each as its slots (see FaceSlots). Links them in the order of their lowest
// slots, so that `several` does not depend on which thread found what. across(slot): what is to name the others.
void linkCrowds(std::vector<std::vector<std::uint32_t>> crowds, const std::function<CellId(std::uint32_t)>& cellOf,
                const std::function<std::uint32_t&(std::uint32_t)>& across, std::vector<std::vector<CellId>>& several);

} // namespace vp::grid
