#pragma once

#include "vprobe-read/base/refusal.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

namespace vp::reader::codes
{

// A file of records of 512 bytes, with numbers in the order of big endian. What lies past its end is a Refusal.
class MfixRecords
{
public:
	static constexpr std::size_t kBytes = 512;

	explicit MfixRecords(std::string_view bytes, std::size_t record = 0) : bytes_(bytes), at_(record * kBytes) {}

	std::string_view record() { return take(kBytes); }
	void skip(std::size_t records = 1) { take(records * kBytes); }
	// So many numbers, in as many records as they fill.
	template <class Number>
	std::vector<Number> numbers(std::size_t count)
	{
		constexpr std::size_t each = kBytes / sizeof(Number);
		const std::string_view all = take((count + each - 1) / each * kBytes);
		std::vector<Number> read(count);
		for (std::size_t i = 0; i < count; ++i)
			read[i] = numberAt<Number>(all, i * sizeof(Number));
		return read;
	}
	template <class Number>
	void skipNumbers(std::size_t count, std::size_t times = 1)
	{
		constexpr std::size_t each = kBytes / sizeof(Number);
		skip(times * ((count + each - 1) / each));
	}

	// In a record.
	template <class Number>
	static Number numberAt(std::string_view record, std::size_t place)
	{
		using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
		Bits bits = 0;
		for (std::size_t b = 0; b < sizeof(Number); ++b)
			bits = bits << 8 | static_cast<unsigned char>(record[place + b]);
		return std::bit_cast<Number>(bits);
	}

private:
	std::string_view take(std::size_t bytes)
	{
		if (bytes > bytes_.size() || at_ > bytes_.size() - bytes)
			throw damaged("it ends before all that it announces");
		at_ += bytes;
		return bytes_.substr(at_ - bytes, bytes);
	}

	std::string_view bytes_;
	std::size_t at_;
};

} // namespace vp::reader::codes
