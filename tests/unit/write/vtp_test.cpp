#include "sample_slice.h"

#include "mesh/mesh_values.h"
#include "write/slice_file.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkVariant.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>

namespace vp::test
{

namespace
{

class VtpTest : public testing::Test
{
protected:
	void read(const std::string& path)
	{
		reader_->SetFileName(path.c_str());
		reader_->Update();
		data_ = reader_->GetOutput();
		ASSERT_NE(data_, nullptr);
	}
	vtkDataArray* pointArray(const char* name) { return data_->GetPointData()->GetArray(name); }
	vtkDataArray* cellArray(const char* name) { return data_->GetCellData()->GetArray(name); }

	SampleSlice sample_ = sampleSlice();
	TemporaryFolder folder_;
	vtkNew<vtkXMLPolyDataReader> reader_;
	vtkPolyData* data_ = nullptr;
};

} // namespace

TEST_F(VtpTest, HoldsTheMesh)
{
	ASSERT_TRUE(write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "cut.vtp"));
	read(folder_ / "cut.vtp");
	ASSERT_EQ(data_->GetNumberOfPoints(), static_cast<vtkIdType>(sample_.vertices()));
	ASSERT_EQ(data_->GetNumberOfPolys(), static_cast<vtkIdType>(sample_.polygons()));
	vtkIdType point = 0;
	vtkIdType polygon = 0;
	vtkNew<vtkIdList> corners;
	for (const mesh::SheetMesh& mesh : sample_.meshes)
	{
		const vtkIdType base = point;
		for (const Vec3& position : mesh.positions)
		{
			double read[3];
			data_->GetPoint(point++, read);
			EXPECT_EQ(Vec3(read[0], read[1], read[2]), position);
		}
		for (std::size_t p = 0; p < mesh.polygons(); ++p)
		{
			data_->GetPolys()->GetCellAtId(polygon++, corners);
			ASSERT_EQ(corners->GetNumberOfIds(), static_cast<vtkIdType>(mesh.polygon(p).size()));
			for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
				EXPECT_EQ(corners->GetId(i), base + static_cast<vtkIdType>(mesh.polygon(p)[i]));
		}
	}
}

TEST_F(VtpTest, TellsWhereEachPolygonComesFrom)
{
	ASSERT_TRUE(write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "cut.vtp"));
	read(folder_ / "cut.vtp");
	ASSERT_TRUE(cellArray("vprobe:cell") && cellArray("vprobe:block") && cellArray("vprobe:sheet"));
	vtkIdType polygon = 0;
	for (std::size_t sheet = 0; sheet < sample_.meshes.size(); ++sheet)
		for (const mesh::BlockCell& from : sample_.meshes[sheet].polygon_cells)
		{
			const std::size_t source =
			    std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(from.cell)); },
			               sample_.blocks.blocks[from.block].grid);
			EXPECT_EQ(cellArray("vprobe:cell")->GetTuple1(polygon), static_cast<double>(source));
			EXPECT_EQ(cellArray("vprobe:block")->GetTuple1(polygon), from.block);
			EXPECT_EQ(cellArray("vprobe:sheet")->GetTuple1(polygon), static_cast<double>(sheet));
			++polygon;
		}
}

TEST_F(VtpTest, InterpolatesPointArrays)
{
	ASSERT_TRUE(write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "cut.vtp"));
	read(folder_ / "cut.vtp");
	ASSERT_TRUE(pointArray("s") && pointArray("v") && pointArray("level"));
	EXPECT_EQ(pointArray("s")->GetDataType(), VTK_DOUBLE); // float32 in one block, float64 in the other
	EXPECT_EQ(pointArray("v")->GetDataType(), VTK_FLOAT);
	EXPECT_EQ(pointArray("v")->GetNumberOfComponents(), 3);
	EXPECT_EQ(pointArray("level")->GetDataType(), VTK_FLOAT); // 16 bits fit
	vtkIdType point = 0;
	for (const mesh::SheetMesh& mesh : sample_.meshes)
		for (const mesh::EdgePoint& edge : mesh.edges)
		{
			const grid::Block& block = sample_.blocks.blocks[edge.block];
			EXPECT_EQ(pointArray("s")->GetTuple1(point), mesh::interpolate(block, block.fields[0], 0, edge));
			for (int c = 0; c < 3; ++c)
				EXPECT_EQ(static_cast<float>(pointArray("v")->GetComponent(point, c)),
				          static_cast<float>(mesh::interpolate(block, block.fields[1], c, edge)));
			EXPECT_EQ(std::isnan(pointArray("level")->GetTuple1(point)), edge.block == 1);
			++point;
		}
}

