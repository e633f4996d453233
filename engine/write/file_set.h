#pragma once

#include "base/result.h"

#include <string>
#include <vector>

namespace vp::write
{

// The folder of the parts of a file that names others: of its stem, beside it. Returns an error if a file is there.
Result<std::string> folderOfParts(const std::string& path);

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

	Status commit(const std::string& text); // of the file that names the others

private:
	FileSet() = default;
	Status moveMembers();

	std::string path_;
	std::string folder_; // of the stem
	std::string staging_;
	std::vector<std::string> members_;
	std::vector<std::string> moved_; // to where nothing was before; undone if the last step fails
	bool made_folder_ = false;
	bool done_ = false;
};

} // namespace vp::write
