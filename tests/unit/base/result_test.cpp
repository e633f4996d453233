#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace vp::test
{

TEST(Result, HoldsAValue)
{
	Result<std::string> result = std::string("value");
	ASSERT_TRUE(result);
	EXPECT_EQ(*result, "value");
	EXPECT_EQ(result->size(), 5u);
	result->push_back('s');
	EXPECT_EQ(result.value(), "values");
	const Result<std::string>& view = result;
	EXPECT_EQ(*view, "values");
	EXPECT_EQ(view->size(), 6u);
}

TEST(Result, HoldsAReason)
{
	const Result<int> result = Error{ErrorKind::input, "file: damaged"};
	ASSERT_FALSE(result);
	EXPECT_EQ(result.error().kind, ErrorKind::input);
	EXPECT_EQ(result.error().message, "file: damaged");
}

TEST(Result, GivesAwayWhatCannotBeCopied)
{
	Result<std::unique_ptr<int>> result = std::make_unique<int>(3);
	const std::unique_ptr<int> taken = std::move(*result);
	EXPECT_EQ(*taken, 3);
}

TEST(Status, IsNothingOrAReason)
{
	const Status done = Nothing{};
	EXPECT_TRUE(done);
	const Status failed = Error{ErrorKind::output, "full"};
	ASSERT_FALSE(failed);
	EXPECT_EQ(failed.error().message, "full");
}

} // namespace vp::test
