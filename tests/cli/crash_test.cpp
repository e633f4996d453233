// The last word of a program that crashes, and exit codes of signals.

#include "program.h"

#include <csignal>

namespace cli
{

namespace
{

class Crash : public Drawing
{
protected:
	Outcome with(const char* library, const Arguments& arguments) const
	{
		return run(arguments, {.environment = {{"LD_PRELOAD", library}}});
	}
};

} // namespace

TEST_F(Crash, InADriverNamesTheDevice)
{
	const Outcome outcome = with(VPROBE_CRASHING_DRIVER, {"render", "demo:shell:8", "-o", path("a.png")});
	EXPECT_TRUE(isError(outcome, 3, {"driver", "--device"})) << outcome.err;
	EXPECT_TRUE(files().empty());
}

TEST_F(Crash, ElsewhereEndsByItsSignal)
{
	const Outcome outcome = with(VPROBE_CRASHING_LIBRARY, {"slice", "demo:shell:8", "-o", path("a.png")});
	EXPECT_EQ(outcome.status, 128 + SIGSEGV);
	EXPECT_TRUE(contains(outcome.err, "vprobe: crashed; please report it")) << outcome.err;
	EXPECT_TRUE(files().empty());
}

} // namespace cli
