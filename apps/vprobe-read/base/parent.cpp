#include "parent.h"

#include "read/protocol.h"
#include "refusal.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>

#include <unistd.h>

namespace vp::reader
{

namespace
{

std::string_view asBytes(const void* from, std::size_t bytes)
{
	return {static_cast<const char*>(from), bytes};
}

} // namespace

void sendToParent(std::string_view bytes)
{
	std::size_t sent = 0;
	while (sent < bytes.size())
	{
		const ssize_t n = write(read::kManifestFd, bytes.data() + sent, bytes.size() - sent);
		if (n < 0 && errno != EINTR)
			_exit(1);
		if (n > 0)
			sent += static_cast<std::size_t>(n);
	}
}

std::optional<std::vector<std::uint64_t>> askForParts(std::string_view about,
                                                      std::span<const std::array<double, 6>> boxes)
{
	const std::array<std::uint64_t, 2> sizes = {about.size(), boxes.size()};
	sendToParent(read::kPartsMark);
	sendToParent(asBytes(sizes.data(), sizeof(sizes)));
	sendToParent(about);
	sendToParent(asBytes(boxes.data(), boxes.size_bytes()));
	std::uint64_t count = 0;
	ssize_t bytes = 0;
	do
		bytes = ::read(STDIN_FILENO, &count, sizeof(count));
	while (bytes < 0 && errno == EINTR);
	if (bytes != sizeof(count))
		_exit(1);
	if (count == read::kAllParts)
		return std::nullopt;
	std::vector<std::uint64_t> numbers(std::min<std::uint64_t>(count, boxes.size()));
	const std::size_t list = numbers.size() * sizeof(std::uint64_t);
	const bool is_read = pread(read::kCellsFd, numbers.data(), list, 0) == static_cast<ssize_t>(list);
	if (!is_read || ftruncate(read::kCellsFd, 0) != 0 || !std::ranges::is_sorted(numbers) || numbers.empty() ||
	    numbers.back() >= boxes.size())
		throw Refusal("the list of the parts to read cannot be read");
	return numbers;
}

} // namespace vp::reader
