#include "grid/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vp::grid
{
namespace
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class T>
class FieldOf : public testing::Test
{
};
using Numbers = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t,
                               std::int64_t, std::uint64_t, float, double>;
TYPED_TEST_SUITE(FieldOf, Numbers);

TYPED_TEST(FieldOf, KeepsItsNumbers)
{
	const Field field = makeField<TypeParam>("f", Association::cell, 2, {1, 2, 30, 4, 5, 6});
	EXPECT_EQ(byteSize(field.type), sizeof(TypeParam));
	EXPECT_EQ(field.tuples(), 3u);
	EXPECT_EQ(field.value(1, 0), 30.0);
	EXPECT_EQ(field.value(2, 1), 6.0);
	EXPECT_EQ(fieldRange(field, 0), (std::pair{1.0, 30.0}));
	EXPECT_EQ(fieldRange(field, 1), (std::pair{2.0, 6.0}));
	const std::string name = numberTypeName(field.type);
	EXPECT_EQ(name.find("float") == 0, std::is_floating_point_v<TypeParam>) << name;
	EXPECT_EQ(name.find("uint") == 0, std::is_unsigned_v<TypeParam>) << name;
	EXPECT_NE(name.find(std::to_string(8 * sizeof(TypeParam))), std::string::npos) << name;
}

TEST(Field, NamesTellCategories)
{
	const auto integers = [](const char* name)
	{ return namesCategories(makeField<std::int32_t>(name, Association::point, 1, {1})); };
	for (const char* name : {"GlobalNodeId", "vtkOriginalPointIds", "GLOBAL_IDS_POINTS", "material", "MaterialID",
	                         "zone 3", "region-2", "vtkGhostType", "id", "Id"})
		EXPECT_TRUE(integers(name)) << name;
	for (const char* name : {"", "solid", "fluid", "ImageScalars", "density", "width", "valid", "regional", "PID"})
		EXPECT_FALSE(integers(name)) << name;
	EXPECT_FALSE(namesCategories(makeField<float>("material", Association::point, 1, {1.0f})));
	EXPECT_TRUE(namesCategories(makeField<std::uint8_t>("labels", Association::cell, 1, {1})));
}

TYPED_TEST(FieldOf, StoresItsNumbers)
{
	const Field field = makeField<TypeParam>("f", Association::point, 1, {0});
	TypeParam number{1};
	storeNumber(field.type, 42.0, reinterpret_cast<std::byte*>(&number));
	EXPECT_EQ(number, TypeParam{42});
	storeNumber(field.type, kNan, reinterpret_cast<std::byte*>(&number));
	EXPECT_EQ(std::isnan(static_cast<double>(number)), std::is_floating_point_v<TypeParam>);
	if (std::is_integral_v<TypeParam>)
	{
		EXPECT_EQ(number, TypeParam{0});
	}
}

TEST(Field, RangeLeavesNanOut)
{
	const Field field = makeField<double>("f", Association::point, 1, {kNan, 3.0, -2.0, kNan});
	EXPECT_EQ(fieldRange(field, 0), (std::pair{-2.0, 3.0}));
	const Field none = makeField<double>("f", Association::point, 1, {kNan, kNan});
	EXPECT_EQ(fieldRange(none, 0), (std::pair{0.0, 0.0}));
	EXPECT_EQ(fieldRange(makeField<float>("f", Association::point, 1, {}), 0), (std::pair{0.0, 0.0}));
}

TEST(Field, InfiniteValuesAreToldApart)
{
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	const Field field = makeField<float>("f", Association::point, 1, {INFINITY, 3.0f, NAN, -2.0f});
	EXPECT_EQ(fieldRange(field, 0), (std::pair{-2.0, 3.0}));
	EXPECT_TRUE(valueSpan(field, 0).plus_infinity);
	EXPECT_FALSE(valueSpan(field, 0).minus_infinity);
	const Field none = makeField<double>("f", Association::point, 1, {kNan, -kInfinity});
	EXPECT_TRUE(valueSpan(none, 0).empty());
	EXPECT_TRUE(valueSpan(none, 0).minus_infinity);
	EXPECT_EQ(fieldRange(none, 0), (std::pair{0.0, 0.0}));
	EXPECT_EQ(valueSpan(makeField<double>("v", Association::point, 2, {3.0, 4.0, 1.0, -kInfinity}), kMagnitude).hi,
	          5.0);
	std::vector<double> many(1000003, 1.0);
	many[999999] = kInfinity;
	EXPECT_TRUE(valueSpan(makeField("f", Association::point, 1, std::move(many)), 0).plus_infinity);
}

TEST(Field, RangeOfMagnitude)
{
	const Field field = makeField<float>("v", Association::point, 3, {3, 4, 0, 0, 0, 1, 2, NAN, 0});
	EXPECT_EQ(fieldRange(field, kMagnitude), (std::pair{1.0, 5.0}));
}

TEST(Field, RangeOfMany)
{
	std::vector<float> values(1000003);
	for (std::size_t i = 0; i < values.size(); ++i)
		values[i] = i % 7 == 0 ? NAN : static_cast<float>(i % 1000);
	values[700001] = -5.0f;
	values[999999] = 5000.0f;
	EXPECT_EQ(fieldRange(makeField("f", Association::point, 1, std::move(values)), 0), (std::pair{-5.0, 5000.0}));
}

} // namespace
} // namespace vp::grid
