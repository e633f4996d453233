#include "sample_slice.h"

#include "base/input_files.h"
#include "write/atomic_file.h"
#include "write/file_set.h"
#include "write/own_folder.h"
#include "write/slice_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vp::test
{

namespace
{

Status writeTo(const std::string& path, const std::string& text = "new")
{
	Result<write::AtomicFile> file = write::AtomicFile::create(path);
	if (!file)
		return file.error();
	file->write(text);
	return file->commit();
}

// The error of a write that must fail: one line that names the path.
Error failureOf(const std::string& path)
{
	const Status status = writeTo(path, std::string(100000, 'x'));
	EXPECT_FALSE(status) << path;
	if (status)
		return {};
	EXPECT_EQ(status.error().kind, ErrorKind::output);
	EXPECT_NE(status.error().message.find(path), std::string::npos) << status.error().message;
	EXPECT_EQ(status.error().message.find('\n'), std::string::npos);
	return status.error();
}

// Root may write anywhere; nobody may not.
class WithoutRoot
{
public:
	WithoutRoot() : was_root_(geteuid() == 0)
	{
		constexpr uid_t kNobody = 65534;
		if (was_root_ && seteuid(kNobody) != 0)
			ADD_FAILURE() << "no way to become nobody";
	}
	~WithoutRoot()
	{
		if (was_root_ && seteuid(0) != 0)
			ADD_FAILURE() << "no way back";
	}

private:
	bool was_root_;
};

} // namespace

// Under whatever name: a link, a hard link, another spelling, the file itself.
TEST(AtomicFile, NeverTakesThePlaceOfAnInput)
{
	const TemporaryFolder folder;
	const std::string input = folder / "input.vtu";
	writeText(input, "data");
	std::filesystem::create_symlink("input.vtu", folder / "link.vtu");
	std::filesystem::create_hard_link(input, folder / "hard.vtu");
	std::filesystem::create_directory(folder / "sub");
	EXPECT_TRUE(writeTo(folder / "before.vtu"));
	noteInput(input);
	for (const std::string name : {"input.vtu", "link.vtu", "hard.vtu", "sub/../input.vtu", "./input.vtu"})
	{
		const Status status = writeTo(folder / name);
		ASSERT_FALSE(status) << name;
		EXPECT_EQ(status.error().kind, ErrorKind::output);
		EXPECT_EQ(status.error().message,
		          folder / name + ": is one of the input files, and would be lost; choose another path");
		EXPECT_FALSE(write::checkWritable(folder / name));
	}
	EXPECT_EQ(readText(input), "data");
	EXPECT_TRUE(writeTo(folder / "other.vtu"));

	// Which files an input names is known only when it has been read.
	Result<write::AtomicFile> piece = write::AtomicFile::create(folder / "before.vtu");
	ASSERT_TRUE(piece);
	piece->write("newer");
	noteInput(folder / "before.vtu");
	EXPECT_FALSE(piece->commit());
	EXPECT_EQ(readText(folder / "before.vtu"), "new");

	// One that is gone, and whose number another file may have by now, protects nothing.
	noteInput(folder / "other.vtu");
	std::filesystem::remove(folder / "other.vtu");
	EXPECT_TRUE(writeTo(folder / "other.vtu"));
}

TEST(AtomicFile, TakesThePlaceOfAStateOnlyAsAState)
{
	const TemporaryFolder folder;
	writeText(folder / "state.json", "old");
	noteInput(folder / "state.json", InputKind::state);
	EXPECT_FALSE(write::checkWritable(folder / "state.json"));
	EXPECT_TRUE(write::AtomicFile::create(folder / "state.json", true));
	noteInput(folder / "state.json"); // as data too
	EXPECT_FALSE(write::AtomicFile::create(folder / "state.json", true));
}

TEST(OwnFolder, GoesWithWhatIsInIt)
{
	const TemporaryFolder folder;
	std::string made;
	{
		const Result<write::OwnFolder> own = write::OwnFolder::besideFile(folder / "none/out.vtm");
		ASSERT_TRUE(own);
		made = own->path();
		EXPECT_EQ(std::filesystem::path(made).parent_path(), std::filesystem::path(folder / "none").parent_path());
		writeText(made + "/piece", "x");
	}
	EXPECT_FALSE(std::filesystem::exists(made));
}

// Somebody else makes the folder of the pieces while they are being written.
TEST(FileSet, LeavesAFolderThatIsNotItsOwn)
{
	const TemporaryFolder folder;
	{
		Result<write::FileSet> set = write::FileSet::create(folder / "out.vtm");
		ASSERT_TRUE(set);
		writeText(set->add("out_0.vtu").write_to, "piece");
		std::filesystem::create_directory(folder / "out");
		writeText(folder / "out/mine", "keep");
		const Status status = set->commit("index", true);
		ASSERT_FALSE(status);
		EXPECT_EQ(status.error().message, folder / "out" + ": is there already; move it away, or choose another name");
	}
	EXPECT_EQ(readText(folder / "out/mine"), "keep");
	EXPECT_FALSE(std::filesystem::exists(folder / "out/out_0.vtu"));
	EXPECT_FALSE(std::filesystem::exists(folder / "out.vtm"));
	EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(AtomicFile, AppearsOnCommit)
{
	const TemporaryFolder folder;
	{
		Result<write::AtomicFile> file = write::AtomicFile::create(folder / "out");
		ASSERT_TRUE(file);
		file->write("half");
		EXPECT_FALSE(std::filesystem::exists(folder / "out"));
		file->write(" and half");
		ASSERT_TRUE(file->commit());
	}
	EXPECT_EQ(readText(folder / "out"), "half and half");
	EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, WithoutCommitNothingIsLeft)
{
	const TemporaryFolder folder;
	writeText(folder / "out", "old");
	{
		Result<write::AtomicFile> file = write::AtomicFile::create(folder / "out");
		ASSERT_TRUE(file);
		file->write("new");
	}
	EXPECT_EQ(readText(folder / "out"), "old");
	EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, ReplacesWhatALinkPointsTo)
{
	const TemporaryFolder folder;
	writeText(folder / "file", "old");
	std::filesystem::create_symlink("file", folder / "link");
	ASSERT_TRUE(writeTo(folder / "link"));
	EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
	EXPECT_EQ(readText(folder / "file"), "new");
	EXPECT_EQ(folder.files(), 2u);
}

TEST(AtomicFile, KeepsThePermissionsOfTheOldFile)
{
	const TemporaryFolder folder;
	writeText(folder / "out", "old");
	ASSERT_EQ(chmod((folder / "out").c_str(), 0666), 0);
	ASSERT_TRUE(writeTo(folder / "out"));
	struct stat status;
	ASSERT_EQ(stat((folder / "out").c_str(), &status), 0);
	EXPECT_EQ(status.st_mode & 0777, 0666u);
}

TEST(AtomicFile, MakesFoldersWhenItIsComplete)
{
	const TemporaryFolder folder;
	{
		Result<write::AtomicFile> file = write::AtomicFile::create(folder / "a/b/out");
		ASSERT_TRUE(file);
		file->write("new");
		EXPECT_FALSE(std::filesystem::exists(folder / "a"));
	}
	EXPECT_EQ(folder.files(), 0u);
	ASSERT_TRUE(writeTo(folder / "a/b/out"));
	EXPECT_TRUE(std::filesystem::is_regular_file(folder / "a/b/out"));
}

TEST(AtomicFile, TellsWhatStandsInTheWay)
{
	const TemporaryFolder folder;
	writeText(folder / "file", "old");
	EXPECT_NE(failureOf(folder / "file/out").message.find("in the place of its folder"), std::string::npos);
	EXPECT_NE(failureOf(folder.path()).message.find("name of a file"), std::string::npos);
	EXPECT_NE(failureOf(folder / std::string(300, 'n')).message.find("shorter"), std::string::npos);
	EXPECT_NE(failureOf(folder / ("new/" + std::string(300, 'n') + "/out")).message.find("shorter"), std::string::npos);
	EXPECT_NE(failureOf(folder / "new/").message.find("name of a file"), std::string::npos);
	EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, ProtectedPlacesStayAsTheyAre)
{
	const TemporaryFolder folder;
	writeText(folder / "file", "old");
	ASSERT_EQ(chmod((folder / "file").c_str(), 0444), 0);
	ASSERT_EQ(chmod(folder.path().c_str(), 0555), 0);
	const WithoutRoot without_root;
	EXPECT_NE(failureOf(folder / "file").message.find("permissions"), std::string::npos);
	EXPECT_NE(failureOf(folder / "out").message.find("permissions"), std::string::npos);
	EXPECT_EQ(readText(folder / "file"), "old");
	EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, AFullDiskIsAnError)
{
	if (!std::filesystem::exists("/dev/full"))
		GTEST_SKIP() << "no /dev/full";
	EXPECT_NE(failureOf("/dev/full").message.find("make room"), std::string::npos);
	EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));

	const SampleSlice sample = sampleSlice();
	const Status status = write::writeSlice(sample.blocks, sample.meshes, "/dev/full");
	ASSERT_FALSE(status);
	EXPECT_EQ(status.error().kind, ErrorKind::output);
}

