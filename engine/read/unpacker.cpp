#include "read/unpacker.h"

#include "parts/source.h"
#include "read/input_limits.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <vector>

#include <sys/socket.h>
#include <unistd.h>

namespace vp::read
{

namespace
{

// More than this is given back to the system after each call.
constexpr std::size_t kKeptBytes = std::size_t(16) << 20;

// The child may change this memory at any time, so it is read, never mapped: where it is too short, this fails.
bool readWhole(const Descriptor& memory, std::size_t at, std::span<std::byte> bytes)
{
	std::size_t done = 0;
	while (done < bytes.size())
	{
		const ssize_t count =
		    pread(memory.get(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(at + done));
		if (count == 0 || (count < 0 && errno != EINTR))
			return false;
		done += count > 0 ? static_cast<std::size_t>(count) : 0;
	}
	return true;
}

} // namespace

Unpacker::Unpacker(std::string file, std::string format, std::size_t part_bytes, const std::string& how)
    : file_(std::move(file))
{
	options_.format = std::move(format);
	options_.unpack = fmt::format("{} {}", part_bytes, how);
}

Status Unpacker::start()
{
	Result<RequestEnds> ends = requestEnds(file_);
	if (!ends)
		return ends.error();
	requests_ = std::move(ends->own);
	Result<ReaderAtWork> started = ReaderAtWork::start(file_, options_, limitsWithoutFile(), ends->childs);
	if (!started)
		return started.error();
	child_.emplace(std::move(*started));
	owner_ = getpid();
	return Nothing{};
}

Status Unpacker::ask(std::span<const Part> parts)
{
	std::vector<std::array<std::uint64_t, 3>> list;
	for (const Part& part : parts)
		list.push_back(part.told);
	if (!writeWhole(child_->cells(), std::as_bytes(std::span(list))))
		return Error{ErrorKind::out_of_memory,
		             fmt::format("{}: there is no memory for the list of its parts; make room", file_)};
	const std::uint64_t count = list.size();
	send(requests_.get(), &count, sizeof(count), MSG_NOSIGNAL); // to a child that has ended: the answer tells
	std::uint64_t unpacked = 0;
	if (Status answered = child_->answer(std::as_writable_bytes(std::span(&unpacked, 1))); !answered)
		return answered;
	std::size_t at = 0;
	for (const Part& part : parts)
	{
		if (unpacked != count || !readWhole(child_->arrays(), at, part.to))
			return Error{ErrorKind::input,
			             fmt::format("{}: the reader unpacked fewer parts than were asked for", file_)};
		at += part.to.size();
	}
	if (at > kKeptBytes && ftruncate(child_->arrays().get(), 0) != 0)
		return Error{ErrorKind::internal, fmt::format("{}: its memory cannot be given back", file_)};
	return Nothing{};
}

void Unpacker::unpack(std::span<const Part> parts)
{
	const std::lock_guard lock(mutex_);
	if (child_ && owner_ != getpid())
		child_.reset();
	for (;;)
	{
		const bool was_there = child_.has_value();
		Status done = was_there ? Nothing{} : start();
		if (done)
			done = ask(parts);
		if (done)
			return;
		child_.reset();
		if (!was_there)
			throw parts::Unreadable(done.error().message);
	}
}

} // namespace vp::read
