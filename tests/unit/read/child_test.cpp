#include "read/child.h"
#include "read/protocol.h"
#include "read/read.h"
#include "read/reader_process.h"
#include "read/sandbox.h"
#include "sample_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace vp;
using namespace vp::read;

namespace
{

// A reader that does what a script says, in place of vprobe-read.
class ScriptedReader : public testing::Test
{
protected:
	ScriptedReader()
	{
		writeContents(input_, "any");
		limits_.memory = 256u << 20;
		limits_.time = std::chrono::seconds(1);
	}
	~ScriptedReader() override { setReaderProgram({}); }

	Result<HandedOver> run(const std::string& script, const ReadOptions& options = {})
	{
		const std::string program = folder_ / "reader.sh";
		writeContents(program, "#!/bin/sh\n" + script + "\n");
		std::filesystem::permissions(program, std::filesystem::perms::owner_all);
		setReaderProgram(program);
		return runReader(input_, options, limits_);
	}
	void expectError(const std::string& script, ErrorKind kind, const std::string& message)
	{
		const auto start = std::chrono::steady_clock::now();
		const auto handed = run(script);
		ASSERT_FALSE(handed) << script;
		EXPECT_EQ(handed.error().kind, kind) << script;
		EXPECT_EQ(handed.error().message, message) << script;
		EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << script;
	}

	TemporaryFolder folder_;
	std::string input_ = folder_ / "input.vtu";
	InputLimits limits_;
};

} // namespace

TEST_F(ScriptedReader, ThatCrashesIsAnInputError)
{
	expectError("kill -SEGV $$", ErrorKind::input,
	            input_ + ": the reader crashed (signal 11); the file is damaged or not what its ending says");
	expectError("echo half >&4; kill -ABRT $$", ErrorKind::input,
	            input_ + ": the reader crashed (signal 6); the file is damaged or not what its ending says");
}

// The file need not be damaged, and the user must not think so.
TEST_F(ScriptedReader, ThatIsKilledBlamesNoFile)
{
	expectError("kill -KILL $$", ErrorKind::internal,
	            input_ +
	                ": the reader was killed (signal 9), as the system does when memory runs out; free some and try "
	                "again");
	expectError("kill -XCPU $$", ErrorKind::internal,
	            input_ + ": the reader was killed (signal 24), since it used up its processor time; raise that limit "
	                     "(ulimit -t)");
	expectError("kill -TERM $$", ErrorKind::internal,
	            input_ + ": the reader was killed (signal 15), from outside; try again");
	// With the piece that it told of last.
	expectError(
	    "echo 'vprobe-read-file: a.vti' >&2; echo 'vprobe-read-file: b.vti' >&2; kill -KILL $$", ErrorKind::internal,
	    input_ + ": the reader was killed (signal 9) while it read b.vti, as the system does when memory runs out; "
	             "free some and try again");
}

TEST_F(ScriptedReader, WithoutMemoryIsToldFromDamage)
{
	const std::string script = "echo 'vprobe-read: no memory to read it' >&2; exit 3";
	const std::string remedy = "; make room, or raise the limits of this process (ulimit -v, -f)";
	expectError(script, ErrorKind::out_of_memory, input_ + ": no memory to read it" + remedy);
	expectError("echo \"terminate called after throwing 'std::bad_alloc'\" >&2; kill -ABRT $$",
	            ErrorKind::out_of_memory, input_ + ": there was not enough memory" + remedy);
	// The limit follows from the size of the file: it is the file that claims too much.
	limits_.follows_size = true;
	expectError(script, ErrorKind::input,
	            input_ + ": truncated or damaged: it describes more than a file of its size can hold");
}

TEST_F(ScriptedReader, WithoutRoomForItsOutputNamesThat)
{
	ReadOptions options;
	options.convert_to = "out.vtu";
	const auto handed = run("echo 'vprobe-read: cannot be written: the disk is full' >&2; exit 4", options);
	ASSERT_FALSE(handed);
	EXPECT_EQ(handed.error().kind, ErrorKind::output);
	EXPECT_EQ(handed.error().message, "out.vtu: cannot be written: the disk is full");
}

TEST_F(ScriptedReader, ThatHangsIsEnded)
{
	const std::string message = input_ + ": the reader ran over its time limit of 1 s";
	expectError("sleep 60", ErrorKind::input, message);
	expectError("exec 2>&- 3>&- 4>&- 5>&-; sleep 60", ErrorKind::input, message);
	expectError("sleep 60 & exit 0", ErrorKind::input, message);
	expectError("yes >&2", ErrorKind::input, message);
}

