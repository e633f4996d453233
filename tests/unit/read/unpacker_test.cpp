#include "parts/source.h"
#include "read/unpacker.h"
#include "sample_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include <sys/wait.h>
#include <unistd.h>

namespace vp::read
{

namespace
{

constexpr const char* kWaitForRequest = R"~([ "$(head -c 8 | wc -c)" = 8 ])~";
constexpr const char* kAnswerOne = R"(printf '\001\000\000\000\000\000\000\000' >&4)";

// A reader that does what a script says. Each part that is asked for has eight bytes.
class ScriptedUnpacker : public testing::Test
{
protected:
	~ScriptedUnpacker() override { setReaderProgram({}); }

	void write(const std::string& script) const
	{
		const std::string program = folder_ / "reader.sh";
		writeContents(program, "#!/bin/sh\n" + script + "\n");
		std::filesystem::permissions(program, std::filesystem::perms::owner_all);
		setReaderProgram(program);
	}
	std::string part() { return part(unpacker_); }
	static std::string part(Unpacker& unpacker)
	{
		std::string bytes(8, '.');
		const Unpacker::Part wanted{{1, 2, 3}, std::as_writable_bytes(std::span(bytes))};
		unpacker.unpack({&wanted, 1});
		return bytes;
	}
	std::string refusal()
	{
		try
		{
			return "unpacked: " + part();
		}
		catch (const parts::Unreadable& error)
		{
			return error.what();
		}
	}

	TemporaryFolder folder_;
	std::string file_ = folder_ / "input.h5";
	Unpacker unpacker_{file_, "vtkhdf", 8, "deflate"};
};

// Numbers its answers.
const std::string kStays = fmt::format("n=0; while {}; do n=$((n+1)); printf part%04d $n >/proc/self/fd/3; {}; done",
                                       kWaitForRequest, kAnswerOne);

} // namespace

TEST_F(ScriptedUnpacker, StaysFromOneCallToTheNext)
{
	write(kStays);
	EXPECT_EQ(part(), "part0001");
	EXPECT_EQ(part(), "part0002");
	Unpacker other{file_, "vtkhdf", 8, "deflate"};
	EXPECT_EQ(part(other), "part0001");
	EXPECT_EQ(part(), "part0003");
}

TEST_F(ScriptedUnpacker, IsReplacedWhenItHasEnded)
{
	write(fmt::format("{}; printf part0001 >/proc/self/fd/3; {}", kWaitForRequest, kAnswerOne));
	EXPECT_EQ(part(), "part0001");
	EXPECT_EQ(part(), "part0001");
}

TEST_F(ScriptedUnpacker, ThatFailsAnewIsAnError)
{
	write(fmt::format("{}; printf part0001 >/proc/self/fd/3; {}", kWaitForRequest, kAnswerOne));
	EXPECT_EQ(part(), "part0001");
	write("echo 'vprobe-read: truncated or damaged: a chunk is' >&2; exit 2");
	EXPECT_EQ(refusal(), file_ + ": truncated or damaged: a chunk is");
	write("kill -SEGV $$");
	EXPECT_EQ(refusal(), file_ + ": the reader crashed (signal 11); the file is damaged or not what its ending says");
}

TEST_F(ScriptedUnpacker, AnswersThatDoNotHoldAreErrors)
{
	const std::string too_few = file_ + ": the reader unpacked fewer parts than were asked for";
	write(fmt::format("{}; printf short >/proc/self/fd/3; {}; sleep 9", kWaitForRequest, kAnswerOne));
	EXPECT_EQ(refusal(), too_few);
	write(fmt::format(R"({}; printf part0001 >/proc/self/fd/3; printf '\002\000\000\000\000\000\000\000' >&4; sleep 9)",
	                  kWaitForRequest));
	EXPECT_EQ(refusal(), too_few);
	write("printf xyz >&4; exit 0");
	EXPECT_EQ(refusal(), file_ + ": the reader gave up (exit code 0); the file is damaged or not what its ending says");
}

// The child of one process does not work for another, and is not killed by it.
TEST_F(ScriptedUnpacker, AForkedProcessStartsItsOwn)
{
	write(kStays);
	EXPECT_EQ(part(), "part0001");
	const pid_t forked = fork();
	if (forked == 0)
		_exit(refusal() == "unpacked: part0001" ? 0 : 1);
	int status = -1;
	waitpid(forked, &status, 0);
	EXPECT_EQ(status, 0);
	EXPECT_EQ(part(), "part0002");
}

} // namespace vp::read
