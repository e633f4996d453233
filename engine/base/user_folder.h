#pragma once

#include <filesystem>

namespace vp
{

/// Returns this program's folder in one of the user's base directories, as the XDG specification has them; empty if the
/// user has none. variable: names the directory, as XDG_CACHE_HOME does. usual: its place below the home folder if the
/// variable is not set.
std::filesystem::path userFolder(const char* variable, const char* usual);

/// Creates the folder if it does not exist. Returns an empty path if that fails.
std::filesystem::path madeFolder(const std::filesystem::path& wanted);

} // namespace vp
