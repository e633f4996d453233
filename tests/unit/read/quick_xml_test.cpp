// Plain VTK XML files are read without VTK: to the same blocks, bit by bit, as with it.
#include "handed_over.h"
#include "sample_files.h"
#include "tries.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStringArray.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataSetWriter.h>

#include <cmath>
#include <random>

using namespace vp;
using nlohmann::json;

namespace
{

// More than one part of an array for each thread, and many blocks of VTK's compressors.
constexpr std::array<int, 3> kPoints = {31, 27, 25};

template <class Array>
void addArray(vtkFieldData* to, const char* name, int components, vtkIdType tuples)
{
	vtkNew<Array> array;
	array->SetName(name);
	array->SetNumberOfComponents(components);
	array->SetNumberOfTuples(tuples);
	for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
		array->SetValue(i,
		                static_cast<typename Array::ValueType>(60.0 + 60.0 * std::sin(0.001 * static_cast<double>(i))));
	to->AddArray(array);
}

template <class Data>
vtkSmartPointer<vtkDataSet> withManyArrays(Data data)
{
	addArray<vtkFloatArray>(data->GetPointData(), "s", 1, data->GetNumberOfPoints());
	addArray<vtkDoubleArray>(data->GetPointData(), "v", 3, data->GetNumberOfPoints());
	addArray<vtkIntArray>(data->GetCellData(), "c", 1, data->GetNumberOfCells());
	addArray<vtkUnsignedCharArray>(data->GetCellData(), "s", 1, data->GetNumberOfCells());
	addArray<vtkDoubleArray>(data->GetFieldData(), "TimeValue", 1, 1);
	return data;
}

std::array<double, 3> placeOf(int i, int j, int k)
{
	return {i + 0.1 * std::sin(j), j + 0.1 * k, k + 0.2 * std::cos(i)};
}

vtkSmartPointer<vtkPoints> places(int type)
{
	auto points = vtkSmartPointer<vtkPoints>::New();
	points->SetDataType(type);
	for (int k = 0; k < kPoints[2]; ++k)
		for (int j = 0; j < kPoints[1]; ++j)
			for (int i = 0; i < kPoints[0]; ++i)
				points->InsertNextPoint(placeOf(i, j, k).data());
	return points;
}

// 'a': all hexahedra; 'm': some of them two wedges; 'f': also a triangle, behind the others.
vtkSmartPointer<vtkUnstructuredGrid> cellsOf(char kind)
{
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	grid->SetPoints(places(kind == 'm' ? VTK_DOUBLE : VTK_FLOAT));
	const auto id = [](int i, int j, int k) { return (vtkIdType(k) * kPoints[1] + j) * kPoints[0] + i; };
	for (int k = 0; k + 1 < kPoints[2]; ++k)
		for (int j = 0; j + 1 < kPoints[1]; ++j)
			for (int i = 0; i + 1 < kPoints[0]; ++i)
			{
				const std::array<vtkIdType, 8> p = {
				    id(i, j, k),     id(i + 1, j, k),     id(i + 1, j + 1, k),     id(i, j + 1, k),
				    id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)};
				if (kind == 'a' || i % 3 != 1)
				{
					grid->InsertNextCell(VTK_HEXAHEDRON, 8, p.data());
					continue;
				}
				const std::array<vtkIdType, 6> low = {p[0], p[2], p[1], p[4], p[6], p[5]};
				const std::array<vtkIdType, 6> high = {p[0], p[3], p[2], p[4], p[7], p[6]};
				grid->InsertNextCell(VTK_WEDGE, 6, low.data());
				grid->InsertNextCell(VTK_WEDGE, 6, high.data());
			}
	const std::array<vtkIdType, 3> corner = {0, 1, kPoints[0]};
	if (kind == 'f')
		grid->InsertNextCell(VTK_TRIANGLE, 3, corner.data());
	return grid;
}

