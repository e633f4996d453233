// Unstructured VTK XML files of several pieces, and such as writers do not make.
#include "handed_over.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

using namespace vp;
using nlohmann::json;

namespace
{

struct ListedPiece
{
	std::vector<float> points;
	std::vector<std::int64_t> ids;
	std::vector<std::int64_t> ends;
	std::vector<std::uint8_t> types;
};

// A hexahedron, and a wedge on its side.
const ListedPiece kOneHexahedron = {
    {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1}, {0, 1, 2, 3, 4, 5, 6, 7}, {8}, {12}};
const ListedPiece kOneWedge = {{1, 0, 0, 1, 1, 0, 2, 0, 0, 1, 0, 1, 1, 1, 1, 2, 0, 1}, {0, 1, 2, 3, 4, 5}, {6}, {13}};

// A .vtu file with raw data behind its elements.
class Written
{
public:
	explicit Written(const std::vector<ListedPiece>& pieces)
	{
		elements_ = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid>
)";
		for (const ListedPiece& piece : pieces)
			add(piece);
		elements_ += "</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
	}

	std::string text() const { return elements_ + data_ + "\n</AppendedData>\n</VTKFile>\n"; }
	// Replaces words of the elements, all over.
	Written& with(const std::string& words, const std::string& others)
	{
		for (std::size_t at = elements_.find(words); at != elements_.npos;
		     at = elements_.find(words, at + others.size()))
			elements_.replace(at, words.size(), others);
		return *this;
	}
	// Replaces the size in front of an array.
	Written& withSize(std::size_t array, std::uint64_t bytes)
	{
		data_.replace(starts_[array], 8, reinterpret_cast<const char*>(&bytes), 8);
		return *this;
	}

private:
	template <class T>
	void addArray(const std::string& type, const std::string& more, const std::vector<T>& values)
	{
		elements_ +=
		    fmt::format("<DataArray type=\"{}\" {} format=\"appended\" offset=\"{}\"/>\n", type, more, data_.size());
		starts_.push_back(data_.size());
		const std::uint64_t bytes = values.size() * sizeof(T);
		data_.append(reinterpret_cast<const char*>(&bytes), 8);
		data_.append(reinterpret_cast<const char*>(values.data()), bytes);
	}
	void add(const ListedPiece& piece)
	{
		elements_ += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
		                         piece.points.size() / 3, piece.types.size());
		addArray("Float32", "Name=\"at\" NumberOfComponents=\"3\"", piece.points);
		elements_ += "</PointData>\n<CellData>\n";
		addArray("UInt8", "Name=\"type\"", piece.types);
		elements_ += "</CellData>\n<Points>\n";
		addArray("Float32", "Name=\"Points\" NumberOfComponents=\"3\"", piece.points);
		elements_ += "</Points>\n<Cells>\n";
		addArray("Int64", "Name=\"connectivity\"", piece.ids);
		addArray("Int64", "Name=\"offsets\"", piece.ends);
		addArray("UInt8", "Name=\"types\"", piece.types);
		elements_ += "</Cells>\n</Piece>\n";
	}

	std::string elements_;
	std::string data_;
	std::vector<std::size_t> starts_;
};

class QuickPieces : public testing::Test
{
protected:
	void expectQuick(const std::string& text, bool is_quick)
	{
		const std::string path = folder_ / "a.vtu";
		writeContents(path, text);
		EXPECT_EQ(isReadQuickly(path), is_quick);
		json quick = handedOver(path);
		json slow = handedOverByVtk(path);
		for (json* each : {&quick, &slow})
			if (each->contains("error"))
				(*each)["error"] = "in VTK's words";
		EXPECT_EQ(json::diff(quick, slow), json::array());
		EXPECT_TRUE(!is_quick || !quick.contains("error"));
	}

	TemporaryFolder folder_;
};

} // namespace

