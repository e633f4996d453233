#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace vp;
using namespace vp::read;

namespace
{

namespace fs = std::filesystem;

// Text of elements that lie in each other, `count` deep.
std::string nested(std::size_t count, const std::string& begin, const std::string& end)
{
	std::string text;
	for (std::size_t i = 0; i < count; ++i)
		text += begin;
	for (std::size_t i = 0; i < count; ++i)
		text += end;
	return text;
}

std::string xml(const std::string& type, const std::string& contents)
{
	return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" version=\"1.0\"><" + type + ">" + contents + "</" +
	       type + "></VTKFile>\n";
}

std::string errorOfNested(const std::string& file)
{
	const auto set = readInputs({file}, {}, nullptr);
	return set ? "" : set.error().message;
}

} // namespace

// VTK's parser would take two kilobytes for each element.
TEST(Nesting, OfXmlEndsWhereNoWriterGoes)
{
	const TemporaryFolder folder;
	const auto writeNested = [&](const std::string& name, const std::string& type, std::size_t count)
	{
		const std::string file = folder / name;
		writeContents(file, xml(type, nested(count, "<Block>", "</Block>")));
		return file;
	};
	for (const auto& [name, type] : {std::pair{"a.vtu", "UnstructuredGrid"},
	                                 {"a.vti", "ImageData"},
	                                 {"a.pvtu", "PUnstructuredGrid"},
	                                 {"a.vtm", "vtkMultiBlockDataSet"},
	                                 {"a.pvd", "Collection"}})
	{
		// Two elements are about them.
		const std::string deep = writeNested(name, type, 255);
		EXPECT_EQ(errorOfNested(deep), deep + ": truncated or damaged: its XML elements are nested more than 256 deep");
		EXPECT_EQ(errorOfNested(writeNested(name, type, 254)).find("256"), std::string::npos) << name;
	}
	const std::string huge = writeNested("huge.vtu", "UnstructuredGrid", 1'000'000);
	EXPECT_EQ(errorOfNested(huge), huge + ": truncated or damaged: its XML elements are nested more than 256 deep");
	// The piece of an index, in a comment that looks as if elements ended.
	const std::string piece = folder / "piece.vtu";
	writeContents(piece, xml("UnstructuredGrid", nested(255, "<a><!-- </a> -->", "</a>")));
	writeContents(folder / "index.pvtu", xml("PUnstructuredGrid", "<Piece Source=\"piece.vtu\"/>"));
	EXPECT_NE(errorOfNested(folder / "index.pvtu").find("nested more than 256 deep"), std::string::npos);
}

TEST(Nesting, OfJsonEndsWhereNoWriterGoes)
{
	const TemporaryFolder folder;
	fs::create_directories(folder / "a.zarr");
	writeContents(folder / "a.zarr/.zgroup", "{\"zarr_format\": 2}");
	const auto errors = [&](std::size_t count)
	{
		const std::string lists = nested(count, "[", "]");
		writeContents(folder / "a.vtu.series", "{\"files\": [], \"more\": " + lists + "}");
		writeContents(folder / "a.zarr/.zattrs", "{\"more\": " + lists + "}");
		return std::vector{errorOfNested(folder / "a.vtu.series"), errorOfNested(folder / "a.zarr")};
	};
	for (const std::string& error : errors(256))
		EXPECT_NE(error.find("its JSON is nested more than 256 deep"), std::string::npos) << error;
	for (const std::string& error : errors(255))
		EXPECT_NE(error.find("nothing to slice"), std::string::npos) << error;
}
