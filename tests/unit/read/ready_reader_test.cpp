#include "base/sanitized.h"
#include "read/child.h"
#include "read/protocol.h"
#include "read/read.h"
#include "read/ready_reader.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

using namespace vp;
using namespace vp::read;

namespace
{

namespace fs = std::filesystem;

constexpr bool kMakesCopies = !kThreadSanitized; // which has a thread of its own, too

// The readers that make copies, of a process.
std::vector<pid_t> originalsOf(pid_t parent)
{
	std::vector<pid_t> found;
	for (const fs::directory_entry& entry : fs::directory_iterator("/proc"))
	{
		const std::string name = entry.path().filename();
		if (name.find_first_not_of("0123456789") != name.npos)
			continue;
		std::string stat = contentsOf(entry.path() / "stat");
		stat = stat.substr(std::min(stat.rfind(')') + 1, stat.size()));
		std::istringstream rest(stat);
		char state = ' ';
		pid_t of = 0;
		rest >> state >> of;
		if (of == parent && contentsOf(entry.path() / "cmdline").ends_with(std::string("\0copies\0", 8)))
			found.push_back(std::stoi(name));
	}
	return found;
}

// Reads the sample so many times with the same options.
std::vector<std::size_t> cellsOfReadings(const std::string& file, int times, const ReadOptions& options)
{
	std::vector<std::size_t> cells;
	for (int i = 0; i < times; ++i)
	{
		const auto set = readInputs({file}, options, nullptr);
		EXPECT_TRUE(set) << set.error().message;
		cells.push_back(set ? set->cellCount() : 0);
	}
	return cells;
}

class ReadyReaderTest : public testing::Test
{
protected:
	ReadyReaderTest()
	{
		sample_.write(file_);
		options_.ready = std::make_shared<ReadyReaders>();
	}
	~ReadyReaderTest() override { setReaderProgram({}); }

	TemporaryFolder folder_;
	const SampleFile& sample_ = sampleFiles().front();
	std::string file_ = folder_ / sample_.name;
	ReadOptions options_;
};

} // namespace

TEST_F(ReadyReaderTest, IsMadeForTheThirdFileAndEndsWithItsOwner)
{
	const std::vector<std::size_t> right(2, sample_.cells);
	EXPECT_EQ(cellsOfReadings(file_, 2, options_), right);
	EXPECT_TRUE(originalsOf(getpid()).empty());
	EXPECT_EQ(cellsOfReadings(file_, 2, options_), right);
	EXPECT_EQ(originalsOf(getpid()).size(), kMakesCopies ? 1u : 0u);
	options_.ready.reset();
	EXPECT_TRUE(originalsOf(getpid()).empty());
	EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
}

TEST_F(ReadyReaderTest, TellsOfADamagedFileAndReadsTheNext)
{
	const std::string damaged = folder_ / ("damaged" + fs::path(sample_.name).extension().string());
	std::string contents = contentsOf(file_);
	writeContents(damaged, contents.substr(0, contents.size() / 2));
	const auto started = readInputs({damaged}, {}, nullptr);
	ASSERT_FALSE(started);
	cellsOfReadings(file_, 3, options_);
	const auto copied = readInputs({damaged}, options_, nullptr);
	ASSERT_FALSE(copied);
	EXPECT_EQ(copied.error().kind, started.error().kind);
	EXPECT_EQ(copied.error().message, started.error().message);
	EXPECT_EQ(cellsOfReadings(file_, 1, options_).front(), sample_.cells);
}

TEST_F(ReadyReaderTest, MayBeKilledOrMissing)
{
	if (!kMakesCopies)
		GTEST_SKIP() << "the thread sanitizer has a thread in each process";
	cellsOfReadings(file_, 3, options_);
	ASSERT_EQ(originalsOf(getpid()).size(), 1u);
	kill(originalsOf(getpid()).front(), SIGKILL);
	EXPECT_EQ(cellsOfReadings(file_, 3, options_), std::vector<std::size_t>(3, sample_.cells));
	options_.ready.reset();
	EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
}

// Such as another program in place of the reader.
TEST_F(ReadyReaderTest, OfAProgramThatMakesNoCopiesIsDoneWithout)
{
	const std::string program = folder_ / "reader.sh";
	writeContents(program, "#!/bin/sh\n[ \"$1\" = copies ] || echo \"$1\" >&4\n");
	fs::permissions(program, fs::perms::owner_all);
	setReaderProgram(program);
	InputLimits limits;
	limits.memory = 256u << 20;
	limits.time = std::chrono::seconds(10);
	for (int i = 0; i < 5; ++i)
	{
		const auto handed = runReader(file_, options_, limits);
		ASSERT_TRUE(handed) << handed.error().message;
		EXPECT_EQ(handed->manifest, "last\n");
	}
}

TEST_F(ReadyReaderTest, EndsWhenItsParentIsKilled)
{
	if (!kMakesCopies)
		GTEST_SKIP() << "the thread sanitizer has a thread in each process";
	int ready[2];
	ASSERT_EQ(pipe(ready), 0);
	const pid_t parent = fork();
	if (parent == 0)
	{
		cellsOfReadings(file_, 3, options_);
		const char done = 1;
		[[maybe_unused]] const auto written = write(ready[1], &done, 1);
		for (;;)
			pause();
	}
	char done = 0;
	ASSERT_EQ(::read(ready[0], &done, 1), 1);
	const std::vector<pid_t> originals = originalsOf(parent);
	kill(parent, SIGKILL);
	waitpid(parent, nullptr, 0);
	close(ready[0]);
	close(ready[1]);
	ASSERT_EQ(originals.size(), 1u);
	const std::string about = "/proc/" + std::to_string(originals[0]) + "/stat";
	const auto isGone = [&] { return !fs::exists(about) || contentsOf(about).find(") Z") != std::string::npos; };
	for (int i = 0; i < 1000 && !isGone(); ++i)
		usleep(10'000);
	EXPECT_TRUE(isGone());
}

// Whoever forks this process has readers of its own.
TEST_F(ReadyReaderTest, StaysWithTheProcessThatMadeIt)
{
	cellsOfReadings(file_, 3, options_);
	const pid_t child = fork();
	if (child == 0)
	{
		const auto set = readInputs({file_}, options_, nullptr);
		options_.ready.reset();
		_exit(set && set->cellCount() == sample_.cells ? 0 : 1);
	}
	int status = -1;
	waitpid(child, &status, 0);
	EXPECT_EQ(status, 0);
	EXPECT_EQ(cellsOfReadings(file_, 1, options_).front(), sample_.cells);
	EXPECT_EQ(originalsOf(getpid()).size(), kMakesCopies ? 1u : 0u);
}
