#include "read/read_ahead.h"

#include "base/bytes_read.h"
#include "base/input_files.h"
#include "base/messages.h"
#include "base/timeline.h"
#include "read/file_index.h"
#include "read/input_limits.h"
#include "read/ready_reader.h"
#include "read/sandbox.h"
#include "read/series.h"
#include "read/source_stamp.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>

namespace vp::read
{

namespace
{

constexpr const char* kIndexFormat = "vtkhdf"; // an index is a pack

// why: it cannot be used, with its name.
void tellUnused(const Error& why, const std::string& file)
{
	warn("{}; the index is not used: run vprobe index {} again", why.message, file);
}

} // namespace

// Returns the file of an input that is read at the time of the options; an input that is no series is itself.
std::string fileOf(const std::string& input, const ReadOptions& options)
{
	const std::optional<FileSeries> series = parseSeries(input);
	const std::vector<std::string> slices = parseStack(input);
	return series ? series->files[timeIndex(series->times, options.time)] : slices.empty() ? input : slices.front();
}

ReadAhead::ReadAhead(std::vector<InputToRead> inputs, std::size_t most_at_once)
    : inputs_(std::move(inputs)), most_at_once_(most_at_once)
{
	const auto ready = std::make_shared<ReadyReaders>();
	for (InputToRead& input : inputs_)
		if (!input.options.ready)
			input.options.ready = ready;
}

ReadAhead::ReadAhead(const std::vector<std::string>& inputs, const ReadOptions& options)
    : ReadAhead(
          [&]
          {
	          std::vector<InputToRead> each;
	          for (const std::string& input : inputs)
		          each.push_back({input, options});
	          return each;
          }())
{
}

Result<ReadAhead::AtWork> ReadAhead::start(const InputToRead& given)
{
	const std::optional<FileSeries> series = parseSeries(given.input);
	const TimeChoice& time = given.options.time;
	if (series && time.kind == TimeChoice::Kind::index && time.index >= series->times.size())
		return Error{ErrorKind::input, fmt::format("`time` #{}: the series has {} times, #0 to #{}", time.index,
		                                           series->times.size(), series->times.size() - 1)};
	const std::string file = fileOf(given.input, given.options);
	ReadOptions options = given.options;
	if (series)
		options.time = {};
	options.slices = parseStack(given.input);
	Result<InputLimits> limits =
	    options.slices.empty() ? inputLimits(file, options.solution, options.format) : stackLimits(options.slices);
	if (!limits)
		return limits.error();
	Result<ReaderAtWork> reader = ReaderAtWork::start(file, options, refinedLimits(*limits, options.refine));
	if (!reader)
		return reader.error();
	return AtWork{file, {}, series ? series->times : std::vector<double>(), std::move(*reader)};
}

Result<ReadAhead::AtWork> ReadAhead::startWithIndex(const InputToRead& given, std::string index)
{
	ReadOptions options = given.options;
	options.format = kIndexFormat;
	const Result<InputLimits> limits = inputLimits(index, {}, options.format);
	if (!limits)
		return limits.error();
	noteInput(given.input);
	Result<ReaderAtWork> reader = ReaderAtWork::start(index, options, *limits);
	if (!reader)
		return reader.error();
	return AtWork{given.input, std::move(index), {}, std::move(*reader)};
}

Result<ReadAhead::AtWork> ReadAhead::startByIndexIfThereIs(const InputToRead& given)
{
	if (given.input.ends_with(kIndexEnding))
		return Error{ErrorKind::input, fmt::format("{}: the index of a file; open that file", given.input)};
	if (const std::string index = indexOf(given.input, given.options); !index.empty())
	{
		Result<AtWork> started = startWithIndex(given, index);
		if (started)
			return started;
		tellUnused(started.error(), given.input);
	}
	return start(given);
}

void ReadAhead::startSome()
{
	const std::size_t at_once =
	    std::min(most_at_once_, tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
	while (started_.size() < at_once && next_ + started_.size() < inputs_.size())
	{
		const InputToRead& input = inputs_[next_ + started_.size()];
		if (input.input.starts_with(kDemoPrefix))
			started_.emplace_back();
		else
			started_.emplace_back(startByIndexIfThereIs(input));
	}
}

void ReadAhead::skip()
{
	if (!started_.empty())
		started_.pop_front();
	++next_;
}

Result<CheckedInput> ReadAhead::finish(AtWork& at_work, const std::string& follow)
{
	const Result<HandedOver> handed = at_work.reader.finish();
	if (!handed)
		return handed.error();
	const bool is_index = !at_work.index.empty();
	const std::string& read = is_index ? at_work.index : at_work.file;
	Result<CheckedInput> checked = checkManifest(handed->manifest, handed->arrays, handed->cells, read, follow,
	                                             is_index ? at_work.file : std::string());
	if (!checked && is_index && checked.error().kind == ErrorKind::input)
		return Error{ErrorKind::input, fmt::format("{}: {}", read, checked.error().message)};
	if (!checked)
		return unusable(read, checked.error());
	return checked;
}

Result<CheckedInput> ReadAhead::read(Timeline* timeline)
{
	const TimedSection timed(timeline, "read");
	startSome();
	const std::string follow = followArgument(next().options.follow);
	const bool lists = next().options.parts.starts_with('?');
	const InputToRead given = next();
	Result<AtWork> started = std::move(*started_.front());
	skip();
	if (!started)
		return started.error();
	Result<CheckedInput> checked = finish(*started, follow);
	if (!checked && !started->index.empty() && checked.error().kind == ErrorKind::input)
	{
		tellUnused(checked.error(), started->file);
		if (started = start(given); !started)
			return started.error();
		checked = finish(*started, follow);
	}
	if (!checked)
		return checked.error();
	const bool is_list = checked->blocks.empty() && !checked->parts.empty();
	if (is_list && !lists)
		return unusable(started->file, {ErrorKind::input, "the reader answered another question"});
	noteFiles(*checked);
	bytesRead().fetch_add(checked->bytes_read, std::memory_order_relaxed);
	noteSandbox(checked->sandbox);
	if (!started->times.empty())
		checked->times = started->times;
	return checked;
}

} // namespace vp::read
