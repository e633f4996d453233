#include "parts/file_extents.h"
#include "parts/part_store.h"
#include "parts/stoppable.h"

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

using namespace vp::parts;

namespace
{

using Numbers = std::vector<std::uint16_t>;

// A file of numbers, gone at the end. The process keeps what fits into `budget` meanwhile.
class PartStoreTest : public testing::Test
{
protected:
	PartStoreTest() : budget_(KeptParts::ofProcess().budget()) {}
	~PartStoreTest() override
	{
		KeptParts::ofProcess().setBudget(budget_);
		std::filesystem::remove(path_);
	}

	std::shared_ptr<const OpenFile> fileOf(const Numbers& numbers) const
	{
		std::ofstream(path_, std::ios::binary)
		    .write(reinterpret_cast<const char*>(numbers.data()), static_cast<long>(2 * numbers.size()));
		return std::make_shared<OpenFile>(path_);
	}

	const std::string path_ = testing::TempDir() + "part_store_test." + std::to_string(getpid());

private:
	std::uint64_t budget_;
};

std::uint16_t numberAt(const std::byte* at)
{
	std::uint16_t number = 0;
	std::memcpy(&number, at, sizeof number);
	return number;
}

std::unique_ptr<PartStore> storeOf(std::shared_ptr<const OpenFile> file, const Layout& layout, FileExtents::Place place)
{
	EXPECT_TRUE(FileExtents::fits(layout, place, file->size()));
	return std::make_unique<PartStore>(layout, std::make_unique<FileExtents>(file, layout, std::move(place)));
}

// Numbers 0, 1, 2 … in their order.
Numbers counted(std::size_t count)
{
	Numbers numbers(count);
	for (std::size_t i = 0; i < count; ++i)
		numbers[i] = static_cast<std::uint16_t>(i);
	return numbers;
}

// Chunks of an array of counted numbers, in an order of their own, as a file might have them.
struct Chunked
{
	Numbers file;
	std::vector<std::uint64_t> offsets;
};

Chunked chunked(const Layout& layout, std::mt19937& random)
{
	std::vector<std::uint64_t> order(layout.partCount());
	for (std::size_t i = 0; i < order.size(); ++i)
		order[i] = i;
	std::shuffle(order.begin(), order.end(), random);
	Chunked made{{}, std::vector<std::uint64_t>(order.size())};
	for (const std::uint64_t number : order)
	{
		made.offsets[number] = 2 * made.file.size();
		const auto first = layout.firstOf(number);
		for (std::uint64_t k = 0; k < layout.part[2]; ++k)
			for (std::uint64_t j = 0; j < layout.part[1]; ++j)
				for (std::uint64_t i = 0; i < layout.part[0]; ++i)
				{
					const std::array at{first[0] + i, first[1] + j, first[2] + k};
					const bool inside = at[0] < layout.items[0] && at[1] < layout.items[1] && at[2] < layout.items[2];
					const std::uint64_t item = (at[2] * layout.items[1] + at[1]) * layout.items[0] + at[0];
					made.file.push_back(inside ? static_cast<std::uint16_t>(item) : std::uint16_t(0xDEAD));
				}
	}
	return made;
}

} // namespace

// 5 x 4 x 3 items in parts of 2 x 3 x 2: 3 x 2 x 2 parts, of which the last holds one item along i, one along j and
// one along k.
TEST(Layout, PartsOfAnArrayWorkedOutByHand)
{
	Layout layout{{5, 4, 3}, {2, 3, 2}, 2, true};
	EXPECT_EQ(layout.partCount(), 12u);
	EXPECT_EQ(layout.byteCount(), 120u);
	EXPECT_EQ(layout.placeOf(11), (std::array<std::uint64_t, 3>{2, 1, 1}));
	EXPECT_EQ(layout.firstOf(11), (std::array<std::uint64_t, 3>{4, 3, 2}));
	EXPECT_EQ(layout.itemsOf(11), (std::array<std::uint64_t, 3>{1, 1, 1}));
	EXPECT_EQ(layout.bytesOf(11), 24u);
	layout.is_padded = false;
	EXPECT_EQ(layout.bytesOf(11), 2u);
	EXPECT_EQ(layout.bytesOf(0), 24u);
}

