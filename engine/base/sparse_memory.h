#pragma once

#include <cstddef>

namespace vp
{

// Zeroed memory, of which only those pages take room that somebody has written to.
class SparseMemory
{
public:
	// Throws std::bad_alloc if the system has no addresses left.
	explicit SparseMemory(std::size_t bytes);
	~SparseMemory();
	SparseMemory(const SparseMemory&) = delete;
	SparseMemory& operator=(const SparseMemory&) = delete;

	std::byte* data() const { return data_; } // begins a page
	std::size_t size() const { return size_; }
	template <class T>
	T* as() const
	{
		return reinterpret_cast<T*>(data_);
	}

private:
	std::byte* data_ = nullptr;
	std::size_t size_;
};

} // namespace vp
