#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace vp
{

// Leaves what resize() adds uninitialized, for what is filled by several threads at once.
template <class T>
struct RawAllocator : std::allocator<T>
{
	template <class U>
	struct rebind
	{
		using other = RawAllocator<U>;
	};
	template <class U>
	void construct(U* at) noexcept
	{
		::new (static_cast<void*>(at)) U;
	}
	template <class U, class... Args>
	void construct(U* at, Args&&... args)
	{
		std::construct_at(at, std::forward<Args>(args)...);
	}
};

template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

} // namespace vp
