#include "exit_code.h"
#include "report/console.h"

#include <gtest/gtest.h>

namespace vp::test
{

using app::withOptionNames;

TEST(Console, SettingsGetTheNamesOfOptions)
{
	EXPECT_EQ(withOptionNames("`vector_array` s: has 1 component"), "--vector-array s: has 1 component");
	EXPECT_EQ(withOptionNames("use `classify` cpu or leave `context` out"),
	          "use --classify cpu or leave --context out");
	EXPECT_EQ(withOptionNames("nothing to name"), "nothing to name");
}

TEST(Console, OtherBackquotesStay)
{
	EXPECT_EQ(withOptionNames("my`file.vti: no"), "my`file.vti: no");
	EXPECT_EQ(withOptionNames("A`B C`time`"), "A`B C--time");
	EXPECT_EQ(withOptionNames("``"), "``");
	EXPECT_EQ(withOptionNames("`"), "`");
}

TEST(ExitCode, ScriptsRelyOnTheNumbers)
{
	const auto status = [](ErrorKind kind) { return static_cast<int>(app::exitCodeOf(kind)); };
	EXPECT_EQ(static_cast<int>(app::ExitCode::done), 0);
	EXPECT_EQ(status(ErrorKind::usage), 1);
	EXPECT_EQ(status(ErrorKind::input), 2);
	EXPECT_EQ(status(ErrorKind::device), 3);
	EXPECT_EQ(status(ErrorKind::output), 4);
	EXPECT_EQ(status(ErrorKind::out_of_memory), 4);
	EXPECT_EQ(status(ErrorKind::internal), 4);
	EXPECT_EQ(status(ErrorKind::found), 5);
	EXPECT_EQ(status(ErrorKind::cancelled), 130);
}

} // namespace vp::test