TEST_F(ScriptedReader, ThatGivesUpIsAnInputErrorWithItsReason)
{
	expectError("echo chatter >&2; echo 'vprobe-read: no such thing' >&2; exit 2", ErrorKind::input,
	            input_ + ": no such thing");
	expectError("echo chatter >&2; exit 2", ErrorKind::input,
	            input_ + ": the reader gave up (exit code 2); the file is damaged or not what its ending says");
	limits_.time = std::chrono::seconds(10);
	const auto greedy = run("x=$(head -c 400000000 /dev/zero | tr '\\0' x); exit 3");
	ASSERT_FALSE(greedy);
	EXPECT_EQ(greedy.error().kind, ErrorKind::input);
}

TEST_F(ScriptedReader, ThatWritesTooMuchIsEnded)
{
	limits_.time = std::chrono::seconds(20);
	const auto handed = run("cat /dev/zero >&4");
	ASSERT_FALSE(handed);
	EXPECT_EQ(handed.error().kind, ErrorKind::input);
	EXPECT_EQ(handed.error().message, input_ + ": describes more arrays than can be");

	// The arrays are held to the memory's limit.
	EXPECT_FALSE(run("cat /dev/zero >&3"));
	EXPECT_FALSE(run("cat /dev/zero >&5"));
}

TEST_F(ScriptedReader, ThatSaysNothingIsAnInputError)
{
	ASSERT_TRUE(run("exit 0"));
	const auto set = readInputs({input_}, {}, nullptr);
	ASSERT_FALSE(set);
	EXPECT_EQ(set.error().kind, ErrorKind::input);
}

TEST_F(ScriptedReader, GetsItsArgumentsAndNoOtherDescriptors)
{
	ReadOptions options;
	options.time = {TimeChoice::Kind::value, 2.5};
	options.displace = 0.5;
	options.displace_by = "my moves";
	options.solution = "some.q";
	options.refine = 3;
	options.patches = true;
	options.arrays = {false, {"p", "cell:q"}, true};
	options.format = "raw";
	options.raw.size = {8, 4, 2};
	options.convert_to = "out.vti";
	options.convert_folder = "out.new";
	options.cells_of_part = 4096;
	options.stays_above = 4096;
	options.unpack = "64 deflate";
	options.level = 2;
	setFollow({"/data", "anywhere"});
	const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
	constexpr int leaked = 50;
	ASSERT_EQ(dup2(STDERR_FILENO, leaked), leaked);
	const auto handed =
	    run("echo \"$1|$2|$3|$4|$5|$6|$7|$8|$9|${10}|${11}|${12}|${13}|${14}|${15}|${16}|${17}|${18}|${19}\" >&4; "
	        "[ -e /proc/$$/fd/50 ] && "
	        "echo leaked >&4; exit 0",
	        options);
	close(leaked);
	setFollow({});
	ASSERT_TRUE(handed) << handed.error().message;
	EXPECT_EQ(handed->manifest, "2.5|some.q|3|0.5 my moves|1|1|^\n=p\n=cell:q|raw|8x4x2 uint8 1x1x1 "
	                            "little|out.vti|out.new|4096||auto|/data\nanywhere|4096|64 deflate|2|" +
	                                input_ + "\n");
}

TEST_F(ScriptedReader, MayOpenSoManyFiles)
{
	const auto handed = run("ulimit -Hn >&4; exit 0");
	ASSERT_TRUE(handed) << handed.error().message;
	EXPECT_LE(std::stoul(handed->manifest), 1u << 16) << handed->manifest;
}

TEST_F(ScriptedReader, AListOfPartsIsNoAnswerForBlocks)
{
	const std::string list =
	    fmt::format(R"({{"version": {}, "times": [], "warnings": [], "left_out": 0, "blocks": [], )"
	                R"("bytes_read": 0, "wholes": [null], "parts": [{{"cells": 8, "block": 0}}]}})",
	                kProtocolVersion);
	ASSERT_TRUE(run("echo '" + list + "' >&4"));
	const auto set = readInputs({input_}, {}, nullptr);
	ASSERT_FALSE(set);
	EXPECT_EQ(set.error().message, input_ + ": truncated or damaged: the reader answered another question");
	ASSERT_TRUE(listParts({input_}, {}, nullptr));
}

