#pragma once

#include <cassert>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace vp::ranks
{

using Bytes = std::vector<std::byte>;

// Puts values one behind the other, to be taken in the same order by a process of the same program.
class MessageWriter
{
public:
	template <class T>
	requires std::is_trivially_copyable_v<T>
	void put(const T& value) { append(&value, sizeof(T)); }
	template <class T>
	requires std::is_trivially_copyable_v<T>
	void putAll(std::span<const T> values)
	{
		put(values.size());
		append(values.data(), values.size_bytes());
	}
	template <class T>
	void putAll(const std::vector<T>& values)
	{
		putAll(std::span<const T>(values));
	}
	void put(const std::string& text) { putAll(std::span<const char>(text)); }
	void append(const Bytes& message) { append(message.data(), message.size()); }
	Bytes take() { return std::move(bytes_); }
	std::size_t size() const { return bytes_.size(); }

private:
	void append(const void* from, std::size_t bytes)
	{
		if (bytes == 0)
			return;
		const std::size_t at = bytes_.size();
		bytes_.resize(at + bytes);
		std::memcpy(bytes_.data() + at, from, bytes);
	}

	Bytes bytes_;
};

// Takes what a MessageWriter has put. Messages come from this program alone, so their form is not checked.
class MessageReader
{
public:
	explicit MessageReader(std::span<const std::byte> bytes) : rest_(bytes) {}

	bool atEnd() const { return rest_.empty(); }
	template <class T>
	requires std::is_trivially_copyable_v<T> T get()
	{
		T value;
		copyTo(&value, sizeof(T));
		return value;
	}
	template <class T>
	std::vector<T> getAll()
	{
		std::vector<T> values(get<std::size_t>());
		copyTo(values.data(), values.size() * sizeof(T));
		return values;
	}
	std::string getText()
	{
		std::string text(get<std::size_t>(), '\0');
		copyTo(text.data(), text.size());
		return text;
	}

private:
	void copyTo(void* to, std::size_t bytes)
	{
		assert(bytes <= rest_.size());
		if (bytes > 0)
			std::memcpy(to, rest_.data(), bytes);
		rest_ = rest_.subspan(bytes);
	}

	std::span<const std::byte> rest_;
};

} // namespace vp::ranks
