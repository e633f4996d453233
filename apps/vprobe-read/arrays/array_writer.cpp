#include "array_writer.h"

#include "read/protocol.h"
#include "vprobe-read/base/refusal.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>

#include <unistd.h>

namespace vp::reader::arrays
{

using grid::NumberType;

namespace
{
// Limit for the length of a file.
constexpr std::size_t kMaxBytes = std::size_t(1) << 62;
} // namespace

void Writer::begin()
{
	constexpr std::size_t alignment = read::kArrayAlignment;
	position_ = (position_ + alignment - 1) / alignment * alignment;
	start_ = position_;
}

void Writer::append(const void* data, std::size_t bytes)
{
	put(position_, data, bytes);
	position_ += bytes;
}

std::size_t Writer::reserve(std::size_t bytes)
{
	begin();
	if (bytes > kMaxBytes - position_)
		throw std::bad_alloc();
	position_ += bytes;
	return start_;
}

// The memory is written, not mapped: so no page is cleared first, the process' limits apply, and a lack of memory is an
// error, not a signal.
void Writer::put(std::size_t at, const void* data, std::size_t bytes) const
{
	const char* from = static_cast<const char*>(data);
	while (bytes > 0)
	{
		const ssize_t written = pwrite(memory_, from, bytes, static_cast<off_t>(at));
		if (written < 0 && errno == EINTR)
			continue;
		if (written <= 0) // EFBIG, ENOSPC or ENOMEM: shared memory has no room
			throw NoSharedMemory();
		from += written;
		bytes -= static_cast<std::size_t>(written);
		at += static_cast<std::size_t>(written);
	}
}

void Writer::rewind(std::size_t mark)
{
	if (ftruncate(memory_, static_cast<off_t>(mark)) != 0)
		throw NoSharedMemory();
	start_ = position_ = mark;
}

nlohmann::json Writer::end(NumberType type)
{
	return describe(type, start_, position_ - start_);
}

nlohmann::json Writer::describe(NumberType type, std::size_t at, std::size_t bytes)
{
	return {{"type", grid::numberTypeName(type)}, {"offset", at}, {"bytes", bytes}};
}

nlohmann::json Writer::write(NumberType type, const void* data, std::size_t bytes)
{
	begin();
	append(data, bytes);
	return end(type);
}

namespace
{

template <class Number>
nlohmann::json writeWide(Writer& writer, std::span<const Number> values)
{
	std::array<std::int64_t, 8192> wide;
	writer.begin();
	while (!values.empty())
	{
		const std::size_t n = std::min(values.size(), wide.size());
		std::copy_n(values.begin(), n, wide.begin());
		writer.append(wide.data(), n * sizeof wide[0]);
		values = values.subspan(n);
	}
	return writer.end(NumberType::int64);
}

} // namespace

nlohmann::json writeInt64(Writer& writer, std::span<const std::int32_t> values)
{
	return writeWide(writer, values);
}

nlohmann::json writeInt64(Writer& writer, std::span<const std::uint32_t> values)
{
	return writeWide(writer, values);
}

nlohmann::json writeInt64(Writer& writer, std::span<const std::int64_t> values)
{
	return writer.write(NumberType::int64, values.data(), values.size_bytes());
}

nlohmann::json writeIds(Writer& writer, std::span<const std::int32_t> ids)
{
	return writer.write(NumberType::int32, ids.data(), ids.size_bytes());
}

nlohmann::json writeIds(Writer& writer, std::span<const std::int64_t> ids)
{
	std::uint64_t high = 0;
	for (const std::int64_t id : ids)
		high |= static_cast<std::uint64_t>(id);
	if (high > INT32_MAX)
		return writeInt64(writer, ids);
	std::array<std::int32_t, 16384> narrow;
	writer.begin();
	while (!ids.empty())
	{
		const std::size_t n = std::min(ids.size(), narrow.size());
		std::transform(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(n), narrow.begin(),
		               [](std::int64_t id) { return static_cast<std::int32_t>(id); });
		writer.append(narrow.data(), n * sizeof narrow[0]);
		ids = ids.subspan(n);
	}
	return writer.end(NumberType::int32);
}

} // namespace vp::reader::arrays