vtkSmartPointer<vtkDataSet> dataOf(const std::string& kind)
{
	if (kind == "image")
	{
		vtkNew<vtkImageData> image;
		image->SetExtent(-3, kPoints[0] - 4, 0, kPoints[1] - 1, 7, kPoints[2] + 6);
		image->SetOrigin(0.1, 1e-3, -2.0 / 3.0);
		image->SetSpacing(0.3, 1.0 / 7.0, 2e-5);
		return withManyArrays(vtkSmartPointer<vtkImageData>(image));
	}
	if (kind == "rectilinear")
	{
		vtkNew<vtkRectilinearGrid> grid;
		grid->SetDimensions(kPoints.data());
		vtkNew<vtkFloatArray> x;
		std::array<vtkNew<vtkDoubleArray>, 2> others;
		for (int i = 0; i < kPoints[0]; ++i)
			x->InsertNextValue(static_cast<float>(0.1 * i * i));
		for (int axis = 1; axis < 3; ++axis)
			for (int i = 0; i < kPoints[axis]; ++i)
				others[axis - 1]->InsertNextValue(0.1 * i * i + axis);
		grid->SetXCoordinates(x);
		grid->SetYCoordinates(others[0]);
		grid->SetZCoordinates(others[1]);
		return withManyArrays(vtkSmartPointer<vtkRectilinearGrid>(grid));
	}
	if (kind == "curvilinear")
	{
		vtkNew<vtkStructuredGrid> grid;
		grid->SetDimensions(kPoints.data());
		grid->SetPoints(places(VTK_FLOAT));
		return withManyArrays(vtkSmartPointer<vtkStructuredGrid>(grid));
	}
	return withManyArrays(cellsOf(kind[0]));
}

struct Way
{
	int mode;     // data mode of vtkXMLWriter
	bool encoded; // appended data in base64
	int compressor;
	int header;
	int ids;
};

void writeXml(vtkDataSet* data, const std::string& path, const Way& way)
{
	vtkNew<vtkXMLDataSetWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(data);
	writer->SetDataMode(way.mode);
	writer->SetEncodeAppendedData(way.encoded);
	writer->SetCompressorType(way.compressor);
	writer->SetHeaderType(way.header);
	writer->SetIdType(way.ids);
	ASSERT_TRUE(writer->Write());
}

class QuickXml : public testing::TestWithParam<const char*>
{
protected:
	TemporaryFolder folder_;
};

} // namespace

TEST_P(QuickXml, GivesWhatVtkGives)
{
	using Writer = vtkXMLWriterBase;
	const vtkSmartPointer<vtkDataSet> data = dataOf(GetParam());
	test::Taken taken;
	for (const Way& way : {Way{Writer::Appended, false, Writer::NONE, Writer::UInt32, Writer::Int64},
	                       Way{Writer::Appended, false, Writer::NONE, Writer::UInt64, Writer::Int32},
	                       Way{Writer::Appended, false, Writer::ZLIB, Writer::UInt64, Writer::Int32},
	                       Way{Writer::Appended, false, Writer::ZLIB, Writer::UInt32, Writer::Int64},
	                       Way{Writer::Appended, false, Writer::LZ4, Writer::UInt32, Writer::Int64},
	                       Way{Writer::Appended, false, Writer::LZMA, Writer::UInt32, Writer::Int64},
	                       Way{Writer::Appended, true, Writer::NONE, Writer::UInt32, Writer::Int64},
	                       Way{Writer::Appended, true, Writer::ZLIB, Writer::UInt64, Writer::Int32},
	                       Way{Writer::Binary, false, Writer::NONE, Writer::UInt64, Writer::Int64},
	                       Way{Writer::Binary, false, Writer::ZLIB, Writer::UInt32, Writer::Int32},
	                       Way{Writer::Binary, false, Writer::LZ4, Writer::UInt64, Writer::Int64}})
	{
		if (!taken.next())
			continue;
		SCOPED_TRACE(testing::Message() << "mode " << way.mode << way.encoded << ", compressor " << way.compressor
		                                << ", header " << way.header << ", ids " << way.ids);
		const std::string path = folder_ / "a.vtx";
		writeXml(data, path, way);
		EXPECT_TRUE(isReadQuickly(path));
		EXPECT_EQ(json::diff(handedOver(path), handedOverByVtk(path)), json::array());
	}
}

