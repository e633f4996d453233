#include "session/scan_values.h"
#include "session/value_scale.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

namespace vp::session::test
{

namespace
{

// A session of one image, 10 x 10 x 10, whose only array has these values.
template <class T>
std::unique_ptr<Session> sessionOf(std::vector<T> values, const char* name, grid::Imaging imaging = {})
{
	grid::Block block;
	block.grid = grid::UniformGrid({10, 10, 10}, Vec3(0.0), Vec3(1.0));
	block.fields.push_back(grid::makeField(name, grid::Association::point, 1, std::move(values)));
	block.imaging = std::move(imaging);
	grid::finishBlock(block);
	grid::BlockSet set;
	set.blocks.push_back(std::move(block));
	return std::move(Session::of(std::move(set), {}, {}).value());
}

template <class T>
std::vector<T> upTo999()
{
	std::vector<T> values(1000);
	std::iota(values.begin(), values.end(), T(0));
	return values;
}

using Ends = std::optional<std::pair<double, double>>;

Ends windowOf(const std::unique_ptr<Session>& session)
{
	const grid::FieldChoice& field = *session->view().field;
	return windowOfScan(*session, field, spanOf(*session, field));
}

} // namespace

TEST(ScanValues, AllButTheOuterHalfPercent)
{
	EXPECT_EQ(windowOf(sessionOf(upTo999<std::uint16_t>(), "ct")), (Ends{{5.0, 994.0}}));
	// A single metal voxel does not darken the rest.
	std::vector<std::int16_t> metal = upTo999<std::int16_t>();
	metal[500] = 30000;
	const Ends window = windowOf(sessionOf(metal, "ct"));
	ASSERT_TRUE(window);
	EXPECT_NEAR(window->first, 5.0, 2.0);
	EXPECT_NEAR(window->second, 994.0, 4.0);
}

TEST(ScanValues, TheWindowOfTheFileComesFirst)
{
	EXPECT_EQ(windowOf(sessionOf(upTo999<float>(), "ct", {"LPS", true, false, std::pair{-160.0, 240.0}})),
	          (Ends{{-160.0, 240.0}}));
}

TEST(ScanValues, OnlyScansBeginInGray)
{
	const auto isGray = [](const std::unique_ptr<Session>& session)
	{ return beginsGray(session->blocks(), session->view().field); };
	EXPECT_TRUE(isGray(sessionOf(upTo999<std::uint16_t>(), "values")));
	EXPECT_TRUE(isGray(sessionOf(upTo999<float>(), "values", {"", true})));
	EXPECT_FALSE(isGray(sessionOf(upTo999<float>(), "values")));
	EXPECT_FALSE(isGray(sessionOf(upTo999<std::int32_t>(), "values")));
	EXPECT_FALSE(isGray(sessionOf(upTo999<std::uint16_t>(), "labels", {"RAS", true})));
	EXPECT_FALSE(windowOf(sessionOf(upTo999<float>(), "values")));
	EXPECT_FALSE(windowOf(sessionOf(std::vector<std::uint8_t>(1000, 7), "values"))); // one value has no window
}

} // namespace vp::session::test
