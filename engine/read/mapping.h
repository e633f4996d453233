#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace vp::read
{

// Bytes that nobody will change, and what keeps them there.
struct SharedBytes
{
	std::shared_ptr<const void> owner;
	std::span<const std::byte> bytes;
};

// A file descriptor that is closed with its holder.
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

// Maps all of a memfd, after sealing it against any change. No owner if that fails; an empty one has an owner and no
// bytes.
SharedBytes mapSealed(const Descriptor& memory);

} // namespace vp::read
