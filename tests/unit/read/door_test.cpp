#include "read/child.h"
#include "read/read.h"
#include "read/ready_reader.h"
#include "read/sandbox.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace vp;
using namespace vp::read;

namespace
{

namespace fs = std::filesystem;

// Runs a reader of the test's own (door_tries.cpp), which closes the program's door and tries what no reader needs. It
// is started for that, or is the copy of one that is ready.
class Door : public testing::TestWithParam<bool>
{
protected:
	Door()
	{
		const fs::path all = fs::path(input_).parent_path().parent_path();
		for (const fs::path& folder : {all, all / "data", all / "home", all / "out"})
		{
			fs::create_directories(folder);
			fs::permissions(folder, fs::perms::all); // the reader tries as an ordinary user
		}
		fs::permissions(fs::path(folder_ / "."), fs::perms::all);
		for (const fs::path& file : {fs::path(input_), all / "data/beside.txt", all / "home/key"})
		{
			writeContents(file, "text");
			chmod(file.c_str(), 0666);
		}
	}
	~Door() override
	{
		setReaderProgram({});
		setSandbox(Sandbox::automatic);
	}

	std::map<std::string, std::string> tries(Sandbox sandbox, ReadOptions options = {})
	{
		setReaderProgram(VPROBE_DOOR_TRIES);
		setSandbox(sandbox);
		InputLimits limits;
		limits.memory = std::uint64_t(2) << 30;
		limits.time = std::chrono::seconds(20);
		const bool by_copy = GetParam();
		if (by_copy)
		{
			ReadOptions nothing;
			nothing.solution = "nothing";
			nothing.ready = options.ready = std::make_shared<ReadyReaders>();
			for (int i = 0; i < 2; ++i)
				EXPECT_TRUE(runReader(input_, nothing, limits));
		}
		const auto handed = runReader(input_, options, limits);
		std::map<std::string, std::string> results;
		EXPECT_TRUE(handed) << handed.error().message;
		std::istringstream lines(handed ? handed->manifest : "");
		for (std::string line; std::getline(lines, line);)
			if (const auto colon = line.find(": "); colon != line.npos)
				results[line.substr(0, colon)] = line.substr(colon + 2);
		return results;
	}

	TemporaryFolder folder_;
	std::string input_ = folder_ / "all/data/input.vtu";
};

bool mayDo(const std::string& name)
{
	return name.starts_with("may ") || name == "holds";
}

// The door leaves open all that sanitizers need.
bool isOpenHere([[maybe_unused]] const std::string& name)
{
#ifdef VPROBE_SANITIZED
	return std::set<std::string>{"process", "program", "program in memory", "environment",
	                             "memory",  "ptrace",  "death signal",      "limits"}
	    .contains(name);
#else
	return false;
#endif
}

// From here on, this process and those that it starts get an error for some calls.
void refuseCalls(std::initializer_list<int> calls, int error)
{
	std::vector<sock_filter> code = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
	for (const int call : calls)
	{
		code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1));
		code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error)));
	}
	code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
	sock_fprog program = {static_cast<unsigned short>(code.size()), code.data()};
	if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
		_exit(9);
}

constexpr int kLandlockCreate = 444;

// Reads a file in a process that gets an error for some calls, and compares what held the reader.
void expectHold(std::initializer_list<int> calls, int error, const std::string& hold)
{
	const TemporaryFolder folder;
	const SampleFile& sample = sampleFiles().front();
	sample.write(folder / sample.name);
	const pid_t child = fork();
	if (child == 0)
	{
		refuseCalls(calls, error);
		if (!readInputs({folder / sample.name}, {}, nullptr))
			_exit(1);
		if (sandboxText() != hold)
			_exit(2);
		setSandbox(Sandbox::require);
		const auto required = readInputs({folder / sample.name}, {}, nullptr);
		_exit(required || required.error().kind != ErrorKind::internal ||
		              required.error().message.find("no full sandbox for its reader (" + hold + ")") ==
		                  std::string::npos
		          ? 3
		          : 0);
	}
	int status = 0;
	waitpid(child, &status, 0);
	EXPECT_TRUE(WIFEXITED(status));
	EXPECT_EQ(WEXITSTATUS(status), 0) << hold;
}

bool hasLandlock()
{
	return syscall(kLandlockCreate, nullptr, 0, 1) > 0;
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Readers, Door, testing::Bool(),
                         [](const auto& about) { return about.param ? "Copied" : "Started"; });

