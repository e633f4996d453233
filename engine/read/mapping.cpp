#include "read/mapping.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vp::read
{

void Descriptor::reset(int fd)
{
	if (fd_ >= 0)
		close(fd_);
	fd_ = fd;
}

bool writeWhole(const Descriptor& memory, std::span<const std::byte> bytes)
{
	std::size_t done = 0;
	while (done < bytes.size())
	{
		const ssize_t count = pwrite(memory.get(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
		if (count < 0 && errno != EINTR)
			return false;
		done += count > 0 ? static_cast<std::size_t>(count) : 0;
	}
	return true;
}

SharedBytes mapSealed(const Descriptor& memory)
{
	struct stat about;
	if (fcntl(memory.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL) != 0 ||
	    fstat(memory.get(), &about) != 0)
		return {};
	const std::size_t size = static_cast<std::size_t>(about.st_size);
	if (size == 0)
		return {std::make_shared<int>(0), {}};
	// Private, because Linux before 6.7 refuses shared mappings of what is sealed against writing; nothing is copied
	// either way.
	void* at = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, memory.get(), 0);
	if (at == MAP_FAILED)
		return {};
	std::shared_ptr<const void> owner(at, [size](void* mapped) { munmap(mapped, size); });
	return {std::move(owner), {static_cast<const std::byte*>(at), size}};
}

} // namespace vp::read
