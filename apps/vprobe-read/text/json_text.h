#pragma once

#include <nlohmann/json.hpp>

#include <string_view>

namespace vp::reader::text
{

// Parses a text. The result is_discarded() if it is no JSON. Throws a Refusal for elements that are nested too deeply
// (nesting.h).
nlohmann::json parseJson(std::string_view text);

} // namespace vp::reader::text
