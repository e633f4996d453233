// Hidden is hidden: blanked and ghost cells of lattices, coarse cells under finer boxes; and times of collections.
#include "read/read.h"
#include "sample_files.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>

using namespace vp;

namespace
{

// n^3 cells of size h, with f at the points, and the cells' numbers in "number"; marks: cell or point to ghost bits.
void writeImage(const std::string& path, int n, double h, const std::map<int, int>& cells = {},
                const std::map<int, int>& points = {})
{
	vtkNew<vtkImageData> image;
	image->SetDimensions(n + 1, n + 1, n + 1);
	image->SetSpacing(h, h, h);
	vtkNew<vtkDoubleArray> f;
	f->SetName("f");
	for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
	{
		const double* at = image->GetPoint(p);
		f->InsertNextValue(sampleValue({at[0], at[1], at[2]}));
	}
	image->GetPointData()->SetScalars(f);
	vtkNew<vtkDoubleArray> number;
	number->SetName("number");
	for (vtkIdType c = 0; c < image->GetNumberOfCells(); ++c)
		number->InsertNextValue(static_cast<double>(c));
	image->GetCellData()->AddArray(number);
	const auto mark = [](vtkDataSetAttributes* attributes, vtkIdType count, const std::map<int, int>& marks)
	{
		if (marks.empty())
			return;
		vtkNew<vtkUnsignedCharArray> ghosts;
		ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
		ghosts->SetNumberOfValues(count);
		ghosts->FillValue(0);
		for (const auto& [id, bits] : marks)
			ghosts->SetValue(id, static_cast<unsigned char>(bits));
		attributes->AddArray(ghosts);
	};
	mark(image->GetCellData(), image->GetNumberOfCells(), cells);
	mark(image->GetPointData(), image->GetNumberOfPoints(), points);
	vtkNew<vtkXMLImageDataWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(image);
	writer->Write();
}

Result<grid::BlockSet> readQuietly(const std::string& path, const std::string& time = "last")
{
	read::ReadOptions options;
	options.time = *read::parseTime(time);
	return read::readInputs({path}, options, nullptr);
}

std::size_t visible(const std::string& path)
{
	const auto set = readQuietly(path);
	EXPECT_TRUE(set) << set.error().message;
	return set ? set->cellCount() : 0;
}

} // namespace

TEST(HiddenCells, OfALatticeAreLeftOut)
{
	const TemporaryFolder folder;
	writeImage(folder / "cells.vti", 3, 1.0, {{0, 1}, {5, 8}, {13, 32}, {20, 2}}); // 2 is not about being shown
	const auto set = readQuietly(folder / "cells.vti");
	ASSERT_TRUE(set) << set.error().message;
	EXPECT_STREQ(set->kind(), "unstructured");
	EXPECT_EQ(set->cellCount(), 24u);
	const grid::Block& block = set->blocks.at(0);
	EXPECT_NO_THROW(grid::validate(block));
	ASSERT_EQ(block.fields.size(), 2u); // without the marks
	std::visit(
	    [&](const auto& grid)
	    {
		    for (std::size_t c = 0; c < grid.cellCount(); ++c)
		    {
			    const auto cell = static_cast<CellId>(c);
			    Vec3 middle(0.0);
			    for (const PointId id : grid.cellPoints(cell))
			    {
				    middle += grid.point(id) / 8.0;
				    EXPECT_EQ(block.fields[0].value(grid.sourcePoint(id), 0), sampleValue(grid.point(id)));
			    }
			    const double number = std::floor(middle.x) + 3 * std::floor(middle.y) + 9 * std::floor(middle.z);
			    EXPECT_EQ(block.fields[1].value(grid.sourceCell(cell), 0), number);
			    EXPECT_TRUE(number != 0 && number != 5 && number != 13);
		    }
	    },
	    block.grid);
}

TEST(HiddenCells, AreThoseAtBlankedPoints)
{
	const TemporaryFolder folder;
	writeImage(folder / "inner.vti", 3, 1.0, {}, {{1 + 4 + 16, 2}});
	EXPECT_EQ(visible(folder / "inner.vti"), 27u - 8u);
	writeImage(folder / "corner.vti", 3, 1.0, {{0, 32}, {1, 32}}, {{0, 2}, {63, 2}});
	EXPECT_EQ(visible(folder / "corner.vti"), 27u - 3u);
}

TEST(HiddenCells, AreThoseAtPointsThatPlot3dBlanks)
{
	const TemporaryFolder folder;
	std::string bytes;
	const auto put = [&](auto number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); };
	for (const std::int32_t count : {1, 4, 4, 4})
		put(count);
	for (int axis = 0; axis < 3; ++axis)
		for (int p = 0; p < 64; ++p)
			put(static_cast<float>(axis == 0 ? p % 4 : axis == 1 ? p / 4 % 4 : p / 16));
	for (int p = 0; p < 64; ++p)
		put(std::int32_t(p == 21 ? 0 : p == 63 ? -2 : 1)); // an inner point; -2 names a neighbor, and is shown
	writeContents(folder / "blanked.xyz", bytes);
	EXPECT_EQ(visible(folder / "blanked.xyz"), 27u - 8u);
}

