#include "base/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

using vp::ExactSum;

namespace
{

double sumOf(const std::vector<double>& numbers)
{
	ExactSum sum;
	for (const double number : numbers)
		sum += number;
	return sum.value();
}

// Returns numbers of any exponent except the largest, and of both signs.
std::vector<double> anyNumbers(std::size_t count, std::mt19937_64& random)
{
	std::vector<double> numbers;
	while (numbers.size() < count)
	{
		const auto number = std::bit_cast<double>(random());
		if (std::isfinite(number) && std::abs(number) < 1e300)
			numbers.push_back(number);
	}
	return numbers;
}

} // namespace

TEST(ExactSum, OfOneNumberIsTheNumber)
{
	std::mt19937_64 random(1);
	std::vector<double> numbers = anyNumbers(2000, random);
	numbers.insert(numbers.end(), {0.0, 5e-324, -5e-324, std::numeric_limits<double>::min(), 1.0, -1.0, 0.1,
	                               std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()});
	for (const double number : numbers)
		EXPECT_EQ(sumOf({number}), number);
	EXPECT_EQ(sumOf({}), 0.0);
}

TEST(ExactSum, KeepsEveryBit)
{
	EXPECT_EQ(sumOf({1e300, 1.0, -1e300}), 1.0);
	EXPECT_EQ(sumOf({1.0, 5e-324, -1.0}), 5e-324);
	EXPECT_EQ(sumOf({0.1, 0.2, 0.3, -0.3, -0.2, -0.1}), 0.0);
	// Half a bit is rounded to even, and anything beside it decides.
	const double next = std::nextafter(1.0, 2.0);
	EXPECT_EQ(sumOf({1.0, 0x1p-53}), 1.0);
	EXPECT_EQ(sumOf({next, 0x1p-53}), std::nextafter(next, 2.0));
	EXPECT_EQ(sumOf({1.0, 0x1p-53, 5e-324}), next);
	EXPECT_EQ(sumOf({-1.0, -0x1p-53, -5e-324}), -next);
}

TEST(ExactSum, OfWholeNumbersIsTheirSum)
{
	std::mt19937_64 random(2);
	for (int round = 0; round < 200; ++round)
	{
		std::vector<double> numbers;
		std::int64_t sum = 0;
		for (int i = 0; i < 100; ++i)
		{
			const auto number = static_cast<std::int64_t>(random() >> 20) - (std::int64_t(1) << 43);
			sum += number;
			numbers.push_back(static_cast<double>(number));
		}
		EXPECT_EQ(sumOf(numbers), static_cast<double>(sum));
	}
}

TEST(ExactSum, DependsNeitherOnOrderNorOnParts)
{
	std::mt19937_64 random(3);
	std::vector<double> numbers = anyNumbers(1000, random);
	const double whole = sumOf(numbers);
	for (int round = 0; round < 20; ++round)
	{
		std::ranges::shuffle(numbers, random);
		ExactSum sum;
		for (std::size_t begin = 0; begin < numbers.size();)
		{
			const std::size_t end = std::min(numbers.size(), begin + 1 + random() % 300);
			ExactSum part;
			for (; begin < end; ++begin)
				part += numbers[begin];
			sum += part;
		}
		EXPECT_EQ(sum.value(), whole);
	}
}

TEST(ExactSum, HoldsManyLargeNumbers)
{
	ExactSum sum;
	ExactSum many;
	for (int i = 0; i < 4096; ++i)
		many += 1.0 - 0x1p-53;
	for (int i = 0; i < 1'000'000; ++i)
		sum += many;
	EXPECT_EQ(sum.value(), 4096e6 * (1.0 - 0x1p-53));
}

TEST(ExactSum, IsNotFiniteWhereANumberIsNot)
{
	constexpr double infinity = std::numeric_limits<double>::infinity();
	EXPECT_EQ(sumOf({1.0, infinity, 2.0}), infinity);
	EXPECT_EQ(sumOf({1.0, -infinity}), -infinity);
	EXPECT_TRUE(std::isnan(sumOf({infinity, -infinity})));
	EXPECT_TRUE(std::isnan(sumOf({std::nan(""), 1.0})));
}
