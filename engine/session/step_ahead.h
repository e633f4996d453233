#pragma once

#include "read/read.h"
#include "read/read_ahead.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::session
{

/// Whether another time may be read while this one is looked at: there are several threads, and its arrays take less
/// than an eighth of the machine's memory.
bool mayReadAhead(const grid::BlockSet& blocks);

/// Where times are taken one after the other, the next one is read while this one is looked at.
class StepAhead
{
public:
	/// Returns the readers of the inputs with these options: those that are at work if they were expected, less than a
	/// minute ago, and no input has changed since. Else new ones, which have not started. times: of the inputs.
	read::ReadAhead take(const std::vector<std::string>& inputs, const read::ReadOptions& options,
	                     const std::vector<double>& times);
	/// Call it after a step of so many was read. Returns the one that comes next, if this one follows the one before,
	/// or goes before it.
	std::optional<std::size_t> nextAfter(std::size_t step, std::size_t count);
	/// Starts readers of a step with these options.
	void expect(const std::vector<std::string>& inputs, const read::ReadOptions& options, std::size_t step);

private:
	// When a file was changed, and its size.
	using FileState = std::pair<std::filesystem::file_time_type, std::uintmax_t>;
	static std::vector<FileState> statesOf(const std::vector<std::string>& inputs, const read::ReadOptions& options);

	std::optional<std::size_t> last_;
	std::optional<read::ReadAhead> ahead_;
	std::size_t step_ = 0; // which they read
	std::chrono::steady_clock::time_point since_{};
	std::vector<FileState> before_; // the files, when their readers were started
};

} // namespace vp::session
