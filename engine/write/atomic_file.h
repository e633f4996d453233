#pragma once

#include "base/result.h"

#include <string>
#include <string_view>

namespace vp::write
{

/// Returns the folder of a file or, if it does not exist, the nearest folder above it that does.
std::string nearestFolder(const std::string& path);

// A file that appears whole or not at all. Bytes go to a new file beside `path`, which gets the name on commit().
// Without commit() nothing remains. commit() also makes missing folders; until then the new file is in the nearest
// folder that exists. Standard output ("-"), devices and pipes are written directly.
class AtomicFile
{
public:
	// may_be_state: it may take the place of a state that was read.
	static Result<AtomicFile> create(const std::string& path, bool may_be_state = false);
	AtomicFile(AtomicFile&& other) noexcept;
	AtomicFile& operator=(AtomicFile&&) = delete;
	~AtomicFile();

	void write(std::string_view bytes); // commit() reports a failure; later bytes are ignored
	// Ends the writing and reports failures of it, so that commit() only gives the name.
	Status close();
	// Takes a file that another program has written into a folder of ours (OwnFolder) for the contents.
	Status take(const std::string& file);
	Status commit();

	// Returns the path where the bytes go until commit(), for another program that writes them. Empty for a target that
	// is written directly.
	const std::string& beside() const { return beside_; }

private:
	AtomicFile() = default;
	void discard();

	std::string path_;   // as the user wrote it
	std::string target_; // the same with links followed
	std::string beside_; // the new file; empty for a target that is written directly
	int descriptor_ = -1;
	bool owns_descriptor_ = true;
	bool may_be_state_ = false;
	int error_ = 0; // errno of the first failure
};

// Checks that a file can be written there. Call it before long work.
Status checkWritable(const std::string& path);

// Returns an error if a file that was read is there. Cheap: call it again before a file gets its name.
Status refuseInput(const std::string& path, bool may_be_state = false);

} // namespace vp::write
