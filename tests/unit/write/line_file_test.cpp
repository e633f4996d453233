#include "write/line_file.h"

#include "cut/cutter.h"
#include "exhaustive.h"
#include "grid/demo/demo.h"
#include "sample_slice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

namespace vp::test
{

namespace
{

using NamedRow = std::map<std::string, double>;

// A file without quoted names.
std::vector<NamedRow> rowsOf(const std::string& text)
{
	std::istringstream lines(text);
	std::string line;
	std::vector<std::string> names;
	std::getline(lines, line);
	std::istringstream header(line);
	for (std::string name; std::getline(header, name, ',');)
		names.push_back(name);
	std::vector<NamedRow> rows;
	while (std::getline(lines, line))
	{
		std::istringstream fields(line);
		NamedRow& row = rows.emplace_back();
		for (const std::string& name : names)
		{
			std::string field;
			std::getline(fields, field, ',');
			row[name] = std::stod(field);
		}
	}
	return rows;
}

std::vector<NamedRow> rowsAlong(const grid::BlockSet& blocks, const probe::Sheet& sheet, const write::SheetLine& line)
{
	const TemporaryFolder folder;
	cut::Cutter cutter(blocks);
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = {sheet};
	const mesh::SheetMesh mesh = cutter.cut(std::move(request)).value().mesh(blocks, 0);
	EXPECT_TRUE(write::writeLine(write::tabulateAlong(blocks, sheet, mesh, line), sheet, line, folder / "line.csv"));
	EXPECT_EQ(folder.files(), 1u);
	return rowsOf(readText(folder / "line.csv"));
}

double linear(const NamedRow& row)
{
	return 2.0 * row.at("x") - 3.0 * row.at("y") + 0.5 * row.at("z");
}

// Point field f, linear and double; cell field c, the cell's number.
grid::BlockSet withLinear(const std::string& demo, int n)
{
	grid::BlockSet blocks = grid::makeDemo(demo, n).value();
	for (grid::Block& block : blocks.blocks)
		visitGrid(block,
		          [&](const auto& grid)
		          {
			          std::vector<double> f(grid.pointCount());
			          for (PointId p = 0; p < grid.pointCount(); ++p)
			          {
				          const Vec3 at = grid.point(p);
				          f[grid.sourcePoint(p)] = 2.0 * at.x - 3.0 * at.y + 0.5 * at.z;
			          }
			          std::vector<double> c(grid.cellCount());
			          for (std::size_t i = 0; i < c.size(); ++i)
				          c[i] = static_cast<double>(i);
			          block.fields.push_back(grid::makeField("f", grid::Association::point, 1, std::move(f)));
			          block.fields.push_back(grid::makeField("c", grid::Association::cell, 1, std::move(c)));
		          });
	return blocks;
}

} // namespace

TEST(LineFile, ALinearFieldIsExactOnEveryRow)
{
	for (const char* demo : {"shell", "tets", "mixed", "graded"})
	{
		SCOPED_TRACE(demo);
		const grid::BlockSet blocks = withLinear(demo, 10);
		const Vec3 center = 0.5 * (blocks.bounds().lo + blocks.bounds().hi);
		const auto rows = rowsAlong(blocks, probe::makeSheet(center, {0.3, -0.2, 0.9}), {{-1.9, 0.35}, {2.1, -0.8}});
		std::size_t inside = 0;
		double before = 0.0;
		for (const NamedRow& row : rows)
		{
			EXPECT_GE(row.at("distance"), before);
			before = row.at("distance");
			EXPECT_NEAR(std::hypot(row.at("u") + 1.9, row.at("v") - 0.35), before, 1e-12);
			if (std::isnan(row.at("f")))
				continue;
			EXPECT_NEAR(row.at("f"), linear(row), 1e-11);
			EXPECT_EQ(row.at("c"), row.at("cell"));
			++inside;
		}
		EXPECT_GT(inside, 10u);
		EXPECT_EQ(rows.front().at("distance"), 0.0);
		EXPECT_NEAR(before, std::hypot(4.0, 1.15), 1e-12);
	}
}

TEST(LineFile, GapsAndEndsOutsideAreToldOnce)
{
	const grid::BlockSet blocks = withLinear("shell", 12);
	// Through the hollow middle of the shell and out at both sides.
	const auto rows = rowsAlong(blocks, probe::makeSheet({0.0, 0.5, 0.0}, {0.0, 0.0, 1.0}), {{-4.0, 0.0}, {4.0, 0.0}});
	std::vector<double> outside;
	for (const NamedRow& row : rows)
		if (std::isnan(row.at("f")))
			outside.push_back(row.at("u"));
	ASSERT_EQ(outside.size(), 3u);
	EXPECT_EQ(outside[0], -4.0);
	EXPECT_NEAR(outside[1], 0.0, 1e-12);
	EXPECT_EQ(outside[2], 4.0);
	const auto missed =
	    rowsAlong(blocks, probe::makeSheet({0.0, 0.5, 0.0}, {0.0, 0.0, 1.0}), {{-4.0, 9.0}, {4.0, 9.0}});
	ASSERT_EQ(missed.size(), 2u);
	EXPECT_TRUE(std::isnan(missed[0].at("c")) && std::isnan(missed[1].at("cell")));
}

TEST(LineFile, EndsWithinAPolygonHaveTheirValues)
{
	const grid::BlockSet blocks = withLinear("blob", 6);
	const auto rows = rowsAlong(blocks, probe::makeSheet({0.0, 0.0, 0.25}, {0.0, 0.0, 1.0}), {{0.2, 0.3}, {2.6, 0.7}});
	ASSERT_EQ(rows.size(), 4u); // x = 1 and 2 between
	for (const NamedRow& row : rows)
		EXPECT_NEAR(row.at("f"), linear(row), 1e-12);
	EXPECT_NEAR(rows[1].at("x"), 1.0, 1e-12);
	EXPECT_EQ(rows[3].at("c"), rows[2].at("c"));
}

} // namespace vp::test
