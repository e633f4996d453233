#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace vp
{

// resize() does not initialize new elements. Use it for arrays that several threads fill.
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
