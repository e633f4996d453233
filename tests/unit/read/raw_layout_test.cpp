#include "read/formats.h"
#include "read/raw_layout.h"
#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <set>

using namespace vp;

TEST(RawLayout, IsReadAsItIsWritten)
{
	const read::RawLayout layout{{256, 128, 64}, grid::NumberType::float32, Vec3(0.5, 1.25, 2.0), true};
	EXPECT_EQ(read::rawText(layout), "256x128x64 float32 0.5x1.25x2 big");
	EXPECT_EQ(*read::parseRaw(read::rawText(layout)), layout);
	EXPECT_EQ(*read::parseRaw(""), read::RawLayout{});
	for (const char* size :
	     {"", "256", "256x256", "256x256x", "1x256x256", "256x256x256x2", "axbxc", "-2x3x4", "2 x3x4"})
		EXPECT_FALSE(read::parseRawSize(size)) << size;
	for (const char* spacing : {"", "1x1", "0x1x1", "-1x1x1", "1x1xnan", "1x1xinf"})
		EXPECT_FALSE(read::parseRawSpacing(spacing)) << spacing;
	EXPECT_FALSE(read::parseRawType("double"));
	EXPECT_FALSE(read::parseRawOrder("middle"));
}

TEST(RawLayout, PlacesTheValuesThatEndTheFile)
{
	const TemporaryFolder folder;
	const std::string path = folder / "volume.bin";
	writeContents(path, std::string("head") + '\0' + '\1' + '\0' + '\2' + '\0' + '\3' + '\0' + '\4' + '\0' + '\5' +
	                        '\0' + '\6' + '\0' + '\7' + '\1' + '\0');
	read::ReadOptions options;
	options.raw = {{2, 2, 2}, grid::NumberType::uint16, Vec3(1.0, 2.0, 3.0), true};
	const auto set = read::readInputs({path}, options, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	const grid::Field& values = set->blocks[0].fields[0];
	EXPECT_EQ(values.name, "values");
	for (std::size_t i = 0; i < 7; ++i)
		EXPECT_EQ(values.value(i, 0), double(i + 1));
	EXPECT_EQ(values.value(7, 0), 256.0);
	EXPECT_EQ(set->bounds().hi, Vec3(1.0, 2.0, 3.0));

	options.raw.size = {2, 2, 3};
	const auto longer = read::readInputs({path}, options, nullptr);
	ASSERT_FALSE(longer);
	EXPECT_NE(longer.error().message.find("20 bytes where 2x2x3 values of uint16 take 24"), std::string::npos)
	    << longer.error().message;
}

TEST(Formats, HaveNamesOfTheirOwn)
{
	std::set<std::string_view> names;
	for (const read::Format& format : read::formats())
	{
		EXPECT_TRUE(names.insert(format.name).second) << format.name;
		EXPECT_EQ(read::findFormat(format.name), &format);
	}
	EXPECT_EQ(read::findFormat("none"), nullptr);
	EXPECT_EQ(read::formatOfEnding("a/B.NII.GZ")->name, "nifti");
	EXPECT_EQ(read::formatOfEnding("notes.txt"), nullptr);
}

TEST(Formats, OfAFileAreSettledByTheirName)
{
	const TemporaryFolder folder;
	const auto& samples = sampleFiles();
	const auto mesh =
	    std::find_if(samples.begin(), samples.end(), [](const auto& s) { return s.name == "ascii_2.msh"; });
	ASSERT_NE(mesh, samples.end());
	const std::string path = folder / "without an ending";
	mesh->write(path);
	read::ReadOptions options;
	EXPECT_TRUE(read::readInputs({path}, options, nullptr)); // by its content
	options.format = "gmsh";
	EXPECT_TRUE(read::readInputs({path}, options, nullptr));
	options.format = "tecplot";
	const auto wrong = read::readInputs({path}, options, nullptr);
	ASSERT_FALSE(wrong);
	EXPECT_EQ(wrong.error().kind, ErrorKind::input);
}
