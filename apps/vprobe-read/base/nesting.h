#pragma once

namespace vp::reader
{

// No writer of data nests elements of XML or JSON more deeply. Libraries keep each of them in memory.
constexpr int kMaxNestedElements = 256;

} // namespace vp::reader
