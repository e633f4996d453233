#include "base/array.h"

#include <gtest/gtest.h>

#include <utility>

namespace vp::test
{

TEST(Array, OwnsAVector)
{
	const Array<int> array(std::vector<int>{3, 1, 2});
	ASSERT_EQ(array.size(), 3u);
	EXPECT_EQ(array[1], 1);
	EXPECT_EQ(array.span().back(), 2);
	EXPECT_FALSE(array.empty());
	EXPECT_TRUE(Array<int>().empty());
}

TEST(Array, CopiesShareTheMemory)
{
	Array<int> copy;
	const int* data = nullptr;
	{
		const Array<int> array(std::vector<int>{5, 6});
		data = array.data();
		copy = array;
	}
	EXPECT_EQ(copy.data(), data);
	EXPECT_EQ(copy[1], 6);
}

TEST(Array, KeepsTheOwnerOfForeignMemory)
{
	auto memory = std::make_shared<std::vector<double>>(std::vector<double>{1.0, 2.0, 3.0, 4.0});
	std::weak_ptr<std::vector<double>> watch = memory;
	{
		const double* inner = memory->data() + 1;
		const Array<double> part(std::move(memory), inner, 2);
		ASSERT_FALSE(watch.expired());
		EXPECT_EQ(part[0], 2.0);
		EXPECT_EQ(part.size(), 2u);
	}
	EXPECT_TRUE(watch.expired());
}

} // namespace vp::test
