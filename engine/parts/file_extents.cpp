#include "parts/file_extents.h"

#include "parts/part_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace vp::parts
{

namespace
{

// A gap of so many bytes between two extents is asked for as well: one longer read takes less than two.
constexpr std::uint64_t kGap = 16 << 10;
constexpr std::size_t kPartsAtOnce = 256; // within IOV_MAX
constexpr const char* kShorter = "it has become shorter while it was open; open it again";

Unreadable failed(const OpenFile& file, const char* why)
{
	return Unreadable(fmt::format("{}: {}", file.name(), why));
}

std::array<std::uint64_t, 4> stampOf(const struct stat& about)
{
	return {about.st_dev, about.st_ino, static_cast<std::uint64_t>(about.st_mtim.tv_sec),
	        static_cast<std::uint64_t>(about.st_mtim.tv_nsec)};
}

} // namespace

OpenFile::OpenFile(std::string name) : name_(std::move(name))
{
	// Without O_NONBLOCK a pipe would wait here for its other end.
	descriptor_ = open(name_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
	if (descriptor_ < 0)
		throw failed(*this, std::strerror(errno));
	struct stat about = {};
	if (fstat(descriptor_, &about) != 0 || !S_ISREG(about.st_mode))
	{
		close(descriptor_);
		throw failed(*this, "not a regular file; name a file");
	}
	size_ = static_cast<std::uint64_t>(about.st_size);
	stamp_ = stampOf(about);
	// The parts are asked for as they are needed, so what lies behind them is of no use.
	posix_fadvise(descriptor_, 0, 0, POSIX_FADV_RANDOM);
}

bool OpenFile::isThereStill() const
{
	struct stat about = {};
	return stat(name_.c_str(), &about) == 0 && stampOf(about) == stamp_ &&
	       static_cast<std::uint64_t>(about.st_size) == size_;
}

void OpenFile::read(std::uint64_t offset, std::span<std::byte> to) const
{
	while (!to.empty())
	{
		const ssize_t bytes = pread(descriptor_, to.data(), to.size(), static_cast<off_t>(offset));
		if (bytes < 0 && errno == EINTR)
			continue;
		if (bytes < 0)
			throw failed(*this, std::strerror(errno));
		if (bytes == 0)
			throw failed(*this, kShorter);
		offset += static_cast<std::uint64_t>(bytes);
		to = to.subspan(static_cast<std::size_t>(bytes));
	}
}

void OpenFile::announce(std::vector<Extent> extents) const
{
	std::ranges::sort(extents);
	for (std::size_t i = 0, next; i < extents.size(); i = next)
	{
		auto [begin, end] = extents[i];
		for (next = i + 1; next < extents.size() && extents[next].first <= end + kGap; ++next)
			end = std::max(end, extents[next].second);
		posix_fadvise(descriptor_, static_cast<off_t>(begin), static_cast<off_t>(end - begin), POSIX_FADV_WILLNEED);
	}
}

OpenFile::~OpenFile()
{
	close(descriptor_);
}

FileExtents::FileExtents(std::shared_ptr<const OpenFile> file, const Layout& layout, Place place)
    : file_(std::move(file)), layout_(layout), place_(std::move(place))
{
}

bool FileExtents::fits(const Layout& layout, const Place& place, std::uint64_t file_size)
{
	if (place.offsets.empty())
	{
		const bool has_whole_rows = layout.part[0] == layout.items[0] && !layout.is_padded;
		const bool has_whole_layers = layout.part[1] == layout.items[1];
		return has_whole_rows && (has_whole_layers || layout.part[2] == 1) && place.offset <= file_size &&
		       layout.byteCount() <= file_size - place.offset;
	}
	if (place.offsets.size() != layout.partCount() || !layout.is_padded)
		return false;
	const std::uint64_t bytes = layout.bytesOf(0);
	return bytes <= file_size && std::ranges::all_of(place.offsets.span(), [&](std::uint64_t offset)
	                                                 { return offset == kMissing || offset <= file_size - bytes; });
}

std::uint64_t FileExtents::offsetOf(std::uint64_t number) const
{
	if (!place_.offsets.empty())
		return place_.offsets[number];
	const auto first = layout_.firstOf(number);
	const std::uint64_t item = (first[2] * layout_.items[1] + first[1]) * layout_.items[0] + first[0];
	return place_.offset + item * layout_.item_bytes;
}

void FileExtents::announce(std::span<const std::uint64_t> numbers) const
{
	std::vector<OpenFile::Extent> extents;
	for (const std::uint64_t number : numbers)
		if (const std::uint64_t offset = offsetOf(number); offset != kMissing)
			extents.emplace_back(offset, offset + layout_.bytesOf(number));
	file_->announce(std::move(extents));
}

void FileExtents::readRun(std::span<const Wanted> run) const
{
	std::array<iovec, kPartsAtOnce> pieces;
	std::size_t left = 0;
	for (std::size_t i = 0; i < run.size(); ++i)
	{
		pieces[i] = {run[i].bytes.data(), run[i].bytes.size()};
		left += run[i].bytes.size();
	}
	auto offset = static_cast<off_t>(offsetOf(run.front().number));
	iovec* piece = pieces.data();
	while (left > 0)
	{
		const auto pieces_left = static_cast<int>(pieces.data() + run.size() - piece);
		ssize_t count = preadv(file_->descriptor(), piece, pieces_left, offset);
		if (count < 0 && errno == EINTR)
			continue;
		if (count < 0)
			throw failed(*file_, std::strerror(errno));
		if (count == 0)
			throw failed(*file_, kShorter);
		offset += count;
		left -= static_cast<std::size_t>(count);
		for (; count > 0 && static_cast<std::size_t>(count) >= piece->iov_len; ++piece)
			count -= static_cast<ssize_t>(piece->iov_len);
		if (count > 0)
		{
			piece->iov_base = static_cast<std::byte*>(piece->iov_base) + count;
			piece->iov_len -= static_cast<std::size_t>(count);
		}
	}
	if (place_.swaps)
		for (const Wanted& part : run)
			swapNumbers(part.bytes, place_.number_bytes);
}

// Parts that lie one behind the other are read together.
void FileExtents::read(std::span<const Wanted> wanted) const
{
	for (std::size_t begin = 0; begin < wanted.size();)
	{
		std::uint64_t end_of_run = offsetOf(wanted[begin].number);
		if (end_of_run == kMissing)
		{
			const std::span<std::byte> bytes = wanted[begin++].bytes;
			fillItems(bytes, place_.fill);
			if (place_.swaps)
				swapNumbers(bytes, place_.number_bytes);
			continue;
		}
		std::size_t end = begin;
		while (end < wanted.size() && end - begin < kPartsAtOnce && offsetOf(wanted[end].number) == end_of_run)
			end_of_run += wanted[end++].bytes.size();
		readRun(wanted.subspan(begin, end - begin));
		begin = end;
	}
}

} // namespace vp::parts
