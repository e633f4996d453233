// Runs are killed, or fail, while their files take the places of older ones. This program stands in for the system's
// functions that do that.
#include "sample_slice.h"

#include "write/atomic_file.h"
#include "write/file_set.h"
#include "write/own_folder.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>

#include <dlfcn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

std::optional<int> calls_to_live; // this process is killed in the place of the next such call
bool disk_fails = false;
std::string calls; // "r" for a rename, "f" for what is brought to the disk

void beforeChange()
{
	if (calls_to_live && (*calls_to_live)-- == 0)
		kill(getpid(), SIGKILL);
}

template <class Function>
Function* next(const char* name)
{
	return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" int rename(const char* from, const char* to) noexcept
{
	beforeChange();
	calls += 'r';
	return next<int(const char*, const char*)>("rename")(from, to);
}

extern "C" int remove(const char* path) noexcept
{
	beforeChange();
	return next<int(const char*)>("remove")(path);
}

extern "C" int fsync(int file)
{
	calls += 'f';
	if (!disk_fails)
		return next<int(int)>("fsync")(file);
	errno = EIO;
	return -1;
}

namespace vp::test
{

namespace
{

namespace fs = std::filesystem;

Status replaceBy(const std::string& path, const std::string& text)
{
	Result<write::AtomicFile> file = write::AtomicFile::create(path);
	if (!file)
		return file.error();
	file->write(text);
	return file->commit();
}

// A set of so many pieces that all hold a text.
Status writeSet(const std::string& path, int pieces, const std::string& text)
{
	Result<write::FileSet> set = write::FileSet::create(path);
	if (!set)
		return set.error();
	std::string index = "<VTKFile>";
	for (int i = 0; i < pieces; ++i)
	{
		const write::FileSet::Member member = set->add("sheet_" + std::to_string(i) + ".vtp");
		writeText(member.write_to, text);
		index += "<DataSet file=\"" + member.name + "\"/>\n";
	}
	return set->commit(index);
}

// The texts of the pieces that an index names, joined.
std::string textOfSet(const TemporaryFolder& folder)
{
	const std::string index = readText(folder / "out.vtm");
	const std::string beginning = "file=\"";
	std::string text;
	for (std::size_t at = 0; (at = index.find(beginning, at)) != index.npos;)
	{
		at += beginning.size();
		text += readText(folder / index.substr(at, index.find('"', at) - at)) + " ";
	}
	return text;
}

std::set<std::string> namesIn(const fs::path& folder)
{
	std::set<std::string> names;
	for (const fs::directory_entry& entry : fs::directory_iterator(folder))
		names.insert(entry.path().filename().string());
	return names;
}

// Runs it in a process that is killed before so many calls have changed the folder. Returns false if it ended.
template <class Run>
bool isKilledIn(int call, const Run& run)
{
	const pid_t child = fork();
	if (child == 0)
	{
		calls_to_live = call;
		run();
		_exit(0);
	}
	int status = 0;
	waitpid(child, &status, 0);
	return WIFSIGNALED(status);
}

} // namespace

TEST(ReplacedSet, IsTheOldOrTheNewOneWheneverItIsKilled)
{
	int call = 0;
	for (bool is_killed = true; is_killed; ++call)
	{
		const TemporaryFolder folder;
		ASSERT_TRUE(writeSet(folder / "out.vtm", 3, "old"));
		is_killed = isKilledIn(call, [&] { (void)writeSet(folder / "out.vtm", 2, "new"); });
		const std::string text = textOfSet(folder);
		EXPECT_TRUE(text == "old old old " || text == "new new ") << call << ": " << text;
		EXPECT_TRUE(is_killed || text == "new new ") << text;
		// The next run works in any case, and leaves nothing of the one before. By this name, it has not looked yet.
		ASSERT_TRUE(writeSet(folder / "./out.vtm", 1, "next"));
		EXPECT_EQ(textOfSet(folder), "next ");
		EXPECT_EQ(namesIn(folder.path()), (std::set<std::string>{"out", "out.vtm"})) << call;
	}
	EXPECT_GT(call, 5);
}

TEST(ReplacedSet, LosesWhatTheOldIndexNamesAndNothingElse)
{
	const TemporaryFolder folder;
	ASSERT_TRUE(writeSet(folder / "out.vtm", 3, "old"));
	writeText(folder / "out/notes", "mine");
	ASSERT_TRUE(writeSet(folder / "out.vtm", 2, "new"));
	EXPECT_EQ(namesIn(folder / "out"), (std::set<std::string>{"notes", "sheet_0-2.vtp", "sheet_1-2.vtp"}));
	writeText(folder / "out/sheet_0.vtp", "mine");
	ASSERT_TRUE(writeSet(folder / "out.vtm", 1, "third"));
	EXPECT_EQ(namesIn(folder / "out"), (std::set<std::string>{"notes", "sheet_0.vtp"}));
	// No index names them: they are of the user.
	writeText(folder / "out/sheet_0-2.vtp", "mine");
	ASSERT_TRUE(writeSet(folder / "out.vtm", 1, "fourth"));
	EXPECT_EQ(namesIn(folder / "out"), (std::set<std::string>{"notes", "sheet_0-2.vtp", "sheet_0-3.vtp"}));
	EXPECT_EQ(readText(folder / "out/sheet_0-2.vtp"), "mine");
	// An index that names what lies elsewhere takes nothing with it.
	writeText(folder / "out.vtm", "<VTKFile><DataSet file=\"out/../mine\"/><DataSet file=\"mine\"/></VTKFile>");
	writeText(folder / "mine", "keep");
	ASSERT_TRUE(writeSet(folder / "out.vtm", 1, "fifth"));
	EXPECT_EQ(readText(folder / "mine"), "keep");
}

TEST(ReplacedFile, IsOnTheDiskBeforeItGetsTheName)
{
	const TemporaryFolder folder;
	calls.clear();
	ASSERT_TRUE(replaceBy(folder / "a", "first"));
	EXPECT_EQ(calls, "r"); // nothing can be lost
	calls.clear();
	ASSERT_TRUE(replaceBy(folder / "a", "second"));
	EXPECT_EQ(calls, "frf"); // the file, the name, the folder
	ASSERT_TRUE(writeSet(folder / "out.vtm", 2, "old"));
	calls.clear();
	ASSERT_TRUE(writeSet(folder / "out.vtm", 2, "new"));
	EXPECT_EQ(calls, "ffrrffrf"); // two pieces, their names and folder, the index, its name and folder
}

TEST(ReplacedFile, StaysWhereTheDiskFails)
{
	const TemporaryFolder folder;
	ASSERT_TRUE(replaceBy(folder / "a", "old"));
	ASSERT_TRUE(writeSet(folder / "out.vtm", 2, "old"));
	disk_fails = true;
	const Status file = replaceBy(folder / "a", "new");
	const Status set = writeSet(folder / "out.vtm", 2, "new");
	disk_fails = false;
	ASSERT_FALSE(file);
	EXPECT_EQ(file.error().message, folder / "a: cannot be written: Input/output error; choose another path");
	ASSERT_FALSE(set);
	EXPECT_EQ(readText(folder / "a"), "old");
	EXPECT_EQ(textOfSet(folder), "old old ");
	EXPECT_EQ(namesIn(folder.path()), (std::set<std::string>{"a", "out", "out.vtm"}));
	EXPECT_EQ(namesIn(folder / "out").size(), 2u);
}

// Files and folders of a run that was killed go with the next one; those that somebody holds stay.
TEST(Leftovers, OfADeadRunGo)
{
	const TemporaryFolder folder;
	ASSERT_TRUE(isKilledIn(0,
	                       [&]
	                       {
		                       Result<write::AtomicFile> file = write::AtomicFile::create(folder / "a");
		                       Result<write::OwnFolder> own = write::OwnFolder::besideFile(folder / "b");
		                       writeText(own->path() + "/piece", "x");
		                       (void)file->commit();
	                       }));
	const std::set<std::string> left = namesIn(folder.path());
	ASSERT_EQ(left.size(), 2u);
	// One is of another machine, one of somebody who works.
	const std::string mine = *left.begin();
	const std::string foreign = ".vprobe-elsewhere-" + mine.substr(mine.find('-', 8) + 1);
	const std::string held = mine.substr(0, mine.rfind('-')) + "-100";
	writeText(folder / foreign, "x");
	writeText(folder / held, "x");
	const int lock = open((folder / held).c_str(), O_RDONLY | O_CLOEXEC);
	ASSERT_EQ(flock(lock, LOCK_EX), 0);
	ASSERT_TRUE(replaceBy(folder / "a", "new"));
	EXPECT_EQ(namesIn(folder.path()), (std::set<std::string>{"a", foreign, held}));
	close(lock);
}

// Another run looks for leftovers while this one writes.
TEST(Leftovers, StayAsLongAsTheyAreHeld)
{
	const TemporaryFolder folder;
	Result<write::AtomicFile> file = write::AtomicFile::create(folder / "a");
	ASSERT_TRUE(file);
	file->write("text");
	ASSERT_TRUE(file->close());
	const pid_t child = fork();
	if (child == 0)
	{
		_exit(write::OwnFolder::besideFile(folder / "./b") ? 0 : 1); // it has not looked for leftovers in "./" yet
	}
	int status = 0;
	waitpid(child, &status, 0);
	EXPECT_EQ(status, 0);
	EXPECT_TRUE(file->commit());
	EXPECT_EQ(readText(folder / "a"), "text");
}

} // namespace vp::test
