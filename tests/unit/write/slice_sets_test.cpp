#include "sample_slice.h"

#include "write/slice_file.h"
#include "write/slice_sets.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>

namespace vp::test
{

namespace
{

class SliceSets : public testing::Test
{
protected:
	SampleSlice sample_ = sampleSlice();
	TemporaryFolder folder_;
};

} // namespace

TEST_F(SliceSets, MultiblockHoldsASheetABlock)
{
	ASSERT_TRUE(write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "a <&> b.vtm"));
	vtkNew<vtkXMLMultiBlockDataReader> reader;
	reader->SetFileName((folder_ / "a <&> b.vtm").c_str());
	reader->Update();
	auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
	ASSERT_TRUE(blocks);
	ASSERT_EQ(blocks->GetNumberOfBlocks(), 2u);
	for (unsigned sheet = 0; sheet < 2; ++sheet)
	{
		auto* data = vtkPolyData::SafeDownCast(blocks->GetBlock(sheet));
		ASSERT_TRUE(data) << sheet;
		EXPECT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(sample_.meshes[sheet].positions.size()));
		EXPECT_EQ(data->GetNumberOfPolys(), static_cast<vtkIdType>(sample_.meshes[sheet].polygons()));
		EXPECT_EQ(data->GetCellData()->GetArray("vprobe:sheet")->GetTuple1(0), sheet);
		EXPECT_EQ(blocks->GetMetaData(sheet)->Get(vtkCompositeDataSet::NAME()), "sheet " + std::to_string(sheet));
	}
}

// A collection is ParaView's own format; its parts are VTK's.
TEST_F(SliceSets, CollectionHoldsAFileAFrame)
{
	Result<write::SliceSeries> series = write::SliceSeries::create(folder_ / "out.pvd");
	ASSERT_TRUE(series);
	for (const int frame : {0, 1, 10000})
		ASSERT_TRUE(series->add(frame, std::nullopt, write::tabulate(sample_.blocks, sample_.meshes)));
	EXPECT_FALSE(std::filesystem::exists(folder_ / "out.pvd"));
	EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
	ASSERT_TRUE(series->commit());

	vtkNew<vtkXMLDataParser> parser;
	parser->SetFileName((folder_ / "out.pvd").c_str());
	ASSERT_TRUE(parser->Parse());
	EXPECT_STREQ(parser->GetRootElement()->GetAttribute("type"), "Collection");
	vtkXMLDataElement* entries = parser->GetRootElement()->FindNestedElementWithName("Collection");
	ASSERT_TRUE(entries);
	ASSERT_EQ(entries->GetNumberOfNestedElements(), 3);
	const std::vector<std::string> times{"0", "1", "10000"};
	for (int i = 0; i < 3; ++i)
	{
		vtkXMLDataElement* entry = entries->GetNestedElement(i);
		EXPECT_EQ(entry->GetAttribute("timestep"), times[static_cast<std::size_t>(i)]);
		vtkNew<vtkXMLPolyDataReader> reader;
		reader->SetFileName((folder_ / entry->GetAttribute("file")).c_str());
		reader->Update();
		EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), static_cast<vtkIdType>(sample_.polygons()));
	}
}

TEST_F(SliceSets, WithoutCommitNothingIsLeft)
{
	{
		Result<write::SliceSeries> series = write::SliceSeries::create(folder_ / "out.pvd");
		ASSERT_TRUE(series);
		ASSERT_TRUE(series->add(0, std::nullopt, write::tabulate(sample_.blocks, sample_.meshes)));
	}
	EXPECT_EQ(folder_.files(), 0u);
}

// The last step fails: what was moved into place is taken back, what was there before stays.
TEST_F(SliceSets, AFailureAtTheEndIsUndone)
{
	std::filesystem::create_directory(folder_ / "out");
	writeText(folder_ / "out/notes", "mine");
	std::filesystem::create_directories(folder_ / "out/frame_0001.vtp/x"); // nothing can take this name
	const Status committed = [&]
	{
		write::SliceSeries series = std::move(write::SliceSeries::create(folder_ / "out.pvd").value());
		EXPECT_TRUE(series.add(0, std::nullopt, write::tabulate(sample_.blocks, sample_.meshes)));
		EXPECT_TRUE(series.add(1, std::nullopt, write::tabulate(sample_.blocks, sample_.meshes)));
		return series.commit();
	}();
	ASSERT_FALSE(committed);
	EXPECT_EQ(committed.error().kind, ErrorKind::output);
	EXPECT_NE(committed.error().message.find("frame_0001.vtp"), std::string::npos) << committed.error().message;
	EXPECT_FALSE(std::filesystem::exists(folder_ / "out/frame_0000.vtp"));
	EXPECT_FALSE(std::filesystem::exists(folder_ / "out.pvd"));
	EXPECT_EQ(readText(folder_ / "out/notes"), "mine");
}

TEST_F(SliceSets, AFileInTheFoldersPlace)
{
	writeText(folder_ / "out", "mine");
	const Status written = write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "out.vtm");
	ASSERT_FALSE(written);
	EXPECT_EQ(written.error().kind, ErrorKind::output);
	EXPECT_EQ(readText(folder_ / "out"), "mine");
	EXPECT_EQ(folder_.files(), 1u);
}

} // namespace vp::test
