// Files of polygons, as VTK reads them and as our own parser of VTK XML files does.
#include "sample_slice.h"
#include "vprobe-read/quick/quick_file.h"

#include "write/poly_data.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>

namespace vp::test
{

namespace
{

using grid::NumberType;
using reader::arrays::Scratch;
using reader::quick::ArrayKind;
using reader::quick::onlyChild;
using reader::text::XmlElement;
using write::PolyData;
using write::XmlArray;
using write::xmlArray;

constexpr NumberType kTypes[] = {NumberType::int8,    NumberType::uint8,  NumberType::int16, NumberType::uint16,
                                 NumberType::int32,   NumberType::uint32, NumberType::int64, NumberType::uint64,
                                 NumberType::float32, NumberType::float64};

// Every bit pattern that two bytes can begin with is a value, NaN and infinities among them.
std::vector<std::byte> anyBytes(std::size_t count)
{
	std::vector<std::byte> bytes(count);
	for (std::size_t i = 0; i < count; ++i)
		bytes[i] = static_cast<std::byte>(0x7F + 37 * i * i);
	return bytes;
}

// A dot, two lines and two polygons, with arrays of all types.
class PolyDataFile : public testing::Test
{
protected:
	PolyDataFile()
	{
		data_.points = points_;
		data_.dots = {dot_starts_, dots_};
		data_.lines = {line_starts_, lines_};
		data_.polygons = {polygon_starts_, polygons_};
		for (const NumberType type : kTypes)
			for (const int components : {1, 2, 3, 9})
			{
				const std::size_t tuple = grid::byteSize(type) * static_cast<std::size_t>(components);
				const std::string name = numberTypeName(type) + std::to_string(components);
				kept_.push_back(std::make_unique<std::vector<std::byte>>(anyBytes(points_.size() * tuple)));
				data_.point_arrays.add(xmlArray("p" + name, type, components, *kept_.back()));
				kept_.push_back(std::make_unique<std::vector<std::byte>>(anyBytes(kCells * tuple)));
				data_.cell_arrays.add(xmlArray("c" + name, type, components, *kept_.back()));
			}
		data_.cell_arrays.add(write::xmlTexts("words", words_));
		data_.file_arrays.add(write::xmlTexts("file words", file_words_));
	}

	const std::string& written()
	{
		write::AtomicFile file = std::move(*write::AtomicFile::create(path_));
		writePolyData(data_, file);
		EXPECT_TRUE(file.commit());
		return path_;
	}

	vtkPolyData* readByVtk()
	{
		reader_->SetFileName(written().c_str());
		reader_->Update();
		return reader_->GetOutput();
	}

