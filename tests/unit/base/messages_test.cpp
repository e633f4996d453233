#include "base/messages.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vp::test
{

TEST(Messages, TheYoungestListenerHears)
{
	warn("dropped");
	std::vector<std::string> first;
	std::vector<std::string> second;
	{
		const MessageListener outer([&](Severity, std::string_view line) { first.emplace_back(line); });
		warn("one {}", 1);
		{
			const MessageListener inner([&](Severity, std::string_view line) { second.emplace_back(line); });
			warn("two");
		}
		report(Severity::error, "three");
	}
	warn("dropped too");
	EXPECT_EQ(first, (std::vector<std::string>{"one 1", "three"}));
	EXPECT_EQ(second, (std::vector<std::string>{"two"}));
}

} // namespace vp::test