TEST_P(QuickXml, HandsOverWhatIsWished)
{
	const vtkSmartPointer<vtkDataSet> data = dataOf(GetParam());
	const std::string path = folder_ / "a.vtx";
	writeXml(data, path, {vtkXMLWriterBase::Appended, false, 0, 32, 64});
	using Names = std::vector<std::string>;
	struct
	{
		Names names;
		bool first;
		Names given;
		Names left_out;
	} cases[] = {{{}, false, {}, {"point:s", "point:v", "cell:c", "cell:s"}},
	             {{}, true, {"point:s"}, {"point:v", "cell:c", "cell:s"}},
	             {{"s"}, false, {"point:s", "cell:s"}, {"point:v", "cell:c"}},
	             {{"cell:s", "v"}, false, {"point:v", "cell:s"}, {"point:s", "cell:c"}},
	             {{"cell:c", "none"}, true, {"point:s", "cell:c"}, {"point:v", "cell:s"}}};
	for (const auto& [names, first, given, left_out] : cases)
	{
		read::ReadOptions options;
		options.arrays = {false, names, first};
		EXPECT_EQ(json::diff(handedOver(path, options), handedOverByVtk(path, options)), json::array());
		const auto set = read::readInputs({path}, options, nullptr);
		ASSERT_TRUE(set) << set.error().message;
		Names fields;
		for (const grid::Field& field : set->blocks[0].fields)
			fields.push_back(std::string(grid::associationName(field.association)) + ":" + field.name);
		EXPECT_EQ(fields, given);
		EXPECT_EQ(set->blocks[0].arrays_left_out, left_out);
	}
}

// Returns what was handed over without the numbers of its arrays.
json withoutContents(json handed)
{
	if (handed.is_object())
		handed.erase("offset");
	for (json& part : handed)
		if (part.is_structured())
			part = withoutContents(std::move(part));
	return handed;
}

// Whatever a byte of the file becomes: both ways refuse it with the same code, or give the same. Of a damaged head only
// what arrays there are: VTK refuses it for words that the quick way does not look at, and gives what was in memory
// before where an array's place is not that of an array.
TEST_P(QuickXml, IsRefusedAsByVtkWhereItIsDamaged)
{
	const vtkSmartPointer<vtkDataSet> data = dataOf(GetParam());
	std::mt19937 random(7);
	for (const int compressor : {vtkXMLWriterBase::NONE, vtkXMLWriterBase::ZLIB})
	{
		const std::string path = folder_ / "a.vtx";
		writeXml(data, path, {vtkXMLWriterBase::Appended, false, compressor, 32, 64});
		const std::string whole = contentsOf(path);
		const std::size_t head = whole.find("<AppendedData");
		for (int i = 8 - test::tries(8); i < 8; ++i)
		{
			std::string text = whole;
			const bool in_head = i % 2 == 0;
			const std::size_t at = in_head ? random() % head : head + random() % (text.size() - head);
			text[at] = in_head ? "0 9<>\"-x"[random() % 8] : static_cast<char>(random());
			if (i == 7)
				text.resize(head + (text.size() - head) / 2);
			writeContents(path, text);
			json quick = handedOver(path);
			json slow = handedOverByVtk(path);
			for (json* each : {&quick, &slow})
				if (each->contains("error"))
					(*each)["error"] = "with VTK's words, which have addresses in them";
			SCOPED_TRACE(testing::Message()
			             << "byte " << at << " of " << text.size() << ": " << whole.substr(at < 40 ? 0 : at - 40, 80));
			if (in_head && slow.contains("error") && !quick.contains("error"))
				continue;
			if (in_head)
				for (json* each : {&quick, &slow})
					*each = withoutContents(std::move(*each));
			EXPECT_EQ(json::diff(quick, slow), json::array());
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Read, QuickXml,
                         testing::Values("image", "rectilinear", "curvilinear", "alike", "mixed", "flat"),
                         [](const auto& info) { return std::string(info.param); });
