#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace vp::read
{

// Bytes that nobody will change, and their owner.
struct SharedBytes
{
	std::shared_ptr<const void> owner;
	std::span<const std::byte> bytes;
};

// A file descriptor that its owner closes.
class Descriptor
{
public:
	Descriptor() = default;
	explicit Descriptor(int fd) : fd_(fd) {}
	Descriptor(Descriptor&& other) noexcept : fd_(other.release()) {}
	Descriptor& operator=(Descriptor&& other) noexcept
	{
		reset(other.release());
		return *this;
	}
	~Descriptor() { reset(); }

	int get() const { return fd_; }
	explicit operator bool() const { return fd_ >= 0; }
	int release()
	{
		const int fd = fd_;
		fd_ = -1;
		return fd;
	}
	void reset(int fd = -1);

private:
	int fd_ = -1;
};

// Writes bytes at the beginning of a memfd. Returns false if there is no room.
bool writeWhole(const Descriptor& memory, std::span<const std::byte> bytes);

// Seals a memfd against any change and maps all of it. The result has no owner if that fails. An empty memfd has an
// owner and no bytes.
SharedBytes mapSealed(const Descriptor& memory);

} // namespace vp::read
