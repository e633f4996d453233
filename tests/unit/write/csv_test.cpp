#include "sample_slice.h"

#include "mesh/mesh_values.h"
#include "write/slice_file.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>

namespace vp::test
{

namespace
{

using Row = std::vector<std::string>;

// RFC 4180.
std::vector<Row> parseCsv(const std::string& text)
{
	std::vector<Row> rows(1, Row(1));
	bool in_quotes = false;
	for (std::size_t i = 0; i < text.size(); ++i)
	{
		const char c = text[i];
		std::string& field = rows.back().back();
		if (c == '"' && in_quotes && i + 1 < text.size() && text[i + 1] == '"')
			field += text[++i];
		else if (c == '"')
			in_quotes = !in_quotes;
		else if (c == ',' && !in_quotes)
			rows.back().emplace_back();
		else if (c == '\n' && !in_quotes)
			rows.emplace_back(1);
		else
			field += c;
	}
	rows.pop_back(); // after the last line end
	return rows;
}

template <class T>
T number(const std::string& text)
{
	T value{};
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
	EXPECT_TRUE(error == std::errc() && end == text.data() + text.size()) << text;
	return value;
}

} // namespace

TEST(Csv, HasARowPerCorner)
{
	const SampleSlice sample = sampleSlice();
	const TemporaryFolder folder;
	ASSERT_TRUE(write::writeSlice(sample.blocks, sample.meshes, folder / "cut.csv"));
	const std::vector<Row> rows = parseCsv(readText(folder / "cut.csv"));
	ASSERT_EQ(rows.size(), 1 + sample.corners());
	const Row head{"sheet",
	               "block",
	               "cell",
	               "polygon",
	               "x",
	               "y",
	               "z",
	               "s",
	               "v_x",
	               "v_y",
	               "v_z",
	               "level",
	               "id",
	               "flag",
	               std::string(kOddName) + "_x",
	               std::string(kOddName) + "_y"};
	EXPECT_EQ(rows[0], head);

	std::size_t r = 1;
	std::size_t polygon = 0;
	for (std::size_t sheet = 0; sheet < sample.meshes.size(); ++sheet)
	{
		const mesh::SheetMesh& mesh = sample.meshes[sheet];
		for (std::size_t p = 0; p < mesh.polygons(); ++p, ++polygon)
			for (const std::uint32_t v : mesh.polygon(p))
			{
				const Row& row = rows[r++];
				ASSERT_EQ(row.size(), head.size());
				const mesh::BlockCell from = mesh.polygon_cells[p];
				const grid::Block& block = sample.blocks.blocks[from.block];
				const std::size_t source =
				    std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(from.cell)); }, block.grid);
				EXPECT_EQ(number<std::size_t>(row[0]), sheet);
				EXPECT_EQ(number<std::size_t>(row[1]), from.block);
				EXPECT_EQ(number<std::size_t>(row[2]), source);
				EXPECT_EQ(number<std::size_t>(row[3]), polygon);
				// Every digit that the number needs.
				EXPECT_EQ(Vec3(number<double>(row[4]), number<double>(row[5]), number<double>(row[6])),
				          mesh.positions[v]);
				EXPECT_EQ(number<double>(row[7]), mesh::interpolate(block, block.fields[0], 0, mesh.edges[v]));
				EXPECT_EQ(number<float>(row[8]),
				          static_cast<float>(mesh::interpolate(block, block.fields[1], 0, mesh.edges[v])));
				EXPECT_EQ(number<std::int64_t>(row[12]),
				          from.block == 0 ? kFirstId + static_cast<std::int64_t>(source) : 0);
				EXPECT_EQ(number<int>(row[13]), from.block == 0 ? static_cast<int>(200 + source % 50) : 7);
				EXPECT_EQ(std::isnan(number<double>(row[14])), from.block == 1);
			}
	}
}

TEST(Csv, NumbersAreShort)
{
	SampleSlice sample = sampleSlice();
	sample.meshes.resize(1);
	mesh::SheetMesh& mesh = sample.meshes[0];
	mesh.positions.assign(mesh.positions.size(), Vec3(0.1, -2.0, 1e300));
	const TemporaryFolder folder;
	ASSERT_TRUE(write::writeSlice(sample.blocks, sample.meshes, folder / "cut.csv"));
	const std::vector<Row> rows = parseCsv(readText(folder / "cut.csv"));
	EXPECT_EQ(rows[1][4], "0.1");
	EXPECT_EQ(rows[1][5], "-2");
	EXPECT_EQ(rows[1][6], "1e+300");
}

} // namespace vp::test
