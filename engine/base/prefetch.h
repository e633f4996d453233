#pragma once

namespace vp
{

/// Asks for the memory at an address ahead of its use. Any address does no harm.
inline void prefetch(const void* at)
{
	__builtin_prefetch(at);
	// GCC takes a function that only prefetches for one without effect, and deletes its calls. This has no
	// instructions, but counts as an effect.
	asm volatile("");
}

} // namespace vp
