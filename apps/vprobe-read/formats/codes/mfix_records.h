#pragma once

#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"

#include <cstdint>
#include <string_view>
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
		return reader::numberAt<Number>(record.data() + place, ByteOrder::big);
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