// Item 23 of 5 x 4 x 3 is (3, 0, 1): row 0 of layer 1. With two rows a part that is part 2, of rows 0 and 1 of layer 1.
TEST_F(PartStoreTest, ReadsTheRowsOfAnItemAndNoOthers)
{
	const Layout layout{{5, 4, 3}, {5, 2, 1}, 2, false};
	const auto store = storeOf(fileOf(counted(60)), layout, {.number_bytes = 2});
	EXPECT_EQ(numberAt(store->item(23)), 23);
	EXPECT_EQ(numberAt(store->item(29)), 29) << "the same part";
	const PartUse use = store->use();
	EXPECT_EQ(use.all, 6u);
	EXPECT_EQ(use.met, 1u);
	EXPECT_EQ(use.read, 1u);
	EXPECT_EQ(use.kept, 1u);
	EXPECT_EQ(use.bytes_read, 20u);
	EXPECT_EQ(use.bytes_met, 20u);
	store->startCounting();
	EXPECT_EQ(store->use().read, 0u);
	EXPECT_EQ(store->use().kept, 1u);
}

TEST_F(PartStoreTest, RowsThatDoNotFillTheirLastPart)
{
	const Layout layout{{5, 3, 4}, {5, 2, 1}, 2, false}; // the second part of a layer has one row
	Numbers numbers = counted(60);
	numbers.insert(numbers.begin(), {7, 7, 7}); // a header of 6 bytes
	const auto store = storeOf(fileOf(numbers), layout, {.offset = 6, .number_bytes = 2});
	for (std::uint64_t item = 0; item < 60; ++item)
		EXPECT_EQ(numberAt(store->item(item)), item);
	EXPECT_EQ(store->use().bytes_read, 120u);
	EXPECT_EQ(store->use().read, 8u);
}

TEST_F(PartStoreTest, EveryItemOfChunksOfAnySize)
{
	std::mt19937 random(7);
	for (int trial = 0; trial < 30; ++trial)
	{
		const auto side = [&](int most) { return std::uint64_t(1) + random() % std::uint64_t(most); };
		const Layout layout{{side(12), side(12), side(12)}, {side(5), side(5), side(14)}, 2, true};
		const Chunked made = chunked(layout, random);
		const auto store = storeOf(fileOf(made.file), layout, {.offsets = made.offsets, .number_bytes = 2});
		std::vector<std::atomic<int>> visits(layout.itemCount());
		store->forEachRun(
		    [&](std::uint64_t first, const std::byte* bytes, std::size_t count)
		    {
			    for (std::size_t i = 0; i < count; ++i)
			    {
				    EXPECT_EQ(numberAt(bytes + 2 * i), first + i);
				    ++visits[first + i];
			    }
		    });
		for (const auto& each : visits)
			ASSERT_EQ(each, 1);
		EXPECT_EQ(store->use().kept, 0u) << "a visit of all keeps none";
		for (std::uint64_t item = 0; item < layout.itemCount(); ++item)
			ASSERT_EQ(numberAt(store->item(item)), item);
	}
}

TEST_F(PartStoreTest, FetchesWhatIsNeededOnce)
{
	std::mt19937 random(3);
	const Layout layout{{20, 20, 20}, {4, 4, 4}, 2, true};
	const Chunked made = chunked(layout, random);
	const auto store = storeOf(fileOf(made.file), layout, {.offsets = made.offsets, .number_bytes = 2});
	PartStore::Needs needs(*store);
	for (std::uint64_t k = 0; k < 20; ++k) // the column of items (9, 9, k): five parts
		needs.add((k * 20 + 9) * 20 + 9);
	store->fetch(needs);
	EXPECT_EQ(store->use().read, 5u);
	EXPECT_EQ(store->use().met, 5u);
	store->fetch(needs);
	EXPECT_EQ(numberAt(store->item((7 * 20 + 9) * 20 + 9)), (7 * 20 + 9) * 20 + 9);
	EXPECT_EQ(store->use().read, 5u) << "they are kept";
}

// Its parts are zeros. Somebody asks for the end while the first is read.
class StoppedSource : public Source
{
public:
	explicit StoppedSource(std::stop_source& stop) : stop_(stop) {}
	void announce(std::span<const std::uint64_t>) const override {}
	void read(std::span<const Wanted>) const override { stop_.request_stop(); }

private:
	std::stop_source& stop_;
};

// Four parts of 32 MiB: the request is seen behind the first, which is kept.
TEST_F(PartStoreTest, FetchingStopsBetweenParts)
{
	const Layout layout{{32 << 20, 4, 1}, {32 << 20, 1, 1}, 1, true};
	std::stop_source stop;
	const PartStore store(layout, std::make_unique<StoppedSource>(stop));
	KeptParts::ofProcess().setBudget(std::uint64_t(256) << 20);
	PartStore::Needs needs(store);
	for (std::uint64_t row = 0; row < 4; ++row)
		needs.add(row * layout.items[0]);
	{
		const Stoppable reading(stop.get_token());
		EXPECT_THROW(store.fetch(needs), Stopped);
		EXPECT_EQ(store.use().read, 1u);
		EXPECT_EQ(store.use().kept, 1u);
		EXPECT_THROW(store.fetch(needs), Stopped);
	}
	store.fetch(needs);
	EXPECT_EQ(store.use().read, 4u) << "nobody asks for the end, and the first part is there";
}

