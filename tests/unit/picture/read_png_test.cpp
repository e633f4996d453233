#include "picture/read_png.h"

#include "write/png.h"

#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace vp::picture::test
{

namespace
{

class ReadPng : public testing::Test
{
protected:
	void TearDown() override { std::filesystem::remove(path_); }

	std::string path_ = testing::TempDir() + "read_png_test.png";
};

std::string why(const Result<render::Picture>& read)
{
	EXPECT_FALSE(read);
	return read ? "" : read.error().message;
}

} // namespace

TEST_F(ReadPng, GivesWhatWasWritten)
{
	const render::Picture picture{2, 1, {255, 0, 10, 255, 1, 2, 3, 0}};
	ASSERT_TRUE(write::writePng(picture, path_));
	const Result<render::Picture> read = readPng(path_);
	ASSERT_TRUE(read) << read.error().message;
	EXPECT_EQ(read->width, 2u);
	EXPECT_EQ(read->rgba, picture.rgba);
}

TEST_F(ReadPng, RefusesSixteenBits)
{
	std::FILE* file = std::fopen(path_.c_str(), "wb");
	png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
	png_infop info = png_create_info_struct(png);
	png_init_io(png, file);
	png_set_IHDR(png, info, 1, 1, 16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
	             PNG_FILTER_TYPE_DEFAULT);
	png_write_info(png, info);
	const png_byte row[6] = {1, 2, 3, 4, 5, 6};
	png_write_row(png, row);
	png_write_end(png, info);
	png_destroy_write_struct(&png, &info);
	std::fclose(file);
	EXPECT_EQ(why(readPng(path_)), path_ + ": has 16 bits a channel; store it with 8, as vprobe render does");
}

TEST_F(ReadPng, RefusesWhatIsNoPictureAndWhatIsCutShort)
{
	EXPECT_NE(why(readPng(path_)).find("cannot be read"), std::string::npos);
	std::ofstream(path_) << "no picture";
	EXPECT_NE(why(readPng(path_)).find("is not a PNG that can be read"), std::string::npos);
	render::Picture picture{64, 64, std::vector<std::uint8_t>(64 * 64 * 4)};
	for (std::size_t i = 0; i < picture.rgba.size(); ++i)
		picture.rgba[i] = static_cast<std::uint8_t>(i * i / 7);
	ASSERT_TRUE(write::writePng(picture, path_));
	std::filesystem::resize_file(path_, std::filesystem::file_size(path_) / 2);
	EXPECT_NE(why(readPng(path_)).find("is not a PNG that can be read"), std::string::npos);
}

// A head may claim any size; the file is too short for it.
TEST_F(ReadPng, TakesNoMemoryForASizeThatTheFileCannotHold)
{
	ASSERT_TRUE(write::writePng({1, 1, {1, 2, 3, 255}}, path_));
	std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
	std::string bytes((std::istreambuf_iterator<char>(file)), {});
	bytes[18] = '\x3f'; // width 0x3f01 = 16129
	bytes[22] = '\x3f';
	// The head's checksum is that of the changed bytes.
	const auto crc = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + 12), 17));
	for (int i = 0; i < 4; ++i)
		bytes[std::size_t(29 + i)] = static_cast<char>(crc >> (24 - 8 * i));
	file.seekp(0);
	file << bytes;
	file.close();
	EXPECT_EQ(why(readPng(path_)), path_ + ": is too short for its size in pixels; it is damaged");
}

} // namespace vp::picture::test
