#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vp::reader
{

// Sends bytes to the parent. Ends the process if it is gone.
void sendToParent(std::string_view bytes);

// Asks the parent which parts of a pack it wants (protocol.h). about: JSON that describes the whole. boxes: of the
// parts, lo and hi. Returns the numbers of the parts in ascending order, or nothing if it wants all. Throws a Refusal
// if it asks for parts that there are not.
std::optional<std::vector<std::uint64_t>> askForParts(std::string_view about,
                                                      std::span<const std::array<double, 6>> boxes);

} // namespace vp::reader
