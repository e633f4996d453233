#pragma once

#include <cstdlib> // which defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace vp
{

/// Tells the C library to keep up to 256 MiB of freed memory. A program calls it once, when it starts; a library leaves
/// that to the program. A mesh is freed and made again for every cut, and a software device does the same with some
/// megabytes for every draw. The C library gives such memory back to the system, or keeps it, as its thresholds happen
/// to stand. If it goes back, each page is cleared and mapped again. That can take longer than the cut, and ten times
/// as long as the draw.
inline void keepFreedMemory()
{
#ifdef __GLIBC__
	mallopt(M_MMAP_THRESHOLD, 32 << 20); // the largest that is allowed
	mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

} // namespace vp
