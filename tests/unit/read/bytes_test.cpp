// Numbers in bytes: either order, any place, widths that no type has.
#include "vprobe-read/base/bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

using vp::reader::ByteOrder;
using vp::reader::integerAt;
using vp::reader::numberAt;
using vp::reader::putNumber;

namespace
{

constexpr std::string_view kBytes("\x00\x01\x02\x83\x04\x05\x06\x07\x88", 9);

TEST(Bytes, AreNumbersInEitherOrder)
{
	EXPECT_EQ(numberAt<std::uint16_t>(kBytes.data() + 1), 0x0201);
	EXPECT_EQ(numberAt<std::uint16_t>(kBytes.data() + 1, ByteOrder::big), 0x0102);
	EXPECT_EQ(numberAt<std::int32_t>(kBytes.data()), static_cast<std::int32_t>(0x83020100));
	EXPECT_EQ(numberAt<std::int32_t>(kBytes.data(), ByteOrder::big), 0x00010283);
	EXPECT_EQ(numberAt<std::int8_t>(kBytes.data() + 3, ByteOrder::big), -0x7D);
	EXPECT_EQ(numberAt<std::uint64_t>(kBytes.data() + 1, ByteOrder::big), 0x0102830405060788u);
}

TEST(Bytes, AreRealNumbersToo)
{
	EXPECT_EQ(numberAt<float>("\x00\x00\xC0\xBF"), -1.5f);
	EXPECT_EQ(numberAt<float>("\xBF\xC0\x00\x00", ByteOrder::big), -1.5f);
	EXPECT_EQ(numberAt<double>("\x40\x09\x00\x00\x00\x00\x00\x00", ByteOrder::big), 3.125);
}

TEST(Bytes, AreIntegersOfAnyWidth)
{
	EXPECT_EQ(integerAt(kBytes.data() + 2, 1), 2u);
	EXPECT_EQ(integerAt(kBytes.data() + 1, 3), 0x830201u);
	EXPECT_EQ(integerAt(kBytes.data() + 1, 3, ByteOrder::big), 0x010283u);
	EXPECT_EQ(integerAt(kBytes.data() + 1, 8), 0x8807060504830201u); // no sign
	EXPECT_EQ(integerAt(kBytes.data() + 1, 8, ByteOrder::big), 0x0102830405060788u);
	EXPECT_EQ(integerAt(kBytes.data(), 0, ByteOrder::big), 0u);
}

TEST(Bytes, AreWrittenAsTheyAreRead)
{
	for (const ByteOrder order : {ByteOrder::little, ByteOrder::big})
	{
		std::array<char, 10> bytes = {};
		putNumber(std::int16_t(-2), bytes.data() + 1, order);
		EXPECT_EQ(numberAt<std::int16_t>(bytes.data() + 1, order), -2);
		EXPECT_EQ(bytes[order == ByteOrder::big ? 2 : 1], '\xFE');
		EXPECT_EQ(bytes[0], 0);
		EXPECT_EQ(bytes[3], 0);
		putNumber(std::numeric_limits<double>::quiet_NaN(), bytes.data(), order);
		EXPECT_TRUE(std::isnan(numberAt<double>(bytes.data(), order)));
	}
}

} // namespace