TEST_P(Door, RefusesWhatNoReaderNeeds)
{
	if (!hasLandlock())
		GTEST_SKIP() << "this system has no Landlock";
	const auto results = tries(Sandbox::automatic);
	ASSERT_GT(results.size(), 30u);
	EXPECT_TRUE(results.at("holds").starts_with("landlock ")) << results.at("holds");
	EXPECT_TRUE(results.at("holds").ends_with(", seccomp")) << results.at("holds");
	for (const auto& [name, error] : results)
	{
		if (mayDo(name) || isOpenHere(name))
			continue;
		EXPECT_NE(error, "0") << name;
		EXPECT_NE(error, std::to_string(EPERM)) << name << ": libraries take that for the last word";
	}
	for (const char* need : {"may read", "may load", "may hold memory", "may use threads", "may open more files"})
		EXPECT_EQ(results.at(need), "0") << need;
}

// The same tries work without the door. So the test above sees what it looks for.
TEST_P(Door, IsWhatRefusesThem)
{
	// Systems may refuse these by themselves.
	const std::set<std::string> others{"setxattr", "io_uring",         "namespace", "ptrace",
	                                   "key",      "process_vm_readv", "memory"};
	for (const auto& [name, error] : tries(Sandbox::off))
		if (!others.contains(name) && name != "holds")
			EXPECT_EQ(error, "0") << name;
		else if (error != "0" && name != "holds")
			std::printf("without the sandbox, the system refuses: %s (%s)\n", name.c_str(), error.c_str());
}

TEST_P(Door, LeavesOneFolderToWriteIn)
{
	if (!hasLandlock())
		GTEST_SKIP() << "this system has no Landlock";
	ReadOptions options;
	options.convert_to = folder_ / "all/new.vtu";
	options.convert_folder = folder_ / "all/out";
	const auto results = tries(Sandbox::automatic, options);
	EXPECT_EQ(results.at("may write"), "0");
	for (const char* refused : {"create", "append", "truncate", "unlink", "mkdir", "rename", "read"})
		EXPECT_NE(results.at(refused), "0") << refused;
}

TEST_P(Door, LeavesTheFolderOfAFileThatNamesOthers)
{
	if (!hasLandlock())
		GTEST_SKIP() << "this system has no Landlock";
	EXPECT_NE(tries(Sandbox::automatic).at("read beside"), "0");
	ReadOptions options;
	options.format = "vtk-xml-index";
	EXPECT_EQ(tries(Sandbox::automatic, options).at("read beside"), "0");
	EXPECT_NE(tries(Sandbox::automatic, options).at("read"), "0");
}

// Behind the door, too, and however its parent ends.
TEST_P(Door, LeavesNoReaderWithoutItsParent)
{
	ReadOptions options;
	options.solution = "wait";
	const pid_t parent = fork();
	if (parent == 0)
	{
		tries(Sandbox::automatic, options);
		_exit(0);
	}
	const fs::path told = fs::path(input_).parent_path().parent_path() / "home/number";
	const auto isTrueSoon = [](const auto& condition)
	{
		for (int i = 0; i < 1000 && !condition(); ++i)
			usleep(10'000);
		return condition();
	};
	ASSERT_TRUE(isTrueSoon([&] { return fs::exists(told); }));
	const std::string about = "/proc/" + contentsOf(told.string()) + "/stat";
	EXPECT_TRUE(fs::exists(about));
	kill(parent, SIGKILL);
	waitpid(parent, nullptr, 0);
	// A process that nobody waits for stays in state Z.
	EXPECT_TRUE(isTrueSoon([&] { return !fs::exists(about) || contentsOf(about).find(") Z") != std::string::npos; }));
}

// Older systems and some containers have less of it.
TEST(Sandbox, TakesWhatTheSystemHas)
{
	for (const int error : {ENOSYS, EPERM, EOPNOTSUPP})
		expectHold({kLandlockCreate}, error, "seccomp");
	expectHold({kLandlockCreate, SYS_seccomp}, EPERM, "nothing");
}

TEST(Sandbox, ClosesBeforeAnyLibraryStartsAThread)
{
	if (!hasLandlock())
		GTEST_SKIP() << "this system has no Landlock";
	const TemporaryFolder folder;
	for (const SampleFile& sample : sampleFiles())
		if (sample.name.ends_with(".vti") || sample.name.ends_with(".ex2"))
		{
			sample.write(folder / sample.name);
			ASSERT_TRUE(readInputs({folder / sample.name}, {}, nullptr)) << sample.name;
			EXPECT_TRUE(sandboxText().ends_with(", seccomp")) << sample.name << ": " << sandboxText();
		}
}
