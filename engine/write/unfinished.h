#pragma once

#include <string>

namespace vp::write
{

// While one lives a signal handler waits with removing. Where one has begun to, this waits for the end.
class TouchingFiles
{
public:
	TouchingFiles();
	~TouchingFiles();
	TouchingFiles(const TouchingFiles&) = delete;
	TouchingFiles& operator=(const TouchingFiles&) = delete;
};

// Names of files, and of folders of files, that a signal handler removes until they are forgotten again.
void rememberUnfinished(const std::string& name);
void forgetUnfinished(const std::string& name);

// For a signal handler that ends the program: removes the unfinished files of all threads. After it, no thread can
// begin or finish a file. Async-signal-safe.
void removeUnfinishedFiles() noexcept;

} // namespace vp::write
