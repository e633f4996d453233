#include "read/child.h"
#include "read/read.h"
#include "read/sandbox.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>

#include <dlfcn.h>
#include <link.h>
#include <sys/stat.h>

using namespace vp;
using namespace vp::read;

namespace
{

namespace fs = std::filesystem;

// Skips a test where the system has no Landlock.
class FilesOfSandbox : public testing::Test
{
protected:
	void SetUp() override
	{
		if (const auto held = tryOutSandbox(); !held || !held->starts_with("landlock"))
			GTEST_SKIP() << "this system has no Landlock";
	}
};

std::string rawHead(const std::string& data)
{
	return "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = " + data + "\n";
}

} // namespace

TEST_F(FilesOfSandbox, AreNamedWhereItDoesNotOpenThem)
{
	const TemporaryFolder folder;
	fs::create_directories(folder / "data");
	fs::create_directories(folder / "far");
	writeContents(folder / "far/a.raw", "12345678");
	const std::string input = folder / "data/a.mhd";
	writeContents(input, rawHead("../far/a.raw"));
	const auto refused = readInputs({input}, {}, nullptr);
	ASSERT_FALSE(refused);
	EXPECT_EQ(refused.error().message,
	          input + ": names the file " + (folder / "data/../far/a.raw") +
	              ", which the reader's sandbox does not open; if you trust the input, give --follow " +
	              fs::canonical(folder / "far").string());
	for (const std::string& follow : {folder / "far", std::string("anywhere")})
	{
		setFollow({follow});
		const auto followed = readInputs({input}, {}, nullptr);
		setFollow({});
		EXPECT_TRUE(followed) << (followed ? "" : followed.error().message);
	}
}

// The link's folder and that of the file itself are both open.
TEST(Sandbox, FollowsALinkToTheInput)
{
	const TemporaryFolder folder;
	fs::create_directories(folder / "data");
	fs::create_directories(folder / "links");
	writeContents(folder / "data/a.mhd", rawHead("a.raw"));
	writeContents(folder / "data/a.raw", "12345678");
	fs::create_symlink(folder / "data/a.mhd", folder / "links/a.mhd");
	fs::create_symlink(folder / "data/a.raw", folder / "links/a.raw");
	const auto read = readInputs({folder / "links/a.mhd"}, {}, nullptr);
	EXPECT_TRUE(read) << (read ? "" : read.error().message);
}

// A pipe without a writer would hold the reader until its time is over.
TEST(NamedFile, ThatIsAPipeIsRefusedAtOnce)
{
	const TemporaryFolder folder;
	ASSERT_EQ(mkfifo((folder / "a.raw").c_str(), 0600), 0);
	writeContents(folder / "a.mhd", rawHead("a.raw"));
	const auto start = std::chrono::steady_clock::now();
	const auto read = readInputs({folder / "a.mhd"}, {}, nullptr);
	ASSERT_FALSE(read);
	EXPECT_EQ(read.error().kind, ErrorKind::input);
	EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(8)) << read.error().message;
}

// Keys and other secrets of the user's programs are not handed on.
TEST(Sandbox, HandsOnFewVariables)
{
	setenv("SOME_TOKEN", "secret", 1);
	setenv("LC_ALL", "C", 1);
	const std::vector<std::string> variables = readerEnvironment();
	unsetenv("SOME_TOKEN");
	unsetenv("LC_ALL");
	EXPECT_TRUE(std::ranges::find(variables, "LC_ALL=C") != variables.end());
	EXPECT_TRUE(std::ranges::none_of(variables, [](const std::string& v) { return v.starts_with("SOME_TOKEN"); }));
}

TEST(Sandbox, TakesThreeWords)
{
	EXPECT_EQ(*parseSandbox("auto"), Sandbox::automatic);
	EXPECT_EQ(*parseSandbox("require"), Sandbox::require);
	EXPECT_EQ(*parseSandbox("off"), Sandbox::off);
	ASSERT_FALSE(parseSandbox("maybe"));
	EXPECT_EQ(parseSandbox("maybe").error().message, "must be auto, require or off, not maybe");
}