TEST(HiddenCells, OfNoEffectLeaveTheLattice)
{
	const TemporaryFolder folder;
	writeImage(folder / "a.vti", 3, 1.0, {{0, 2}}, {{0, 1}});
	const auto set = readQuietly(folder / "a.vti");
	ASSERT_TRUE(set);
	EXPECT_STREQ(set->kind(), "image");

	std::map<int, int> all;
	for (int c = 0; c < 27; ++c)
		all[c] = 32;
	writeImage(folder / "none.vti", 3, 1.0, all);
	EXPECT_FALSE(readQuietly(folder / "none.vti"));
}

TEST(Amr, CoarseCellsUnderFinerBoxesAreHidden)
{
	const TemporaryFolder folder;
	writeImage(folder / "coarse.vti", 4, 1.0);
	writeImage(folder / "fine.vti", 4, 0.5);
	const std::string head = R"(<VTKFile type="vtkOverlappingAMR" version="1.1" byte_order="LittleEndian">
<vtkOverlappingAMR origin="0 0 0" grid_description="XYZ">
<Block level="0" spacing="1 1 1"><DataSet index="0" amr_box="0 3 0 3 0 3" file="coarse.vti"/></Block>
)";
	const std::string fine = R"(<Block level="1" spacing="0.5 0.5 0.5"><DataSet index="0" amr_box=")";
	const std::string tail = R"(" file="fine.vti"/></Block></vtkOverlappingAMR></VTKFile>
)";
	writeContents(folder / "a.vth", head + fine + "0 3 0 3 0 3" + tail);
	EXPECT_EQ(visible(folder / "a.vth"), 64u - 8u + 64u);
	writeContents(folder / "a.vth", head + fine + "1 4 0 3 0 3" + tail); // across coarse cells
	EXPECT_EQ(visible(folder / "a.vth"), 64u - 12u + 64u);
	writeContents(folder / "a.vth", head + fine + "-4 -1 0 3 0 3" + tail); // beside the coarse box
	EXPECT_EQ(visible(folder / "a.vth"), 64u + 64u);

	for (const std::string box : {"0 3 0 3 0 4", "0 3 0 3", "", "3 0 3 0 3 0", "-2147483648 2147483647 0 3 0 3"})
	{
		writeContents(folder / "a.vth", head + fine + box + tail);
		const auto set = readQuietly(folder / "a.vth");
		ASSERT_FALSE(set) << box;
		EXPECT_EQ(set.error().kind, ErrorKind::input);
	}
}

TEST(Indices, ThatNameThemselvesOrNothingAreRefused)
{
	const TemporaryFolder folder;
	const auto collection = [](const std::string& file)
	{
		return R"(<VTKFile type="Collection" version="0.1"><Collection><DataSet timestep="0" file=")" + file +
		       R"("/></Collection></VTKFile>)";
	};
	writeContents(folder / "a.pvd", collection("a.pvd"));
	EXPECT_FALSE(readQuietly(folder / "a.pvd"));
	writeContents(folder / "a.pvd", collection("absent.vtu"));
	EXPECT_FALSE(readQuietly(folder / "a.pvd"));
	writeContents(folder / "a.vtm", R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<DataSet index="0" file="a.vtm"/></vtkMultiBlockDataSet></VTKFile>)");
	EXPECT_FALSE(readQuietly(folder / "a.vtm"));
	for (const char* text : {"{", "{}", "{\"files\": [{\"name\": \"a.vti\"}]}", "{\"files\": []}", "[1]"})
	{
		writeContents(folder / "a.series", text);
		EXPECT_FALSE(readQuietly(folder / "a.series")) << text;
	}
}

TEST(Indices, OfferTimesByValueAndNumber)
{
	const TemporaryFolder folder;
	for (const int n : {1, 2, 3})
		writeImage(folder / (std::to_string(n) + ".vti"), n, 1.0);
	writeContents(folder / "a.series", R"({"files": [{"name": "2.vti", "time": 0.25}, {"name": "1.vti", "time": -1},
{"name": "3.vti", "time": 7}]})");
	const auto cells = [&](const std::string& time) { return readQuietly(folder / "a.series", time)->cellCount(); };
	EXPECT_EQ(readQuietly(folder / "a.series")->times, (std::vector<double>{-1, 0.25, 7}));
	EXPECT_EQ(cells("first"), 1u);
	EXPECT_EQ(cells("last"), 27u);
	EXPECT_EQ(cells("0.3"), 8u);
	EXPECT_EQ(cells("#0"), 1u);
	EXPECT_EQ(cells("#1"), 8u);
	EXPECT_EQ(cells("#2"), 27u);
	const auto beyond = readQuietly(folder / "a.series", "#3");
	ASSERT_FALSE(beyond);
	EXPECT_EQ(beyond.error().message, folder / "a.series" + ": --time #3: there are 3 times, from #0 to #2");
	EXPECT_FALSE(readQuietly(folder / "1.vti", "#1"));
	EXPECT_TRUE(readQuietly(folder / "1.vti", "#0"));
}
