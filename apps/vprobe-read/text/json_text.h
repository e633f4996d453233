#pragma once

#include <nlohmann/json.hpp>

#include <string_view>

// Parses a text. The result is_discarded() if it is no JSON. Throws a Refusal for elements that are nested too deeply
// (nesting.h).
nlohmann::json parseJson(std::string_view text);
