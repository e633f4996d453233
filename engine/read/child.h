#pragma once

#include "base/result.h"
#include "read/input_limits.h"
#include "read/mapping.h"
#include "read/read.h"
#include "read/reader_process.h"

#include <memory>
#include <span>
#include <string>

namespace vp::read
{

// The data from the child. Nothing is checked yet.
struct HandedOver
{
	std::string manifest;
	SharedBytes arrays;
	SharedBytes cells;
};

// vprobe-read at work on one file, within its limits. Every failure of it is an error that names the file.
class ReaderAtWork
{
public:
	// requests: what the child has as standard input, if it is to have one.
	static Result<ReaderAtWork> start(const std::string& file, const ReadOptions& options, const InputLimits& limits,
	                                  const Descriptor& requests = {});

	// Waits until it has ended.
	Result<HandedOver> finish();
	// Waits for so many bytes from a child that stays. It has ended if there is an error.
	Status answer(std::span<std::byte> to);

	const Descriptor& arrays() const { return arrays_; }
	const Descriptor& cells() const { return cells_; }

private:
	ReaderAtWork(const std::string& file, const ReadOptions& options, const InputLimits& limits);
	Status started(const Descriptor& requests);
	Error notInTime() const;

	std::string file_;
	ReadOptions options_;
	InputLimits limits_;
	rlim_t memory_ = 0; // what the child was given in the end
	rlim_t file_size_ = 0;
	Descriptor arrays_;
	Descriptor cells_;
	Descriptor life_; // the child is killed when it closes
	std::unique_ptr<Reader> reader_;
};

// Runs vprobe-read from its start to its end.
Result<HandedOver> runReader(const std::string& file, const ReadOptions& options, const InputLimits& limits);

// Returns the error of a reading that was asked to stop.
Error stopped(const std::string& input);

// Returns the path of the program to run: beside this one, or in ../libexec/vprobe/ from there.
Result<std::string> readerProgram();

// For tests: sets the program to run instead. An empty path restores the search.
void setReaderProgram(std::string path);

} // namespace vp::read
