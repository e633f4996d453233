#pragma once

#include "base/result.h"

#include <string>

namespace vp::write
{

// A folder of a name no one has, for files that are not finished. It goes with all that is in it when this ends, and
// when the program is interrupted. Nobody else's folder is ever removed.
class OwnFolder
{
public:
	// In the folder of a file, or in the nearest one above it that is there: so what is finished can be renamed.
	static Result<OwnFolder> besideFile(const std::string& file);
	OwnFolder(OwnFolder&& other) noexcept;
	OwnFolder& operator=(OwnFolder&&) = delete;
	~OwnFolder();

	const std::string& path() const { return path_; }

private:
	OwnFolder(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

	std::string path_;
	int descriptor_ = -1; // holds its lock
};

} // namespace vp::write
