#pragma once

#include "base/result.h"
#include "write/own_folder.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::write
{

// The folder of the parts of a file that names others: of its stem, beside it. Returns an error if a file is there.
Result<std::string> folderOfParts(const std::string& path);

// The error where that folder is there and may not be.
Error folderIsThere(const std::string& folder);

// A file and others that it names, which lie in a folder of its stem beside it: out.vtm and out/0.vtp. They appear
// together or not at all: until commit() the others are written into a folder of a name no one has. What the stem's
// folder holds else stays there.
class FileSet
{
public:
	static Result<FileSet> create(const std::string& path);
	FileSet(FileSet&& other) noexcept;
	FileSet& operator=(FileSet&&) = delete;
	~FileSet();

	struct Member
	{
		std::string write_to; // until commit()
		std::string name;     // for the file that names it: relative to that one's folder
	};
	Member add(const std::string& name);
	// Returns the folder of the members until commit().
	std::string folder() const { return staging_->path(); }

	// text: of the file that names the others. needs_new_folder: the folder of the stem may not be there.
	Status commit(const std::string& text, bool needs_new_folder = false);

private:
	FileSet() = default;
	Status moveMembers(bool needs_new_folder);

	std::string path_;
	std::string folder_; // folder of the stem
	std::optional<OwnFolder> staging_;
	std::vector<std::string> members_;
	std::vector<std::string> moved_; // files moved to new places; undone if the last step fails
	bool made_folder_ = false;
	bool done_ = false;
};

} // namespace vp::write