	static constexpr std::size_t kCells = 5;
	const std::vector<Vec3> points_{{0, 0, 0}, {1, 0, -0.0}, {1, 1, 1e-300}, {0, 1, 1e300}, {0.1, 0.2, 0.3}};
	const std::vector<std::int64_t> dot_starts_{0, 1};
	const std::vector<std::int64_t> dots_{4};
	const std::vector<std::int64_t> line_starts_{0, 2, 5};
	const std::vector<std::int64_t> lines_{0, 1, 4, 3, 2};
	const std::vector<std::int64_t> polygon_starts_{0, 3, 7};
	const std::vector<std::int64_t> polygons_{0, 1, 2, 3, 2, 1, 0};
	const std::string words_ = write::joinTexts(std::array{"inverted", "", "<&> \"é\"", "a b", "z"});
	const std::string file_words_ = write::joinTexts(std::array{"steps", "", "left_grid"});
	std::vector<std::unique_ptr<std::vector<std::byte>>> kept_;
	PolyData data_;
	TemporaryFolder folder_;
	std::string path_ = folder_ / "data.vtp";
	vtkNew<vtkXMLPolyDataReader> reader_;
};

void expectCells(vtkCellArray* read, const write::XmlCells& cells)
{
	ASSERT_EQ(read->GetNumberOfCells(), static_cast<vtkIdType>(cells.count()));
	vtkNew<vtkIdList> ids;
	for (std::size_t c = 0; c < cells.count(); ++c)
	{
		read->GetCellAtId(static_cast<vtkIdType>(c), ids);
		const auto own = cells.ids.subspan(static_cast<std::size_t>(cells.starts[c]),
		                                   static_cast<std::size_t>(cells.starts[c + 1] - cells.starts[c]));
		EXPECT_EQ(std::vector<std::int64_t>(ids->begin(), ids->end()),
		          std::vector<std::int64_t>(own.begin(), own.end()));
	}
}

void expectArrays(vtkFieldData* read, const write::XmlArrays& arrays)
{
	int count = 0;
	for (const XmlArray& array : arrays)
	{
		++count;
		if (!array.type)
		{
			auto* words = vtkStringArray::SafeDownCast(read->GetAbstractArray(array.name.c_str()));
			ASSERT_TRUE(words) << array.name;
			std::string joined;
			for (vtkIdType i = 0; i < words->GetNumberOfValues(); ++i)
				(joined += words->GetValue(i)) += '\0';
			EXPECT_EQ(joined, std::string(reinterpret_cast<const char*>(array.bytes.data()), array.bytes.size()));
			continue;
		}
		vtkDataArray* values = read->GetArray(array.name.c_str());
		ASSERT_TRUE(values) << array.name;
		EXPECT_EQ(values->GetNumberOfComponents(), array.components) << array.name;
		EXPECT_EQ(values->GetNumberOfTuples(), static_cast<vtkIdType>(array.tuples())) << array.name;
		EXPECT_EQ(static_cast<std::size_t>(values->GetDataTypeSize()), grid::byteSize(*array.type)) << array.name;
		const bool is_float = *array.type == NumberType::float32 || *array.type == NumberType::float64;
		EXPECT_EQ(values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE, is_float) << array.name;
		EXPECT_EQ(values->GetDataTypeMin() < 0.0, !std::string(numberTypeName(*array.type)).starts_with('u'));
		EXPECT_EQ(std::memcmp(values->GetVoidPointer(0), array.bytes.data(), array.bytes.size()), 0) << array.name;
	}
	EXPECT_EQ(read->GetNumberOfArrays(), count);
}

// The element's array, as our own reader unpacks it.
std::vector<std::byte> unpacked(const reader::quick::File& file, const XmlElement& element, std::size_t bytes)
{
	const auto packed = file.open(element, bytes);
	EXPECT_EQ(packed->size(), bytes);
	Scratch scratch;
	std::vector<std::byte> all;
	for (std::size_t part = 0; part < packed->partCount(); ++part)
	{
		const auto values = packed->part(part, packed->partBytes(), scratch);
		all.insert(all.end(), values.begin(), values.end());
	}
	return all;
}

const XmlElement& arrayNamed(const XmlElement& parent, std::string_view name)
{
	for (const XmlElement& child : parent.children)
		if (child.attribute("Name") == name)
			return child;
	throw std::runtime_error("no array " + std::string(name));
}

template <class Values>
std::vector<std::byte> bytesOf(const Values& values)
{
	const auto bytes = std::as_bytes(std::span(values));
	return {bytes.begin(), bytes.end()};
}

} // namespace

TEST_F(PolyDataFile, VtkReadsTheSame)
{
	vtkPolyData* read = readByVtk();
	ASSERT_EQ(read->GetNumberOfPoints(), static_cast<vtkIdType>(points_.size()));
	ASSERT_EQ(read->GetPoints()->GetDataType(), VTK_DOUBLE);
	EXPECT_EQ(std::memcmp(read->GetPoints()->GetVoidPointer(0), points_.data(), sizeof(Vec3) * points_.size()), 0);
	expectCells(read->GetVerts(), data_.dots);
	expectCells(read->GetLines(), data_.lines);
	expectCells(read->GetPolys(), data_.polygons);
	EXPECT_EQ(read->GetNumberOfStrips(), 0);
	expectArrays(read->GetPointData(), data_.point_arrays);
	expectArrays(read->GetCellData(), data_.cell_arrays);
	expectArrays(read->GetFieldData(), data_.file_arrays);
}

TEST_F(PolyDataFile, OurReaderFindsTheSame)
{
	const reader::quick::File file(written());
	EXPECT_EQ(file.type(), "PolyData");
	const XmlElement& piece = onlyChild(file.data(), "Piece");
	EXPECT_EQ(piece.attribute("NumberOfPoints"), "5");
	EXPECT_EQ(piece.attribute("NumberOfVerts"), "1");
	EXPECT_EQ(piece.attribute("NumberOfLines"), "2");
	EXPECT_EQ(piece.attribute("NumberOfStrips"), "0");
	EXPECT_EQ(piece.attribute("NumberOfPolys"), "2");
	for (const auto& [element, arrays] :
	     {std::pair{"PointData", &data_.point_arrays}, {"CellData", &data_.cell_arrays}})
		for (const XmlArray& array : *arrays)
		{
			const XmlElement& found = arrayNamed(onlyChild(piece, element), array.name);
			if (array.type)
			{
				EXPECT_EQ(ArrayKind(found).type, *array.type) << array.name;
				EXPECT_EQ(ArrayKind(found).components, static_cast<std::uint32_t>(array.components)) << array.name;
			}
			EXPECT_EQ(unpacked(file, found, array.bytes.size()), bytesOf(array.bytes)) << array.name;
		}
	EXPECT_EQ(unpacked(file, onlyChild(piece, "Points").children[0], sizeof(Vec3) * points_.size()), bytesOf(points_));
	const XmlElement& polygons = onlyChild(piece, "Polys");
	EXPECT_EQ(unpacked(file, arrayNamed(polygons, "connectivity"), 56), bytesOf(polygons_));
	EXPECT_EQ(unpacked(file, arrayNamed(polygons, "offsets"), 16), bytesOf(std::vector<std::int64_t>{3, 7}));
	const XmlElement& words = arrayNamed(onlyChild(file.data(), "FieldData"), "file words");
	EXPECT_EQ(words.attribute("NumberOfTuples"), "3");
	EXPECT_EQ(unpacked(file, words, file_words_.size()), bytesOf(file_words_));
}

TEST_F(PolyDataFile, NothingAtAll)
{
	const std::vector<double> none;
	data_ = {};
	data_.polygons.starts = std::span(polygon_starts_).first(1);
	data_.point_arrays.add(xmlArray("s", NumberType::float64, 1, none));
	data_.cell_arrays.add(write::xmlTexts("words", ""));
	vtkPolyData* read = readByVtk();
	EXPECT_EQ(read->GetNumberOfPoints(), 0);
	EXPECT_EQ(read->GetNumberOfCells(), 0);
	EXPECT_TRUE(read->GetPointData()->GetArray("s"));
	EXPECT_TRUE(read->GetCellData()->GetAbstractArray("words"));
	EXPECT_EQ(arrayNamed(onlyChild(onlyChild(reader::quick::File(path_).data(), "Piece"), "PointData"), "s")
	              .attribute("RangeMin"),
	          "");
}

TEST_F(PolyDataFile, NamesDifferAndTheProgramsOwnComeFirst)
{
	const auto column = [&](const char* name, std::uint8_t value) {
		return write::Column{name, 1, NumberType::uint8, std::vector<std::byte>(points_.size(), std::byte{value})};
	};
	// The first two become the same text, and the third is the name that the second would get.
	const std::vector columns{column("a\xFF", 1), column("a\xFE", 2), column("a__2", 3), column("<é> & \"", 4),
	                          column("vprobe:x", 5)};
	const std::vector<std::uint8_t> own(points_.size(), 6);
	data_.point_arrays = {};
	data_.point_arrays.add(columns);
	data_.point_arrays.add(xmlArray("vprobe:x", NumberType::uint8, 1, own));
	vtkPointData* read = readByVtk()->GetPointData();
	const std::vector<std::pair<const char*, double>> expected{
	    {"a_", 1}, {"a__2", 2}, {"a__2_2", 3}, {"<é> & \"", 4}, {"vprobe:x", 6}};
	ASSERT_EQ(read->GetNumberOfArrays(), static_cast<int>(expected.size()));
	for (std::size_t i = 0; i < expected.size(); ++i)
	{
		EXPECT_STREQ(read->GetArrayName(static_cast<int>(i)), expected[i].first);
		EXPECT_EQ(read->GetArray(static_cast<int>(i))->GetTuple1(0), expected[i].second);
	}
}

TEST(XmlArray, RangeOfValues)
{
	constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	const auto range = [](int components, const auto& values)
	{ return valueRange(xmlArray("s", NumberType::float64, components, values)); };
	EXPECT_EQ(range(1, std::vector{3.0, kNan, -2.0}), std::pair(-2.0, 3.0));
	EXPECT_EQ(range(2, std::vector{3.0, -4.0, kNan, 1.0, 0.0, 1.0}), std::pair(1.0, 5.0)); // lengths
	EXPECT_EQ(range(1, std::vector{kInfinity, 1.0}), std::pair(1.0, kInfinity));
	EXPECT_EQ(range(1, std::vector{kInfinity}), std::pair(kInfinity, kInfinity));
	EXPECT_EQ(range(1, std::vector{kNan, kNan}), std::nullopt);
	EXPECT_EQ(range(3, std::vector<double>{}), std::nullopt);
	EXPECT_EQ(valueRange(write::xmlTexts("words", std::string_view("a\0b\0", 4))), std::nullopt);

	// More values than one task takes.
	std::vector<double> many(300'001);
	for (std::size_t i = 0; i < many.size(); ++i)
		many[i] = std::sin(0.01 * static_cast<double>(i));
	many[77] = 5.0;
	many.back() = -7.0;
	EXPECT_EQ(range(1, many), std::pair(-7.0, 5.0));
	const std::vector<std::int8_t> small{-128, 127};
	EXPECT_EQ(valueRange(xmlArray("s", NumberType::int8, 1, small)), std::pair(-128.0, 127.0));
	const std::vector<std::uint64_t> large{~std::uint64_t(0), 1};
	EXPECT_EQ(valueRange(xmlArray("s", NumberType::uint64, 1, large)), std::pair(1.0, 18446744073709551616.0));
}

TEST(PolyDataOnAFullDisk, IsAnErrorOfTheFile)
{
	Result<write::AtomicFile> file = write::AtomicFile::create("/dev/full");
	if (!file)
		GTEST_SKIP() << "this system has no /dev/full";
	write::writePolyData({}, *file);
	const Status status = file->commit();
	ASSERT_FALSE(status);
	EXPECT_EQ(status.error().kind, ErrorKind::output);
	EXPECT_NE(status.error().message.find("/dev/full"), std::string::npos);
}

} // namespace vp::test
