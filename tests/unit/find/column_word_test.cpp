#include "find/column_word.h"
#include "find/row_signs.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <vector>

namespace vp::test
{

using find::ColumnWord;

namespace
{

// A row of columns at random, runs of equal ones among them, in quads with room behind.
struct Columns
{
	explicit Columns(unsigned seed)
	{
		std::mt19937 random(seed);
		for (unsigned i = 0; i < kCount; ++i)
			of.push_back(random() % 3 || of.empty() ? random() % 16 : of.back());
		for (unsigned i = 0; i < kCount; ++i)
			quads[i / 4] |= static_cast<std::uint16_t>(of[i] << 4 * (i % 4));
	}
	static constexpr unsigned kCount = 40;
	std::vector<unsigned> of;
	std::uint16_t quads[kCount / 4 + 4] = {};
};

bool bit(unsigned column, unsigned row)
{
	return column >> row & 1;
}

template <unsigned side>
void expectFaces(const Columns& columns, std::uint32_t at)
{
	constexpr unsigned kRows[4][2] = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};
	const auto [first, second] = kRows[side];
	const ColumnWord word = ColumnWord::at(columns.quads, at);
	const std::uint64_t mixed = word.mixedColumns<side>();
	const std::uint64_t cut = word.cutFaces<side>(mixed, ColumnWord::firstCells(ColumnWord::kMaxCells));
	for (std::uint32_t x = 0; x < ColumnWord::kMaxCells; ++x)
	{
		const unsigned here = columns.of[at + x];
		const unsigned next = columns.of[at + x + 1];
		EXPECT_EQ(mixed >> 4 * x & 15, unsigned(bit(here, first) != bit(here, second)));
		const int positive = bit(here, first) + bit(here, second) + bit(next, first) + bit(next, second);
		EXPECT_EQ(cut >> 4 * x & 15, unsigned(positive != 0 && positive != 4));
	}
	EXPECT_EQ(cut >> 4 * ColumnWord::kMaxCells, 0u);
}

} // namespace

TEST(ColumnWord, TellsCasesAndFacesOfCells)
{
	for (unsigned seed = 0; seed < 20; ++seed)
	{
		const Columns columns(seed);
		for (std::uint32_t at = 0; at + ColumnWord::kColumns < Columns::kCount; ++at)
		{
			const ColumnWord word = ColumnWord::at(columns.quads, at);
			cases::ColumnCase cases[ColumnWord::kColumns];
			word.writeCases(cases);
			for (std::uint32_t x = 0; x < ColumnWord::kMaxCells; ++x)
			{
				EXPECT_EQ(word.column(x), columns.of[at + x]);
				EXPECT_EQ(cases[x], columns.of[at + x] | columns.of[at + x + 1] << 4);
			}
			expectFaces<0>(columns, at);
			expectFaces<1>(columns, at);
			expectFaces<2>(columns, at);
			expectFaces<3>(columns, at);
		}
	}
}

TEST(ColumnWord, RowsBeyondTheGridRepeatTheLast)
{
	const Columns columns(7);
	for (const unsigned beyond : {0u, 1u, 2u, 3u})
	{
		const ColumnWord word = ColumnWord::at(columns.quads, 0).beyond(beyond);
		for (std::uint32_t x = 0; x < ColumnWord::kMaxCells; ++x)
			for (unsigned row = 0; row < 4; ++row)
				EXPECT_EQ(bit(word.column(x), row), bit(columns.of[x], row | beyond)) << beyond;
	}
}

TEST(ColumnWord, OfRowsThatChangeOnce)
{
	for (const bool rises : {false, true})
		for (const std::uint32_t at : {0u, 5u, 100u})
		{
			const std::array<std::uint32_t, 4> changes{0, 7, 103, 1000};
			const ColumnWord word = ColumnWord::ofRows(changes, rises, at);
			for (std::uint32_t x = 0; x < ColumnWord::kColumns; ++x)
				for (unsigned row = 0; row < 4; ++row)
					EXPECT_EQ(bit(word.column(x), row), (at + x >= changes[row]) == rises) << at << ' ' << x;
		}
}

TEST(ColumnWord, UniformColumnsHaveOneSign)
{
	for (unsigned quad = 0; quad < 0x10000; ++quad)
		for (unsigned x = 0; x < 4; ++x)
		{
			const unsigned column = quad >> 4 * x & 15;
			ASSERT_EQ(find::uniformColumns(quad) >> 4 * x & 15, unsigned(column == 0 || column == 15));
		}
}

TEST(RowSigns, AreThoseInDouble)
{
	std::mt19937 random(11);
	std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
	std::vector<float> xyz(3 * 400);
	Box bounds;
	const surface::Plane plane({0.1, 0.2, 0.3}, {0.3, -0.5, 0.8});
	for (std::size_t p = 0; p < xyz.size() / 3; ++p)
	{
		Vec3 point(anywhere(random), anywhere(random), anywhere(random));
		if (p % 5 == 0) // to within rounding in the plane, where float cannot tell
			point -= plane.signedDistance(point) * plane.normal();
		for (int axis = 0; axis < 3; ++axis)
			xyz[3 * p + axis] = static_cast<float>(point[axis]);
		bounds.include(Vec3(xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]));
	}
	const grid::Points points{Array<float>(std::vector<float>(xyz))};
	const find::RowSigns<float> signs(points, plane, bounds);
	for (PointId p = 0; p + 304 <= 400; ++p)
		for (const unsigned count : {1u, 3u, 4u})
		{
			const std::array<PointId, 4> rows{p, p + 100, p + 200, p + 300};
			const unsigned bits = signs.columns(rows, count);
			for (unsigned v = 0; v < 4; ++v)
				for (unsigned r = 0; r < 4; ++r)
					EXPECT_EQ(bits >> (4 * v + r) & 1,
					          unsigned(v < count && plane.signedDistance(points[rows[r] + v]) >= 0.0));
		}
}

} // namespace vp::test
