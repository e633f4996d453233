#include "write/file_set.h"

#include "write/atomic_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace vp::write
{

namespace fs = std::filesystem;

Result<std::string> folderOfParts(const std::string& path)
{
	const fs::path file(path);
	std::string folder = (file.parent_path() / file.stem()).string();
	std::error_code failed;
	if (fs::exists(folder, failed) && !fs::is_directory(folder, failed))
		return Error{ErrorKind::output, fmt::format("{}: its parts go to the folder {}, and that is a file; remove it "
		                                            "or choose another name",
		                                            path, folder)};
	return folder;
}

Error folderIsThere(const std::string& folder)
{
	return {ErrorKind::output, fmt::format("{}: is there already; move it away, or choose another name", folder)};
}

Result<FileSet> FileSet::create(const std::string& path)
{
	if (Status free = checkWritable(path); !free)
		return free.error();
	Result<std::string> folder = folderOfParts(path);
	if (!folder)
		return folder.error();
	FileSet set;
	set.path_ = path;
	set.folder_ = std::move(*folder);
	Result<OwnFolder> staging = OwnFolder::besideFile(path);
	if (!staging)
		return staging.error();
	set.staging_.emplace(std::move(*staging));
	return set;
}

FileSet::FileSet(FileSet&& other) noexcept
    : path_(std::move(other.path_)), folder_(std::move(other.folder_)), staging_(std::move(other.staging_)),
      members_(std::move(other.members_)), moved_(std::exchange(other.moved_, {})),
      made_folder_(std::exchange(other.made_folder_, false)), done_(other.done_)
{
}

FileSet::~FileSet()
{
	if (!staging_ || done_)
		return;
	std::error_code ignored;
	for (const std::string& file : moved_)
		fs::remove(file, ignored);
	if (made_folder_)
		fs::remove(folder_, ignored);
}

FileSet::Member FileSet::add(const std::string& name)
{
	members_.push_back(name);
	return {folder() + "/" + name, fs::path(folder_).filename().string() + "/" + name};
}

Status FileSet::moveMembers(bool needs_new_folder)
{
	for (const std::string& name : members_) // before anything is moved
		if (Status free = refuseInput(folder_ + "/" + name); !free)
			return free;
	std::error_code failed;
	fs::create_directories(fs::path(folder_).parent_path(), failed);
	made_folder_ = fs::create_directory(folder_, failed);
	if (needs_new_folder && !failed && !made_folder_)
		return folderIsThere(folder_);
	for (const std::string& name : members_)
	{
		const std::string target = folder_ + "/" + name;
		std::error_code unknown;
		const bool fresh = !fs::exists(fs::symlink_status(target, unknown));
		if (!failed)
			fs::rename(folder() + "/" + name, target, failed);
		if (failed)
			return Error{ErrorKind::output,
			             fmt::format("{}: cannot be written: {}; choose another name", target, failed.message())};
		if (fresh)
			moved_.push_back(target);
	}
	return Nothing{};
}

Status FileSet::commit(const std::string& text, bool needs_new_folder)
{
	Result<AtomicFile> file = AtomicFile::create(path_);
	if (!file)
		return file.error();
	file->write(text);
	if (Status moved = moveMembers(needs_new_folder); !moved)
		return moved;
	Status written = file->commit();
	done_ = static_cast<bool>(written);
	return written;
}

} // namespace vp::write
