#include "write/file_set.h"

#include "base/input_files.h"
#include "write/atomic_file.h"
#include "write/flush.h"
#include "write/xml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

namespace vp::write
{

namespace fs = std::filesystem;

namespace
{

// Returns the names in a folder beside an index of VTK that the index names. Empty for any other file.
std::set<std::string> namesIn(const std::string& index, const std::string& folder)
{
	constexpr std::size_t kMaxBytes = 64u << 20; // longer ones are none of ours
	std::error_code unknown;
	std::set<std::string> names;
	if (const auto bytes = fs::file_size(index, unknown); unknown || bytes > kMaxBytes)
		return names;
	std::ifstream file(index, std::ios::binary);
	const std::string text(std::istreambuf_iterator<char>(file), {});
	if (text.find("<VTKFile") == text.npos)
		return names;
	for (const std::string& beginning :
	     {fmt::format(" file=\"{}/", xmlText(folder)), fmt::format(" Source=\"{}/", xmlText(folder))})
		for (std::size_t at = 0; (at = text.find(beginning, at)) != text.npos;)
		{
			at += beginning.size();
			const std::string name = text.substr(at, text.find('"', at) - at);
			if (name.find_first_of("/&<\n") == name.npos && name != ".." && name != ".") // none of ours has these
				names.insert(name);
		}
	return names;
}

// out_0.vtu becomes out_0-2.vtu where that is free, and so on.
std::string otherName(const std::string& name, const std::set<std::string>& taken, const fs::path& folder)
{
	const fs::path path(name);
	std::error_code unknown;
	std::string other = name;
	for (int i = 2; taken.contains(other) || (i > 2 && fs::exists(fs::symlink_status(folder / other, unknown))); ++i)
		other = fmt::format("{}-{}{}", path.stem().string(), i, path.extension().string());
	return other;
}

} // namespace

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
	std::error_code unknown;
	set.replaces_ = fs::exists(path, unknown);
	set.older_ = namesIn(path, fs::path(set.folder_).filename().string());
	Result<OwnFolder> staging = OwnFolder::besideFile(path);
	if (!staging)
		return staging.error();
	set.staging_.emplace(std::move(*staging));
	return set;
}

FileSet::FileSet(FileSet&& other) noexcept
    : path_(std::move(other.path_)), folder_(std::move(other.folder_)), staging_(std::move(other.staging_)),
      members_(std::move(other.members_)), replaces_(other.replaces_), older_(std::move(other.older_)),
      moved_(std::exchange(other.moved_, {})), made_folder_(std::exchange(other.made_folder_, false)),
      done_(other.done_)
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
	members_.push_back({name, otherName(name, older_, folder_)});
	return {folder() + "/" + name, fs::path(folder_).filename().string() + "/" + members_.back().to};
}

// A set that takes the place of another is on the disk before it does.
Status FileSet::flushMembers()
{
	for (const Move& member : members_)
		if (const int error = flushFileOrFolder(folder() + "/" + member.from))
			return Error{ErrorKind::output,
			             fmt::format("{}/{}: cannot be written: {}; make room or choose another path", folder_,
			                         member.to, std::strerror(error))};
	return Nothing{};
}

// Files that were read stay, and so do links, which nobody of us makes.
void FileSet::removeOlder() const
{
	for (const std::string& name : older_)
	{
		const std::string path = folder_ + "/" + name;
		std::error_code ignored;
		const bool is_own = std::ranges::any_of(members_, [&](const Move& member) { return member.to == name; });
		if (!is_own && !inputAt(path) && fs::is_regular_file(fs::symlink_status(path, ignored)))
			fs::remove(path, ignored);
	}
}

Status FileSet::moveMembers(bool needs_new_folder)
{
	for (const Move& member : members_) // before anything is moved
		if (Status free = refuseInput(folder_ + "/" + member.to); !free)
			return free;
	std::error_code failed;
	fs::create_directories(fs::path(folder_).parent_path(), failed);
	made_folder_ = fs::create_directory(folder_, failed);
	if (needs_new_folder && !failed && !made_folder_ && older_.empty())
		return folderIsThere(folder_);
	for (const auto& [from, to] : members_)
	{
		const std::string target = folder_ + "/" + to;
		std::error_code unknown;
		const bool fresh = !fs::exists(fs::symlink_status(target, unknown));
		if (fresh)
			moved_.push_back(target); // before: there may be no memory to note what has moved
		if (!failed)
			fs::rename(folder() + "/" + from, target, failed);
		if (failed)
		{
			if (fresh)
				moved_.pop_back();
			return Error{ErrorKind::output,
			             fmt::format("{}: cannot be written: {}; choose another name", target, failed.message())};
		}
	}
	return Nothing{};
}

Status FileSet::commit(const std::string& text, bool needs_new_folder)
{
	Result<AtomicFile> file = AtomicFile::create(path_);
	if (!file)
		return file.error();
	file->write(text);
	if (Status flushed = replaces_ ? flushMembers() : Nothing{}; !flushed)
		return flushed;
	if (Status moved = moveMembers(needs_new_folder); !moved)
		return moved;
	if (replaces_)
		(void)flushFileOrFolder(folder_);
	Status written = file->commit();
	done_ = static_cast<bool>(written);
	if (done_)
		removeOlder();
	return written;
}

} // namespace vp::write