// A program of the user's own may lie with its libraries in a folder that only LD_LIBRARY_PATH names: of each program
// a copy asks for expat by a name that only that folder has. One becomes the other behind the door.
TEST(Sandbox, LeavesTheFoldersOfLdLibraryPath)
{
	const TemporaryFolder folder;
	for (const char* part : {"programs", "libraries", "data"})
		fs::create_directories(folder / part);
	const Result<std::string> program = readerProgram();
	ASSERT_TRUE(program);
	const std::string name("libexpat.so.1\0", 14), own("libexpat.so.x\0", 14);
	for (const char* more : {"", "-more"})
	{
		std::string contents = contentsOf(*program + more);
		ASSERT_NE(contents.find(name), std::string::npos);
		for (std::size_t at = 0; (at = contents.find(name, at)) != std::string::npos;)
			contents.replace(at, own.size(), own);
		const std::string copy = folder / (std::string("programs/vprobe-read") + more);
		writeContents(copy, contents);
		fs::permissions(copy, fs::perms::owner_all);
	}
	void* const expat = dlopen("libexpat.so.1", RTLD_LAZY);
	ASSERT_NE(expat, nullptr);
	const link_map* place = nullptr;
	ASSERT_EQ(dlinfo(expat, RTLD_DI_LINKMAP, &place), 0);
	fs::copy(place->l_name, folder / "libraries/libexpat.so.x");
	dlclose(expat);
	const SampleFile& sample =
	    *std::ranges::find_if(sampleFiles(), [](const SampleFile& each) { return each.name.ends_with(".vtkhdf"); });
	sample.write(folder / "data/some.file"); // by its ending, the second program would be started at once
	setReaderProgram(folder / "programs/vprobe-read");
	EXPECT_FALSE(readInputs({folder / "data/some.file"}, {}, nullptr));
	const char* const before = std::getenv("LD_LIBRARY_PATH");
	const std::string old = before ? before : "";
	setenv("LD_LIBRARY_PATH", (folder / "libraries").c_str(), 1);
	const auto read = readInputs({folder / "data/some.file"}, {}, nullptr);
	before ? setenv("LD_LIBRARY_PATH", old.c_str(), 1) : unsetenv("LD_LIBRARY_PATH");
	setReaderProgram({});
	EXPECT_TRUE(read) << read.error().message;
	EXPECT_TRUE(sandboxText().ends_with("seccomp")) << sandboxText();
}

TEST(Sandbox, IsTriedOutWithoutAFile)
{
	const Result<std::string> held = tryOutSandbox();
	ASSERT_TRUE(held) << held.error().message;
	EXPECT_TRUE(held->ends_with("seccomp")) << *held;
	setSandbox(Sandbox::off);
	EXPECT_EQ(*tryOutSandbox(), "nothing");
	setSandbox(Sandbox::automatic);
}

// The readings after it do not follow.
TEST_F(FilesOfSandbox, AreFollowedForOneReading)
{
	const TemporaryFolder folder;
	for (const char* part : {"data", "far"})
		fs::create_directories(folder / part);
	writeContents(folder / "far/a.raw", "12345678");
	writeContents(folder / "data/a.mhd", rawHead("../far/a.raw"));
	ReadOptions options;
	options.follow = {folder / "far"};
	EXPECT_TRUE(readInputs({folder / "data/a.mhd"}, options, nullptr));
	EXPECT_FALSE(readInputs({folder / "data/a.mhd"}, {}, nullptr));
	EXPECT_TRUE(checkFollow(folder / "far"));
	EXPECT_TRUE(checkFollow("anywhere"));
	EXPECT_FALSE(checkFollow(folder / "nowhere"));
}
