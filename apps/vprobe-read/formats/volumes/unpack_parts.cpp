#include "read/protocol.h"
#include "vprobe-read/arrays/array_writer.h"
#include "vprobe-read/arrays/packed_parts.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/quick/tasks.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

namespace vp::reader::volumes
{

namespace
{

// Returns the parts of the next request; nothing if there is none.
std::vector<arrays::PackedPart> nextParts()
{
	std::uint64_t count = 0;
	ssize_t bytes = 0;
	do
		bytes = ::read(STDIN_FILENO, &count, sizeof(count));
	while (bytes < 0 && errno == EINTR);
	struct stat about = {};
	if (bytes != sizeof(count) || fstat(read::kCellsFd, &about) != 0)
		return {};
	std::vector<arrays::PackedPart> parts(
	    std::min<std::uint64_t>(count, static_cast<std::uint64_t>(about.st_size) / sizeof(arrays::PackedPart)));
	const std::size_t list = parts.size() * sizeof(arrays::PackedPart);
	if (pread(read::kCellsFd, parts.data(), list, 0) != static_cast<ssize_t>(list))
		throw Refusal("the list of its parts cannot be read");
	return parts;
}

} // namespace

void unpackParts(const Request& request, const std::function<void(std::string_view)>& answer)
{
	const std::size_t blank = request.unpack.find(' ');
	const std::size_t bytes = std::strtoull(request.unpack.c_str(), nullptr, 10);
	const arrays::UnpackPart unpack = arrays::unpackerOf(request.file, request.unpack.substr(blank + 1));
	for (std::vector<arrays::PackedPart> parts = nextParts(); !parts.empty(); parts = nextParts())
	{
		arrays::Writer writer(read::kArraysFd);
		const std::size_t begin = writer.reserve(parts.size() * bytes);
		quick::Tasks tasks(request.threads);
		tasks.add(parts.size(),
		          [&](std::size_t number, arrays::Scratch& scratch)
		          {
			          scratch.unpacked.assign(bytes, std::byte(0));
			          unpack(parts[number], scratch.unpacked);
			          writer.put(begin + number * bytes, scratch.unpacked.data(), bytes);
		          });
		tasks.run();
		const std::uint64_t count = parts.size();
		answer({reinterpret_cast<const char*>(&count), sizeof(count)});
	}
}

} // namespace vp::reader::volumes
