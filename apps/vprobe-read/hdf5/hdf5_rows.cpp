#include "hdf5_rows.h"

#include <fmt/format.h>

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace vp::reader::hdf5
{

std::mutex Rows::one_at_a_time_;

Rows::Rows(const File& file, int descriptor, std::string path, grid::NumberType type)
    : file_(file), descriptor_(descriptor), path_(std::move(path)), type_(type), sides_(file.sidesOf(path_))
{
	constexpr std::uint64_t most_components = 1 << 16;
	if (sides_.empty() || sides_.size() > 2 || components() < 1 || components() > most_components ||
	    sides_[0] > std::uint64_t(1) << 40 || !file.numberType(path_))
		throw damaged(fmt::format("{} is no list of numbers", path_));
	count_ = sides_[0];
	offset_ = file.plainOffset(path_, type_);
}

Refusal Rows::shortOfRows() const
{
	return damaged(fmt::format("{} has fewer values than are asked of it", path_));
}

void Rows::narrow(std::uint64_t first, std::uint64_t count)
{
	if (first > count_ || count > count_ - first)
		throw shortOfRows();
	first_ += first;
	count_ = count;
	if (offset_)
		*offset_ += first * rowBytes();
}

void Rows::askFor(std::uint64_t first, std::uint64_t count) const
{
	if (offset_)
		posix_fadvise(descriptor_, static_cast<off_t>(*offset_ + first * rowBytes()),
		              static_cast<off_t>(count * rowBytes()), POSIX_FADV_WILLNEED);
}

void Rows::read(std::uint64_t first, std::uint64_t count, void* to) const
{
	if (first > size() || count > size() - first)
		throw shortOfRows();
	if (!offset_)
	{
		const std::lock_guard lock(one_at_a_time_);
		std::vector<std::uint64_t> begin(sides_.size(), 0), counts(sides_);
		begin[0] = first_ + first;
		counts[0] = count;
		return file_.readSlab(path_, begin, counts, type_, to);
	}
	std::size_t left = count * rowBytes();
	auto at = static_cast<off_t>(*offset_ + first * rowBytes());
	for (auto* next = static_cast<char*>(to); left > 0;)
	{
		const ssize_t bytes = pread(descriptor_, next, left, at);
		if (bytes == 0 || (bytes < 0 && errno != EINTR))
			throw shortOfRows();
		if (bytes < 0)
			continue;
		next += bytes;
		at += bytes;
		left -= static_cast<std::size_t>(bytes);
	}
}

} // namespace vp::reader::hdf5
