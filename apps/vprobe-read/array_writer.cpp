#include "array_writer.h"

#include "read/protocol.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cerrno>
#include <new>
#include <system_error>

#include <unistd.h>

using vp::grid::NumberType;

void ArrayWriter::begin()
{
	constexpr std::size_t alignment = vp::read::kArrayAlignment;
	position_ = (position_ + alignment - 1) / alignment * alignment;
	start_ = position_;
}

void ArrayWriter::append(const void* data, std::size_t bytes)
{
	const char* from = static_cast<const char*>(data);
	while (bytes > 0)
	{
		const ssize_t written = pwrite(memory_, from, bytes, static_cast<off_t>(position_));
		if (written < 0 && errno == EINTR)
			continue;
		if (written < 0 && (errno == EFBIG || errno == ENOSPC || errno == ENOMEM))
			throw std::bad_alloc();
		if (written <= 0)
			throw std::system_error(errno, std::generic_category(), "shared memory");
		from += written;
		bytes -= static_cast<std::size_t>(written);
		position_ += static_cast<std::size_t>(written);
	}
}

nlohmann::json ArrayWriter::end(NumberType type)
{
	return {{"type", vp::grid::numberTypeName(type)}, {"offset", start_}, {"bytes", position_ - start_}};
}

nlohmann::json ArrayWriter::write(NumberType type, const void* data, std::size_t bytes)
{
	begin();
	append(data, bytes);
	return end(type);
}

nlohmann::json writeInt64(ArrayWriter& writer, std::span<const std::int32_t> values)
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

nlohmann::json writeInt64(ArrayWriter& writer, std::span<const std::int64_t> values)
{
	return writer.write(NumberType::int64, values.data(), values.size_bytes());
}