TEST_F(VtpTest, KeepsTheTypeOfCategories)
{
	for (grid::Block& block : sample_.blocks.blocks)
	{
		const std::size_t points = std::visit([](const auto& grid) { return grid.pointCount(); }, block.grid);
		std::vector<std::int64_t> ids(points);
		for (std::size_t p = 0; p < points; ++p)
			ids[p] = static_cast<std::int64_t>(1000 * p);
		block.fields.push_back(grid::makeField("GlobalNodeId", grid::Association::point, 1, std::move(ids)));
		grid::finishBlock(block);
	}
	ASSERT_TRUE(write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "cut.vtp"));
	read(folder_ / "cut.vtp");
	vtkDataArray* ids = pointArray("GlobalNodeId");
	ASSERT_TRUE(ids);
	EXPECT_EQ(ids->GetDataTypeSize(), 8);
	EXPECT_NE(ids->GetDataType(), VTK_DOUBLE);
	for (vtkIdType v = 0; v < ids->GetNumberOfTuples(); ++v)
		EXPECT_EQ(std::fmod(ids->GetTuple1(v), 1000.0), 0.0);
}

TEST_F(VtpTest, KeepsCellArrays)
{
	ASSERT_TRUE(write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "cut.vtp"));
	read(folder_ / "cut.vtp");
	vtkDataArray* ids = cellArray("id");
	ASSERT_TRUE(ids);
	EXPECT_EQ(ids->GetDataTypeSize(), 8);
	ASSERT_TRUE(cellArray("flag") && cellArray(kOddName));
	EXPECT_EQ(cellArray("flag")->GetDataType(), VTK_UNSIGNED_CHAR);
	EXPECT_EQ(cellArray(kOddName)->GetNumberOfComponents(), 2);
	for (vtkIdType p = 0; p < data_->GetNumberOfPolys(); ++p)
	{
		const auto source = static_cast<std::int64_t>(cellArray("vprobe:cell")->GetTuple1(p));
		const bool first_block = cellArray("vprobe:block")->GetTuple1(p) == 0;
		EXPECT_EQ(ids->GetVariantValue(p).ToTypeInt64(), first_block ? kFirstId + source : 0);
		EXPECT_EQ(cellArray("flag")->GetTuple1(p), static_cast<double>(first_block ? 200 + source % 50 : 7));
		const double odd = cellArray(kOddName)->GetComponent(p, 0);
		EXPECT_TRUE(first_block ? odd == 0.1 * static_cast<double>(source) : std::isnan(odd));
	}
}

TEST_F(VtpTest, AnyNameComesThrough)
{
	std::vector<grid::Field>& fields = sample_.blocks.blocks[0].fields;
	fields[0].name = "<s> & 'co' \"é\""; // in XML, these have a meaning
	fields[1].name = "line\nend \xFF";   // these may not be there
	ASSERT_TRUE(write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "cut.vtp"));
	read(folder_ / "cut.vtp");
	EXPECT_TRUE(pointArray(fields[0].name.c_str()));
	EXPECT_TRUE(pointArray("line_end _"));
}

TEST_F(VtpTest, AnEmptySliceIsAFileToo)
{
	sample_.meshes.assign(1, {});
	sample_.meshes[0].polygon_starts.push_back(0);
	ASSERT_TRUE(write::writeSlice(sample_.blocks, sample_.meshes, folder_ / "cut.vtp"));
	read(folder_ / "cut.vtp");
	EXPECT_EQ(data_->GetNumberOfPoints(), 0);
	EXPECT_EQ(data_->GetNumberOfPolys(), 0);
}

} // namespace vp::test
