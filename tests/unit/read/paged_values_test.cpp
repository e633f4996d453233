#include "read/paged_values.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

using namespace vp;
using namespace vp::read;

namespace
{

using Extents = std::vector<PagedValues::Extent>;

// 10 pages of 512 numbers, and an eleventh of 100, behind 13 other bytes. Each number is 3 times its place.
struct NumberFile
{
	static constexpr std::uint64_t kRows = 5220;
	TemporaryFolder folder;
	std::string path = folder / "numbers";

	NumberFile()
	{
		std::string bytes(13, 'x');
		for (std::uint64_t i = 0; i < kRows; ++i)
		{
			const double number = 3.0 * static_cast<double>(i);
			bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
		}
		writeContents(path, bytes);
	}

	PagedValues paged() const { return {std::make_shared<const parts::OpenFile>(path), {13, kRows, 8}}; }
};

void readMissing(PagedValues& values)
{
	const Extents extents = values.missing();
	values.announce(extents);
	for (const PagedValues::Extent& extent : extents)
		values.read(extent);
	values.note(extents);
}

double numberAt(const PagedValues& values, std::uint64_t row)
{
	double number = 0.0;
	std::memcpy(&number, values.row(row), sizeof(number));
	return number;
}

} // namespace

TEST(PagedValues, ReadThePagesThatAreWanted)
{
	const NumberFile numbers;
	PagedValues values = numbers.paged();
	EXPECT_EQ(values.missing(), Extents{});
	for (const std::uint64_t row : {511, 512, 1023, 5219}) // in the pages 0, 1 and 10
		values.want(row);
	EXPECT_EQ(values.missing(), (Extents{{0, 8192}, {40960, 41760}}));
	readMissing(values);
	EXPECT_EQ(values.missing(), Extents{});
	EXPECT_EQ(values.wanted(), (Extents{{0, 8192}, {40960, 41760}}));
	EXPECT_EQ(values.bytesThere(), 8192u + 800u);
	EXPECT_EQ(numberAt(values, 700), 2100.0);
	EXPECT_EQ(numberAt(values, 5219), 15657.0);
	EXPECT_EQ(numberAt(values, 1024), 0.0); // not read

	values.want(1024);
	values.want(0);
	EXPECT_EQ(values.missing(), (Extents{{8192, 12288}}));
}

TEST(PagedValues, ReadAllWhereMuchIsWanted)
{
	const NumberFile numbers;
	PagedValues values = numbers.paged();
	for (const std::uint64_t page : {1, 3, 5, 7})
		values.want(512 * page);
	EXPECT_EQ(values.missing().size(), 4u); // 36 %
	readMissing(values);
	values.want(512 * 9);
	readMissing(values);
	EXPECT_EQ(values.bytesThere(), values.bytes());
	for (std::uint64_t row = 0; row < NumberFile::kRows; ++row)
		ASSERT_EQ(numberAt(values, row), 3.0 * static_cast<double>(row));
}

TEST(PagedValues, MayHaveTheirBytesInTheOtherOrder)
{
	TemporaryFolder folder;
	writeContents(folder / "numbers", std::string("xx\x01\x02\x03\x04\x05\x06\x07\x08", 10)); // rows of two numbers
	PagedValues values(std::make_shared<const parts::OpenFile>(folder / "numbers"), {2, 1, 8, 4});
	values.want(0);
	readMissing(values);
	EXPECT_EQ(std::memcmp(values.row(0), "\x04\x03\x02\x01\x08\x07\x06\x05", 8), 0);
}

TEST(PagedValues, HaveRowsLongerThanPagesToo)
{
	const NumberFile numbers;
	PagedValues values(std::make_shared<const parts::OpenFile>(numbers.path), {13, 4, 8 * 1300});
	values.want(2);
	EXPECT_EQ(values.missing(), (Extents{{20800, 31200}}));
	readMissing(values);
	EXPECT_EQ(numberAt(values, 2), 7800.0);
}

TEST(PagedValues, TellOfAFileThatBecameShorter)
{
	const NumberFile numbers;
	PagedValues values = numbers.paged();
	values.want(5000);
	std::filesystem::resize_file(numbers.path, 1000);
	EXPECT_THROW(readMissing(values), parts::Unreadable);
	EXPECT_EQ(values.missing().size(), 1u); // as before
}