TEST(AtomicFile, WritesThroughAPipe)
{
	const TemporaryFolder folder;
	ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
	std::string received;
	std::thread reader([&] { received = readText(folder / "pipe"); });
	const std::string text(200000, 'p'); // more than a pipe holds
	EXPECT_TRUE(writeTo(folder / "pipe", text));
	reader.join();
	EXPECT_EQ(received, text);
}

TEST(SliceFormat, FollowsTheEnding)
{
	EXPECT_EQ(write::sliceFormatOf("a.b/cut.vtp").value(), write::SliceFormat::vtp);
	EXPECT_EQ(write::sliceFormatOf("CUT.Ply").value(), write::SliceFormat::ply);
	EXPECT_EQ(write::sliceFormatOf("cut.csv").value(), write::SliceFormat::csv);
	EXPECT_EQ(write::sliceFormatOf("cut.pvtp").value(), write::SliceFormat::pvtp);
	EXPECT_EQ(write::sliceFormatOf("-").value(), write::SliceFormat::vtp);
	for (const char* path : {"cut", "cut.vtu", "cut.vtp/", ".vtp", ""})
	{
		const Result<write::SliceFormat> format = write::sliceFormatOf(path);
		ASSERT_FALSE(format) << path;
		EXPECT_EQ(format.error().kind, ErrorKind::usage);
		for (const char* ending : {".vtp", ".ply", ".csv"})
			EXPECT_NE(format.error().message.find(ending), std::string::npos);
	}
}

TEST(SliceFile, AFailureLeavesNoOutput)
{
	const SampleSlice sample = sampleSlice();
	const TemporaryFolder folder;
	writeText(folder / "none", "a file where the folder would be");
	for (const char* name : {"none/cut.vtp", "none/cut.ply", "none/cut.csv", "none/cut.pvtp", "cut.stl"})
		EXPECT_FALSE(write::writeSlice(sample.blocks, sample.meshes, folder / name));
	EXPECT_EQ(folder.files(), 1u);
}

} // namespace vp::test
