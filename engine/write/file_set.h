#pragma once

#include "base/result.h"
#include "write/own_folder.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vp::write
{

// The folder of the parts of a file that names others: of its stem, beside it. Returns an error if a file is there.
Result<std::string> folderOfParts(const std::string& path);

// The error where that folder is there and may not be.
Error folderIsThere(const std::string& folder);

// A file and others that it names, which lie in a folder of its stem beside it: out.vtm and out/0.vtp. They appear
// together or not at all: until commit() the others are written into a folder of a name no one has. Where the set takes
// the place of an older one, its files get names that the older file does not name, and the files that it names go at
// the end. So the older set is whole until the new one is. What the stem's folder holds else stays there.
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
	// The member may get another name than this one, see above.
	Member add(const std::string& name);
	// Returns the folder of the members until commit().
	std::string folder() const { return staging_->path(); }

	// text: of the file that names the others. needs_new_folder: the folder of the stem may not be there, unless an
	// older set has it.
	Status commit(const std::string& text, bool needs_new_folder = false);

private:
	FileSet() = default;
	Status moveMembers(bool needs_new_folder);
	Status flushMembers();
	void removeOlder() const;

	struct Move
	{
		std::string from; // name in the folder until commit()
		std::string to;   // name in the folder of the stem
	};

	std::string path_;
	std::string folder_; // folder of the stem
	std::optional<OwnFolder> staging_;
	std::vector<Move> members_;
	bool replaces_ = false;          // there is an older file
	std::set<std::string> older_;    // names in the stem's folder that the older file names
	std::vector<std::string> moved_; // files moved to new places; undone if the last step fails
	bool made_folder_ = false;
	bool done_ = false;
};

} // namespace vp::write
