#pragma once

#include <string>

namespace vp::write
{

// Wait until a file, or the names in a folder, are on the disk. Return errno, or 0. A file system that cannot do that
// counts as done.
int flushFile(int descriptor);
int flushFileOrFolder(const std::string& path);

} // namespace vp::write
