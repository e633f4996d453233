#include "sliced_sheet.h"
#include "test_grids.h"

#include "measure/finite_fields.h"

#include <gtest/gtest.h>

#include <limits>

namespace vp::test
{

namespace
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kEnough = 1u << 30; // lookups that are worth going through any array here

template <class T>
grid::Field fieldOf(std::vector<T> values)
{
	return grid::makeField("s", grid::Association::point, 1, std::move(values));
}

} // namespace

TEST(FiniteFields, TellsOrdinaryNumbersFromOthers)
{
	EXPECT_TRUE(measure::hasOrdinaryNumbersOnly(fieldOf<float>({0.0f, -3e38f, 3e38f})));
	EXPECT_TRUE(measure::hasOrdinaryNumbersOnly(fieldOf<double>({0.0, -1e149, 1e149})));
	EXPECT_TRUE(measure::hasOrdinaryNumbersOnly(fieldOf<std::int64_t>({std::numeric_limits<std::int64_t>::min()})));
	for (const double odd : {kNan, kInfinity, -kInfinity})
		for (const std::size_t at : {0u, 70'000u, 199'999u})
		{
			std::vector<double> values(200'000, 1.0);
			values[at] = odd;
			EXPECT_FALSE(measure::hasOrdinaryNumbersOnly(fieldOf(std::vector<float>(values.begin(), values.end()))));
			EXPECT_FALSE(measure::hasOrdinaryNumbersOnly(fieldOf(values)));
		}
	// Finite, but what lies between them, or the length of two, is not.
	EXPECT_FALSE(measure::hasOrdinaryNumbersOnly(fieldOf<double>({-1e308, 1e308})));
}

TEST(FiniteFields, GoesThroughAnArrayOnlyWhenItPays)
{
	measure::FiniteFields known;
	const grid::Field field = fieldOf(std::vector<float>(32'000, 1.0f));
	EXPECT_FALSE(known.holds(field, 400));
	EXPECT_FALSE(known.holds(field, 400));
	EXPECT_TRUE(known.holds(field, 400));
	EXPECT_TRUE(known.holds(field, 0));
}

// Other values may come to lie where the old ones lay.
TEST(FiniteFields, ForgetsArraysThatAreGone)
{
	measure::FiniteFields known;
	for (int time = 0; time < 20; ++time)
	{
		std::vector<float> values(1000, 1.0f);
		if (time % 2)
			values[500] = std::numeric_limits<float>::quiet_NaN();
		const grid::Field field = fieldOf(std::move(values));
		EXPECT_EQ(known.holds(field, kEnough), time % 2 == 0);
		const grid::Field copy = field;
		EXPECT_EQ(known.holds(copy, 0), time % 2 == 0);
	}
}

// The area without values is the same whether something is known of the arrays or not, asked for the first time or
// later.
TEST(FiniteFields, LeavesTheAreaOfNanAsItIs)
{
	for (const double value : {2.0, kNan, kInfinity})
		for (const grid::Association association : {grid::Association::point, grid::Association::cell})
			for (const int components : {1, 3})
			{
				grid::Block block = gridNamed("shell");
				const bool on_points = association == grid::Association::point;
				std::vector<double> values(static_cast<std::size_t>(components) *
				                               std::visit([&](const auto& g)
				                                          { return on_points ? g.pointCount() : g.cellCount(); },
				                                          block.grid),
				                           1.0);
				// In every fifth place.
				for (std::size_t i = 0; i < values.size(); ++i)
					if (i / static_cast<std::size_t>(components) % 5 == 0)
						values[i] = value;
				block.fields = {grid::makeField("t", association, components, std::move(values))};
				const grid::BlockSet set = setOf(block);
				cut::Cutter cutter(set);
				measure::FiniteFields known;
				// One that the array lacks is NaN at points.
				for (const int component : {0, components > 1 ? grid::kMagnitude : 0, on_points ? 5 : 0})
					for (int again = 0; again < 3; ++again)
					{
						const auto sheet = cut(cutter, {block.bounds.center(), {0.3, 0.5, 0.81 + 0.01 * again}});
						const grid::FieldChoice choice{"t", association, component};
						const double area = measure::measure(set, sheet.mesh, choice).nan_area;
						EXPECT_EQ(measure::nanArea(set, sheet.mesh, choice, &known), area);
						EXPECT_EQ(area > 0.0, component == 5 || !std::isfinite(value));
					}
			}
}

} // namespace vp::test
