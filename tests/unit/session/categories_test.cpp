#include "session/frame.h"
#include "session/session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace vp::session::test
{

namespace
{

constexpr int kSide = 20;

// An image of kSide^3 points. value(x, y, z): of its only array.
template <class T, class Value>
grid::Block imageOf(const char* name, Value value, grid::Imaging imaging = {})
{
	std::vector<T> values;
	for (int z = 0; z < kSide; ++z)
		for (int y = 0; y < kSide; ++y)
			for (int x = 0; x < kSide; ++x)
				values.push_back(static_cast<T>(value(x, y, z)));
	grid::Block block;
	block.grid = grid::UniformGrid({kSide, kSide, kSide}, Vec3(0.0), Vec3(1.0));
	block.fields.push_back(grid::makeField(name, grid::Association::point, 1, std::move(values)));
	block.imaging = std::move(imaging);
	grid::finishBlock(block);
	return block;
}

std::unique_ptr<Session> sessionOf(std::vector<grid::Block> blocks, view::ViewSpec spec = {})
{
	grid::BlockSet set;
	set.blocks = std::move(blocks);
	spec.probe.origin = Vec3(9.7);
	return std::move(Session::of(std::move(set), std::move(spec), {}).value());
}

std::vector<double> categoriesOf(const grid::Block& block)
{
	const auto session = sessionOf({block});
	EXPECT_EQ(session->categories().size() == 1, session->blocks().blocks[0].fields[0].categorical);
	return session->categories().empty() ? std::vector<double>() : session->categories()[0].values;
}

// A ball of 3 in a half space of 11, in nothing.
int tissue(int x, int y, int z)
{
	return std::hypot(x - 10, y - 10, z - 10) < 5.0 ? 3 : z < 12 ? 11 : 0;
}

} // namespace

TEST(Categories, AFewIntegersAreLabelsUnlessTheyAreARampOfGray)
{
	EXPECT_EQ(categoriesOf(imageOf<std::uint8_t>("image", tissue)), (std::vector<double>{0.0, 3.0, 11.0}));
	const auto ramp = [](int x, int, int) { return 13 * x; };
	EXPECT_TRUE(categoriesOf(imageOf<std::uint8_t>("image", ramp)).empty());
	const auto regions = [](int x, int y, int z) { return 7 * x / 5 % 4 + 4 * (y / 5) + 16 * (z / 10); };
	EXPECT_FALSE(categoriesOf(imageOf<std::uint8_t>("image", regions)).empty());
	EXPECT_TRUE(categoriesOf(imageOf<float>("image", tissue)).empty());
	const auto noise = [](int x, int y, int z) { return (31 * x + 17 * y + 5 * z) % 40; };
	EXPECT_TRUE(categoriesOf(imageOf<std::int16_t>("image", noise)).empty());
}

TEST(Categories, ANameOrTheFileDecidesBeforeTheValues)
{
	const auto noise = [](int x, int y, int z) { return (31 * x + 17 * y + 5 * z) % 40; };
	EXPECT_EQ(categoriesOf(imageOf<std::int16_t>("region", noise)).size(), 40u);
	EXPECT_EQ(categoriesOf(imageOf<std::int16_t>("image", noise, {.labels = true})).size(), 40u);
	EXPECT_EQ(categoriesOf(imageOf<float>("image", noise, {.labels = true})).size(), 40u);
}

TEST(Categories, TheSettingDecidesForAnyArray)
{
	const auto session = sessionOf({imageOf<float>("image", [](int, int, int z) { return z; })});
	const auto meanOf = [&]
	{
		auto frame = session->frame({});
		return *frame.value()->sheets[0].measure.mean;
	};
	EXPECT_NEAR(meanOf(), 9.7, 1e-6);
	view::ViewSpec spec = session->spec();
	spec.probe.interpolate = view::Interpolate::nearest;
	ASSERT_TRUE(session->set(spec));
	EXPECT_TRUE(session->blocks().blocks[0].fields[0].categorical);
	EXPECT_EQ(meanOf(), 10.0); // frames follow
	spec.probe.interpolate = view::Interpolate::automatic;
	ASSERT_TRUE(session->set(spec));
	EXPECT_NEAR(meanOf(), 9.7, 1e-6);
}

TEST(Categories, AreasOfValuesAreThoseOfVoxels)
{
	const auto session = sessionOf({imageOf<std::uint8_t>("image", tissue)});
	const auto frame = session->frame({}).value();
	// z = 9.7 lies in the voxels of the layer 10. Those in the rim reach half as far.
	std::map<double, double> expected;
	for (int y = 0; y < kSide; ++y)
		for (int x = 0; x < kSide; ++x)
			expected[tissue(x, y, 10)] +=
			    (x == 0 || x == kSide - 1 ? 0.5 : 1.0) * (y == 0 || y == kSide - 1 ? 0.5 : 1.0);
	ASSERT_TRUE(frame->sheets[0].value_areas);
	ASSERT_EQ(frame->sheets[0].value_areas->size(), expected.size());
	double sum = 0.0, whole = 0.0;
	for (const auto& [value, area] : expected)
		sum += value * area, whole += area;
	EXPECT_NEAR(frame->sheets[0].measure.mean.value(), sum / whole, 1e-12);
	EXPECT_EQ(frame->sheets[0].measure.min, frame->sheets[0].value_areas->begin()->first);
	EXPECT_EQ(frame->sheets[0].measure.max, frame->sheets[0].value_areas->rbegin()->first);
	for (const auto& [value, area] : *frame->sheets[0].value_areas)
		EXPECT_NEAR(area.value(), expected[value], 1e-9) << value;
}

TEST(Categories, ABlockWithoutTheArrayDoesNotCoverTheOther)
{
	std::vector<grid::Block> blocks{imageOf<float>("scan", [](int x, int, int) { return x; }),
	                                imageOf<std::uint8_t>("image", tissue)};
	// Blocks of one input may be parts of one thing: what they lack is shown as missing.
	EXPECT_TRUE(blocksCoveredByOthers(sessionOf(blocks)->blocks(), {"scan"}).empty());
	blocks[1].input = 1;
	const auto session = sessionOf(blocks);
	EXPECT_EQ(blocksCoveredByOthers(session->blocks(), {"scan"}), (std::vector<bool>{false, true}));
	const auto frame = session->frame({}).value();
	const SheetStats& sheet = frame->sheets[0];
	ASSERT_TRUE(sheet.shown);
	EXPECT_EQ(2 * sheet.shown->polygons(), sheet.mesh.polygons());
	EXPECT_NEAR(sheet.area_left_out, sheet.measure.nan_area, 1e-9);
}

} // namespace vp::session::test
