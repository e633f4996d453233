#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace vp
{

// Memory in huge pages, if the system gives them. Reads all over an array of gigabytes then find their page without a
// walk through the page tables. resize() does not initialize new elements, as in a RawVector.
template <class T>
struct HugeAllocator
{
	using value_type = T;

	HugeAllocator() = default;
	template <class U>
	HugeAllocator(const HugeAllocator<U>&) noexcept
	{
	}

	static constexpr std::size_t kPage = std::size_t(1) << 21;

	// Small arrays are not worth a page.
	static std::align_val_t alignment(std::size_t bytes) { return std::align_val_t(bytes < kPage ? 64 : kPage); }

	T* allocate(std::size_t count)
	{
		const std::size_t bytes = count * sizeof(T);
		void* memory = ::operator new(bytes, alignment(bytes));
#ifdef __linux__
		if (bytes >= kPage)
			madvise(memory, bytes, MADV_HUGEPAGE); // if it is refused, small pages work too
#endif
		return static_cast<T*>(memory);
	}
	void deallocate(T* memory, std::size_t count) noexcept
	{
		::operator delete(memory, alignment(count * sizeof(T)));
	}

	template <class U>
	void construct(U* at) noexcept
	{
		::new (static_cast<void*>(at)) U;
	}
	template <class U, class... Args>
	void construct(U* at, Args&&... args)
	{
		::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
	}

	bool operator==(const HugeAllocator&) const = default;
};

template <class T>
using HugeVector = std::vector<T, HugeAllocator<T>>;

} // namespace vp
