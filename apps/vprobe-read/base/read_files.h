#pragma once

#include <string>
#include <vector>

// Which files this process reads. The programs note each one that they open (open_watch.cpp), so every format's library
// is covered, and every file that an input names.

// Tells the parent the name of each file from now on, unless it is this one.
void tellFiles(const std::string& input);

void noteFile(const char* path);
std::vector<std::string> filesRead(); // each once

// Returns the file that was opened last, or an empty text if that is the input itself.
std::string pieceBeingRead();

// From now on that file counts as the one that was opened last; empty: the input itself.
void blame(const std::string& piece);

// While one lives, files are opened only to see whether they belong to the input.
class OnlyLooking
{
public:
	OnlyLooking();
	~OnlyLooking();
	OnlyLooking(const OnlyLooking&) = delete;
	OnlyLooking& operator=(const OnlyLooking&) = delete;
};