TEST_F(QuickPieces, ComeOneBehindTheOther)
{
	expectQuick(Written({kOneHexahedron}).text(), true);
	expectQuick(Written({kOneHexahedron, kOneHexahedron}).text(), true);
	expectQuick(Written({kOneHexahedron, kOneWedge, kOneWedge}).text(), true);
	ListedPiece flat = kOneWedge;
	flat.types = {5, 13, 1};
	flat.ids = {0, 1, 2, 0, 1, 2, 3, 4, 5, 5};
	flat.ends = {3, 9, 10};
	expectQuick(Written({flat, kOneHexahedron, flat}).text(), true);

	writeContents(folder_ / "b.vtu", Written({kOneHexahedron, kOneWedge}).text());
	const auto set = read::readInputs({folder_ / "b.vtu"}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	const auto& grid = std::get<grid::UnstructuredGrid>(set->blocks[0].grid);
	EXPECT_EQ(grid.cellCount(), 2u);
	EXPECT_EQ(grid.pointCount(), 14u);
	EXPECT_EQ(set->blocks[0].fields[1].bytes[1], std::byte(13));
}

TEST_F(QuickPieces, ThatDifferAreLeftToVtk)
{
	std::string text = Written({kOneHexahedron, kOneWedge}).text();
	text.replace(text.rfind("Name=\"type\""), 11, "Name=\"form\"");
	writeContents(folder_ / "b.vtu", text); // VTK leaves the values of such a piece as the memory was
	EXPECT_FALSE(isReadQuickly(folder_ / "b.vtu"));
	text = Written({kOneHexahedron, kOneWedge}).text();
	text.replace(text.rfind("type=\"UInt8\" Name=\"type\""), 12, "type=\"Int8\" ");
	expectQuick(text, false);
	text = Written({kOneHexahedron, kOneWedge}).text();
	text.replace(text.rfind("NumberOfPoints=\"6\""), 18, "NumberOfPoints=\"0\"");
	expectQuick(text, false);
}

TEST_F(QuickPieces, WithMoreThanPlainCellsAreLeftToVtk)
{
	const Written plain({kOneHexahedron, kOneWedge});
	const auto changed = [&](const char* words, const char* others)
	{ return Written(plain).with(words, others).text(); };
	expectQuick(changed("LittleEndian", "BigEndian"), false);
	expectQuick(changed("version=\"1.0\" byte", "version=\"9.0\" byte"), false);
	expectQuick(changed("Name=\"type\"", "Name=\"vtkGhostType\""), false);
	expectQuick(changed("Name=\"type\"", "Name=\"at\""), true);
	expectQuick(changed("Name=\"type\"", ""), false);
	expectQuick(changed("<CellData>", "<CellData><Array type=\"String\" Name=\"words\" format=\"ascii\">65 0</Array>"),
	            false);
	expectQuick(changed("<UnstructuredGrid>", "<UnstructuredGrid TimeValues=\"1 2\">"), false);
	expectQuick(changed("<VTKFile", "<!DOCTYPE a [<!ENTITY b \"c\">]>\n<VTKFile"), false);
	expectQuick(changed("<VTKFile", "<!-- <Piece> \"more\" -->\n<VTKFile"), true);
	expectQuick(changed("<CellData>", "<CellData Scalars='type' >"), true);
	expectQuick(changed("Int64", "UInt64"), false);
	expectQuick(changed("encoding=\"raw\"", "encoding=\"other\""), false);

	for (const std::uint8_t type : {0, 5, 14, 15, 24, 42, 99})
	{
		SCOPED_TRACE(int(type));
		ListedPiece piece = kOneWedge;
		piece.types = {type};
		// Types 0 and 5 may list any number of points.
		expectQuick(Written({kOneHexahedron, piece}).text(), type < 10);
		expectQuick(Written({piece}).text(), false);
	}
}

TEST_F(QuickPieces, OfDamagedListsAreRefusedAsByVtk)
{
	const auto expectSame = [&](auto&& damage, bool is_quick = false)
	{
		ListedPiece piece = kOneWedge;
		damage(piece);
		expectQuick(Written({kOneHexahedron, piece}).text(), is_quick);
		if (!is_quick)
			expectQuick(Written({piece}).text(), false);
	};
	for (const std::int64_t id : {std::int64_t(-9), std::int64_t(1) << 31, std::int64_t(1) << 32,
	                              (std::int64_t(1) << 32) + 3, INT64_MIN, INT64_MAX})
		expectSame([id](ListedPiece& piece) { piece.ids[3] = id; });
	for (const std::int64_t end : {-1, 0, 5, 7, 1 << 30})
		expectSame([end](ListedPiece& piece) { piece.ends[0] = end; });
	expectSame([](ListedPiece& piece) { piece.ends[0] = INT64_MAX; });
	expectSame([](ListedPiece& piece) { piece.ends[0] = INT64_MIN; });
	// Ids that are only too large for the points are refused by the parent.
	ListedPiece far = kOneWedge;
	far.ids[3] = 6;
	writeContents(folder_ / "far.vtu", Written({far}).text());
	const auto set = read::readInputs({folder_ / "far.vtu"}, {}, nullptr);
	ASSERT_FALSE(set);
	EXPECT_EQ(set.error().message, (folder_ / "far.vtu") + ": truncated or damaged: a cell lists point 6 of 6");
}

TEST_F(QuickPieces, OfWrongSizesAreRefusedAsByVtk)
{
	for (std::size_t array = 0; array < 6; ++array)
		for (const std::uint64_t bytes : {std::uint64_t(0), std::uint64_t(1), std::uint64_t(1) << 20,
		                                  std::uint64_t(1) << 62, ~std::uint64_t(0) - 7})
		{
			SCOPED_TRACE(testing::Message() << "array " << array << " of " << bytes << " bytes");
			const bool is_right = bytes == 1 && (array == 1 || array == 5);
			expectQuick(Written({kOneHexahedron}).withSize(array, bytes).text(), is_right);
		}
	for (const char* count : {"0", "-1", "9", "4294967296", "18446744073709551615", "99999999999999999999", "8x", ""})
		for (const char* attribute : {"NumberOfPoints=\"8\"", "NumberOfCells=\"1\"", "NumberOfComponents=\"3\""})
		{
			SCOPED_TRACE(testing::Message() << attribute << " as " << count);
			const std::string words = attribute;
			const std::string others = words.substr(0, words.find('"') + 1) + count + '"';
			// Some of these make VTK take a minute over it.
			writeContents(folder_ / "a.vtu", Written({kOneHexahedron}).with(words, others).text());
			EXPECT_FALSE(isReadQuickly(folder_ / "a.vtu"));
		}
}
