#include "base/sparse_memory.h"

#include <new>

#include <sys/mman.h>

namespace vp
{

SparseMemory::SparseMemory(std::size_t bytes) : size_(bytes)
{
	if (bytes == 0)
		return;
	void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
	if (memory == MAP_FAILED)
		throw std::bad_alloc();
	data_ = static_cast<std::byte*>(memory);
	// A huge page would take room for many cells beside the one that is written.
	madvise(memory, bytes, MADV_NOHUGEPAGE);
}

SparseMemory::~SparseMemory()
{
	if (data_)
		munmap(data_, size_);
}

} // namespace vp
