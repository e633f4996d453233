#pragma once

#include <string>
#include <vector>

namespace vp::reader
{

// These functions know which files this process reads. The programs note each file that they open (open_watch.cpp), so
// this covers every format's library, and every file that an input names.

// From now on, tells the parent the name of each file except this one.
void tellFiles(const std::string& input);

void noteFile(const char* path);
std::vector<std::string> filesRead(); // each once

// Notes a file that could not be opened for reading. It counts if the reason is the sandbox.
void noteRefused(const char* path);
// Returns a line for the user for each of them: the file and the remedy.
std::vector<std::string> refusedFiles();

// Returns true if a name leads to a pipe, a device or a socket. Reading from one might wait for ever, or never end.
bool isNoFile(const char* path);

// Returns the file that was opened last, or an empty text if that is the input itself.
std::string pieceBeingRead();

// From now on, this file counts as the one that was opened last. An empty name means the input itself.
void blame(const std::string& piece);

// As long as an object of this class exists, files are opened only to see whether they belong to the input.
class OnlyLooking
{
public:
	OnlyLooking();
	~OnlyLooking();
	OnlyLooking(const OnlyLooking&) = delete;
	OnlyLooking& operator=(const OnlyLooking&) = delete;
};

} // namespace vp::reader
