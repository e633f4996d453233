#pragma once

#include "base/result.h"
#include "probe/path.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace vp::probe
{

// A sweep's path as JSON. docs/PROBES.md explains the file, docs/path.schema.json describes it to programs. Anything
// else is an input error: one line with the file, the place in it (a JSON pointer) and the remedy.

std::string_view nameOf(PathKind kind); // "translate", as on the command line
std::optional<PathKind> pathKind(std::string_view name);

Result<Path> readPath(const std::string& file);
Result<Path> parsePath(std::string_view text, const std::string& source);

// Reads a path inside a larger document. `path` is the pointer to it, for errors.
Result<Path> pathFromJson(const nlohmann::json& value, const std::string& source, const std::string& path);

// Writes a path. Reading it gives the same path to the last bit.
nlohmann::json toJson(const Path& path);
std::string pathText(const Path& path);

} // namespace vp::probe
