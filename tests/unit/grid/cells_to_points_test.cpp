#include "grid/curved/cells_to_points.h"

#include "grid/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vp::grid
{

namespace
{

const double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// Two cells side by side along x: 3 x 2 x 2 points.
Block twoCells(std::vector<float> values)
{
	Block block;
	block.grid = UniformGrid({3, 2, 2}, Vec3(0.0), Vec3(1.0));
	block.fields.push_back(makeField("heat", Association::cell, 1, std::move(values)));
	finishBlock(block);
	return block;
}

std::vector<double> valuesOf(const Field& field)
{
	std::vector<double> values;
	for (std::size_t i = 0; i < field.tuples(); ++i)
		values.push_back(field.value(i, 0));
	return values;
}

} // namespace

// By hand: points of one cell have its value, those of both the mean.
TEST(CellsToPoints, APointHasTheMeanOfItsCells)
{
	const Block block = twoCells({1.0f, 4.0f});
	const std::vector<Field> fields = fieldsAtPoints(block, block.fields);
	ASSERT_EQ(fields.size(), 1u);
	EXPECT_EQ(fields[0].association, Association::point);
	EXPECT_EQ(fields[0].type, NumberType::float32);
	EXPECT_EQ(valuesOf(fields[0]), (std::vector<double>{1, 2.5, 4, 1, 2.5, 4, 1, 2.5, 4, 1, 2.5, 4}));
}

TEST(CellsToPoints, NanDoesNotCount)
{
	const Block block = twoCells({1.0f, static_cast<float>(kNotANumber)});
	const std::vector<double> values = valuesOf(fieldsAtPoints(block, block.fields)[0]);
	EXPECT_EQ(values[0], 1.0);
	EXPECT_EQ(values[1], 1.0);
	EXPECT_TRUE(std::isnan(values[2]));
}

TEST(CellsToPoints, CategoriesAndDoublesStay)
{
	Block block = twoCells({1.0f, 4.0f});
	std::vector<Field> fields = block.fields;
	fields.push_back(makeField("material", Association::cell, 1, std::vector<std::int32_t>{1, 2}));
	fields.push_back(makeField("heat", Association::point, 1, std::vector<double>(12, 7.0)));
	const std::vector<Field> moved = fieldsAtPoints(block, fields);
	EXPECT_EQ(moved[0].association, Association::cell); // the points have an array of its name
	EXPECT_EQ(moved[1].association, Association::cell);
	EXPECT_EQ(moved[2].value(3, 0), 7.0);
}

// Two tetrahedra are parts of the first cell of the file, a third one is the second cell. The point that all share has
// the mean of two cells, not of three.
TEST(CellsToPoints, PartsOfACellCountOnce)
{
	Points points;
	std::vector<double> places{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, -1, 0, 0};
	points = Points(Array<double>(std::vector<double>(places)));
	CellList cells;
	cells.types = Array<std::uint8_t>(std::vector<std::uint8_t>(3, kTetra));
	cells.connectivity = IdArray(Array<std::int64_t>(std::vector<std::int64_t>{0, 1, 2, 3, 0, 2, 1, 4, 0, 2, 5, 3}));
	cells.source_cells = Array<std::int64_t>(std::vector<std::int64_t>{0, 0, 1});
	for (const bool is_linked : {false, true})
	{
		Block block;
		block.grid = is_linked ? UnstructuredGrid::build(points, cells) : UnstructuredGrid::listed(points, cells);
		const std::vector<double> values = valuesOf(
		    fieldsAtPoints(block, {makeField("heat", Association::cell, 1, std::vector<double>{2.0, 6.0})})[0]);
		EXPECT_EQ(values, (std::vector<double>{4, 2, 4, 4, 2, 6})) << is_linked;
	}
}

} // namespace vp::grid