TEST_F(PartStoreTest, KeepsNoMoreThanTheBudget)
{
	std::mt19937 random(5);
	const Layout layout{{16, 16, 16}, {4, 4, 4}, 2, true}; // 64 parts of 128 bytes
	const Chunked made = chunked(layout, random);
	const auto store = storeOf(fileOf(made.file), layout, {.offsets = made.offsets, .number_bytes = 2});
	KeptParts::ofProcess().setBudget(1000);
	tbb::parallel_for(0, 64 * 64,
	                  [&](int item)
	                  { EXPECT_EQ(numberAt(store->item(std::uint64_t(item))), static_cast<std::uint16_t>(item)); });
	EXPECT_LE(KeptParts::ofProcess().bytes(), 1000u);
	EXPECT_EQ(store->use().kept, 7u);
	EXPECT_EQ(store->use().met, 64u);
	PartStore::Needs needs(*store);
	for (std::uint64_t item = 0; item < 4096; ++item)
		needs.add(item);
	store->startCounting();
	store->fetch(needs); // would not fit, so each part is left to item()
	EXPECT_EQ(store->use().read, 0u);
}

TEST_F(PartStoreTest, NumbersOfTheOtherByteOrderAndChunksThatWereNeverWritten)
{
	const Layout layout{{2, 1, 2}, {2, 1, 1}, 4, true}; // items of two numbers; the second chunk is missing
	FileExtents::Place place{.offsets = std::vector<std::uint64_t>{0, FileExtents::kMissing},
	                         .fill = {std::byte(0), std::byte(9), std::byte(1), std::byte(2)},
	                         .number_bytes = 2,
	                         .swaps = true};
	const auto store = storeOf(fileOf({0x0102, 0x0304, 0x0506, 0x0708}), layout, std::move(place));
	EXPECT_EQ(numberAt(store->item(1)), 0x0605);
	EXPECT_EQ(numberAt(store->item(1) + 2), 0x0807);
	EXPECT_EQ(numberAt(store->item(3)), 0x0009) << "the fill value is in the file's order too";
	EXPECT_EQ(numberAt(store->item(3) + 2), 0x0102);
}

TEST_F(PartStoreTest, WhatDoesNotLieInTheFileIsToldApart)
{
	const Layout rows{{4, 4, 4}, {4, 2, 1}, 2, false};
	EXPECT_TRUE(FileExtents::fits(rows, {.offset = 2}, 130));
	EXPECT_FALSE(FileExtents::fits(rows, {.offset = 2}, 129));
	EXPECT_FALSE(FileExtents::fits(rows, {.offset = std::numeric_limits<std::uint64_t>::max()}, 129));
	EXPECT_FALSE(FileExtents::fits({{4, 4, 4}, {2, 2, 1}, 2, false}, {}, 1000)) << "half rows do not lie in one piece";
	EXPECT_FALSE(FileExtents::fits({{4, 4, 4}, {4, 2, 2}, 2, false}, {}, 1000)) << "nor parts of two layers";
	const Layout chunks{{4, 4, 4}, {4, 4, 2}, 2, true};
	const auto at = [](std::uint64_t a, std::uint64_t b) {
		return FileExtents::Place{.offsets = std::vector<std::uint64_t>{a, b}};
	};
	EXPECT_TRUE(FileExtents::fits(chunks, at(64, FileExtents::kMissing), 128));
	EXPECT_FALSE(FileExtents::fits(chunks, at(0, 65), 128));
	EXPECT_FALSE(FileExtents::fits(chunks, {.offsets = std::vector<std::uint64_t>{0}}, 128));
}

TEST_F(PartStoreTest, AFileThatBecomesShorterIsTold)
{
	const Layout layout{{8, 8, 8}, {8, 8, 1}, 2, false};
	const auto store = storeOf(fileOf(counted(512)), layout, {.number_bytes = 2});
	EXPECT_EQ(numberAt(store->item(10)), 10);
	std::filesystem::resize_file(path_, 200);
	EXPECT_EQ(numberAt(store->item(11)), 11) << "kept";
	try
	{
		store->item(300);
		FAIL();
	}
	catch (const Unreadable& told)
	{
		EXPECT_NE(std::string(told.what()).find(path_), std::string::npos);
		EXPECT_NE(std::string(told.what()).find("shorter"), std::string::npos);
	}
}

TEST_F(PartStoreTest, OpensRegularFilesAlone)
{
	EXPECT_THROW(OpenFile{path_ + ".absent"}, Unreadable);
	EXPECT_THROW(OpenFile{testing::TempDir()}, Unreadable);
	ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
	EXPECT_THROW(OpenFile file(path_), Unreadable); // and does not wait for a writer
}
