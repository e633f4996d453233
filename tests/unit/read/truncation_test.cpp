#include "name_of_sample.h"
#include "read/read.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

using namespace vp;

namespace
{

class EachFormatCutShort : public testing::TestWithParam<std::size_t>
{
};

// Each length is a run of the reader: eight in a long run, else four.
const std::size_t kSpread = std::getenv("VPROBE_LONG") ? 8 : 4;

// Spread over the file, and its last bytes.
std::vector<std::size_t> lengths(std::size_t size)
{
	std::vector<std::size_t> all = {7, size - 1, size - 2, size - 9, size - 30};
	for (std::size_t i = 1; i < kSpread; ++i)
		all.push_back(size * i / kSpread);
	std::erase_if(all, [size](std::size_t length) { return length == 0 || length >= size; });
	if (test::tryEvery() > 1)
		all = {all[1 % all.size()], all.back()};
	return all;
}

const grid::Field* fieldLike(const grid::Block& block, const grid::Field& field)
{
	for (const grid::Field& each : block.fields)
		if (each.name == field.name && each.association == field.association)
			return &each;
	return nullptr;
}

// The result of the short file is part of that of the whole one. Text that ends inside its last number cannot be told
// from whole text: there, the last number may differ.
void expectPartOf(const grid::BlockSet& whole, const grid::BlockSet& part, bool is_text)
{
	ASSERT_EQ(part.blocks.size(), whole.blocks.size());
	EXPECT_EQ(part.cellCount(), whole.cellCount());
	EXPECT_EQ(part.pointCount(), whole.pointCount());
	for (std::size_t b = 0; b < whole.blocks.size(); ++b)
	{
		if (!is_text)
		{
			EXPECT_EQ(part.blocks[b].bounds.lo, whole.blocks[b].bounds.lo);
			EXPECT_EQ(part.blocks[b].bounds.hi, whole.blocks[b].bounds.hi);
		}
		for (const grid::Field& field : part.blocks[b].fields)
		{
			const grid::Field* other = fieldLike(whole.blocks[b], field);
			ASSERT_TRUE(other) << field.name;
			ASSERT_EQ(field.bytes.size(), other->bytes.size());
			const std::size_t same = field.bytes.size() - (is_text ? byteSize(field.type) * field.components : 0);
			EXPECT_EQ(std::memcmp(field.bytes.data(), other->bytes.data(), same), 0) << field.name;
		}
	}
}

} // namespace

TEST_P(EachFormatCutShort, IsRefusedOrRight)
{
	const SampleFile& sample = sampleFiles()[GetParam()];
	const TemporaryFolder folder;
	const std::string path = folder / sample.name;
	sample.write(path);
	const auto whole = read::readInputs({path}, {}, nullptr);
	ASSERT_TRUE(whole) << whole.error().message;

	const bool is_text = sample.name.starts_with("ascii");
	const std::string cut = sample.beside.empty() ? path : folder / sample.beside;
	const std::string contents = contentsOf(cut);
	std::size_t refused = 0;
	for (const std::size_t length : lengths(contents.size()))
	{
		writeContents(cut, contents.substr(0, length));
		const auto part = read::readInputs({path}, {}, nullptr);
		SCOPED_TRACE(sample.name + " cut to " + std::to_string(length) + " of " + std::to_string(contents.size()));
		if (part)
			expectPartOf(*whole, *part, is_text);
		else
		{
			++refused;
			EXPECT_EQ(part.error().kind, ErrorKind::input);
			EXPECT_TRUE(part.error().message.starts_with(path + ": ")) << part.error().message;
			EXPECT_EQ(part.error().message.find('\n'), std::string::npos);
		}
	}
	EXPECT_GE(refused, test::tryEvery() > 1 ? 1 : kSpread / 2);
}

INSTANTIATE_TEST_SUITE_P(Read, EachFormatCutShort, testing::Range(std::size_t(0), sampleFiles().size()), nameOfSample);