// A shell in place of the reader, as runReader() starts it.
class StartedShell
{
public:
	explicit StartedShell(std::string script) : script_(std::move(script))
	{
		setup_.program = "/bin/sh";
		setup_.arguments = arguments_.data();
		setup_.environment = environ;
		setup_.null = setup_.requests = null_.get();
		setup_.errors = setup_.arrays = setup_.cells = null_.get();
		setup_.manifest = told_.write_end.get();
		setup_.life = life_.read_end.get();
		setup_.parent = getpid();
		setup_.memory = setup_.file_size = setup_.time = {RLIM_INFINITY, RLIM_INFINITY};
		getrlimit(RLIMIT_NOFILE, &setup_.files);
	}
	void start()
	{
		process_ = fork();
		if (process_ == 0)
			becomeReader(setup_);
		told_.write_end.reset();
		life_.read_end.reset();
	}
	void closePipe() { life_.write_end.reset(); }
	// All that it and what it started have written, once all of them have ended.
	std::string told()
	{
		std::string text;
		std::array<char, 256> buffer;
		for (ssize_t n; (n = ::read(told_.read_end.get(), buffer.data(), buffer.size())) > 0;)
			text.append(buffer.data(), static_cast<std::size_t>(n));
		waitpid(process_, &status, 0);
		return text;
	}

	int status = 0; // from waitpid()

private:
	std::string name_ = "sh", option_ = "-c", script_;
	Descriptor null_ = lifted(open("/dev/null", O_RDWR | O_CLOEXEC));
	Pipe told_ = makePipe(), life_ = makePipe();
	std::array<char*, 4> arguments_{name_.data(), option_.data(), script_.data(), nullptr};
	ChildSetup setup_ = {};
	pid_t process_ = -1;
};

TEST(ReaderProcess, OutlivesTheThreadThatStartedIt)
{
	StartedShell shell("sleep 0.3; echo done >&4");
	std::thread([&] { shell.start(); }).join();
	EXPECT_EQ(shell.told(), "done\n");
	EXPECT_EQ(shell.status, 0);
}

TEST(ReaderProcess, EndsWithAllThatItStartedWhenThePipeCloses)
{
	const auto start = std::chrono::steady_clock::now();
	StartedShell shell("sleep 60 & sleep 60");
	shell.start();
	std::this_thread::sleep_for(std::chrono::milliseconds(200));
	shell.closePipe();
	EXPECT_EQ(shell.told(), "");
	EXPECT_TRUE(WIFSIGNALED(shell.status) && WTERMSIG(shell.status) == SIGKILL) << shell.status;
	EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(ReaderProgram, ThatIsMissingIsNoInputError)
{
	const TemporaryFolder folder;
	writeContents(folder / "a.vti", "x");
	setReaderProgram(folder / "absent");
	const auto set = readInputs({folder / "a.vti"}, {}, nullptr);
	setReaderProgram({});
	ASSERT_FALSE(set);
	EXPECT_EQ(set.error().kind, ErrorKind::internal);
	EXPECT_EQ(set.error().message, "vprobe-read cannot be started: No such file or directory");
}

TEST(InputPath, ThatIsNoReadableFileIsAnInputError)
{
	const TemporaryFolder folder;
	const auto reason = [&](const std::string& name)
	{
		const auto set = readInputs({folder / name}, {}, nullptr);
		EXPECT_FALSE(set);
		EXPECT_EQ(set.error().kind, ErrorKind::input);
		EXPECT_TRUE(set.error().message.starts_with(folder / name));
		return set.error().message.substr((folder / name).size());
	};
	EXPECT_EQ(reason("missing.vti"), ": no such file; check the path");
	EXPECT_EQ(reason("."), ": a folder; name a file in it");
	writeContents(folder / "empty.vtu", "");
	EXPECT_EQ(reason("empty.vtu"), ": the file is empty");
	writeContents(folder / "notes.txt", "no grid");
	EXPECT_EQ(reason("notes.txt"), ": not a format that can be read; vprobe info --formats lists those that can");
	writeContents(folder / "notes.vtu", "no grid");
	EXPECT_EQ(reason("notes.vtu"), ": truncated or damaged: its first bytes are not those of a .vtu file");
	ASSERT_EQ(mkfifo((folder / "pipe.vti").c_str(), 0600), 0);
	EXPECT_EQ(reason("pipe.vti"), ": not a regular file; copy its contents to one");
	if (geteuid() != 0)
	{
		writeContents(folder / "secret.vti", "x");
		std::filesystem::permissions(folder / "secret.vti", std::filesystem::perms::none);
		EXPECT_EQ(reason("secret.vti"), ": cannot be opened: Permission denied");
	}
}

TEST(InputPath, LimitsFollowTheBytes)
{
	const TemporaryFolder folder;
	writeContents(folder / "small.vti", "x");
	writeContents(folder / "large.raw", "");
	std::filesystem::resize_file(folder / "large.raw", 40u << 20);
	writeContents(folder / "large.mhd", "x");
	const auto small = inputLimits(folder / "small.vti", "");
	const auto large = inputLimits(folder / "large.mhd", ""); // refers to its data
	ASSERT_TRUE(small && large);
	EXPECT_EQ(small->time.count(), 15);
	EXPECT_EQ(large->time.count(), 25);
	EXPECT_GE(large->memory, small->memory);
}
