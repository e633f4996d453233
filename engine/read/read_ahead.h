#pragma once

#include "read/child.h"
#include "read/manifest.h"
#include "read/read.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::read
{

constexpr std::string_view kDemoPrefix = "demo:"; // begins inputs that no child reads

// Returns the file of an input that is read at the time of the options; an input that is no series is itself.
std::string fileOf(const std::string& input, const ReadOptions& options);

struct InputToRead
{
	std::string input; // as takeInputs() gives it
	ReadOptions options;
};

// Reads inputs one after the other. While one is waited for or built, the readers of those behind it are at work: as
// many at once as there are cores, or as the caller allows.
class ReadAhead
{
public:
	// Starts nothing yet.
	explicit ReadAhead(std::vector<InputToRead> inputs, std::size_t most_at_once = ~std::size_t(0));
	ReadAhead(const std::vector<std::string>& inputs, const ReadOptions& options);

	// Starts the readers of the first inputs.
	void start() { startSome(); }
	// The input that comes next. There is one.
	const InputToRead& next() const { return inputs_[next_]; }
	// Waits for the next input and checks what was read. Call skip() for one that no child reads.
	Result<CheckedInput> read(Timeline* timeline);
	void skip();

private:
	// A reader at work.
	struct AtWork
	{
		std::string file;
		std::string index;         // is read in place of the file; mostly empty
		std::vector<double> times; // empty unless it is a series
		ReaderAtWork reader;
	};
	static Result<AtWork> start(const InputToRead& input);
	static Result<AtWork> startWithIndex(const InputToRead& input, std::string index);
	static Result<AtWork> startByIndexIfThereIs(const InputToRead& input);
	static Result<CheckedInput> finish(AtWork& at_work, const std::string& follow);
	void startSome();

	std::vector<InputToRead> inputs_;
	std::size_t most_at_once_ = ~std::size_t(0);
	std::size_t next_ = 0;
	std::deque<std::optional<Result<AtWork>>> started_; // from the next one on; nothing for one that no child reads
};

} // namespace vp::read
