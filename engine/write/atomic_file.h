#pragma once

#include "base/result.h"

#include <string>
#include <string_view>

namespace vp::write
{

/// The folder of a file, or, where that is not there, the nearest one above it that is.
std::string nearestFolder(const std::string& path);

// A file that appears whole or not at all: bytes go to a new file beside `path`, which takes the name on commit();
// without commit() nothing is left of it. Folders that are not there are made on commit() too: until then the new file
// is in the nearest one that is. Standard output ("-"), devices and pipes are written to directly.
class AtomicFile
{
public:
	static Result<AtomicFile> create(const std::string& path);
	AtomicFile(AtomicFile&& other) noexcept;
	AtomicFile& operator=(AtomicFile&&) = delete;
	~AtomicFile();

	void write(std::string_view bytes); // a failure is kept for commit(); what follows it is ignored
	Status commit();

	// Where the bytes go until then, for a program that writes them in our place; empty for a target written to
	// directly.
	const std::string& beside() const { return beside_; }

private:
	AtomicFile() = default;
	void discard();

	std::string path_;   // as the user named it
	std::string target_; // what takes its place: links followed
	std::string beside_; // being written; empty for a target written to directly
	int descriptor_ = -1;
	bool owns_descriptor_ = true;
	int error_ = 0; // errno of the first failure
};

// Whether a file can be written there, which is told before long work.
Status checkWritable(const std::string& path);

// For a signal handler that ends the program: removes what is being written beside its place, by whatever thread; no
// thread begins or finishes a file after it. Async-signal-safe.
void removeUnfinishedFiles() noexcept;

} // namespace vp::write
