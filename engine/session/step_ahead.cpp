#include "session/step_ahead.h"

#include "read/input_limits.h"

#include <tbb/global_control.h>

#include <system_error>
#include <utility>

namespace vp::session
{

namespace
{

constexpr std::chrono::seconds kLongestAhead{60};

} // namespace

bool mayReadAhead(const grid::BlockSet& blocks)
{
	std::uint64_t bytes = 0;
	for (const grid::Block& block : blocks.blocks)
		for (const grid::Field& field : block.fields)
			bytes += field.bytes.size();
	return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1 &&
	       bytes < read::limitsWithoutFile().memory / 8;
}

std::vector<StepAhead::FileState> StepAhead::statesOf(const std::vector<std::string>& inputs,
                                                      const read::ReadOptions& options)
{
	std::vector<FileState> states;
	for (const std::string& input : inputs)
	{
		const std::filesystem::path file = read::fileOf(input, options);
		std::error_code unknown; // the reader tells what is wrong
		const auto changed = std::filesystem::last_write_time(file, unknown);
		states.emplace_back(changed, std::filesystem::file_size(file, unknown));
	}
	return states;
}

read::ReadAhead StepAhead::take(const std::vector<std::string>& inputs, const read::ReadOptions& options,
                                const std::vector<double>& times)
{
	std::optional<read::ReadAhead> ahead = std::exchange(ahead_, std::nullopt);
	if (ahead)
	{
		const read::TimeChoice& time = options.time;
		const bool is_a_step = time.kind != read::TimeChoice::Kind::index || time.index < times.size();
		read::ReadOptions of_step = options; // a time may be asked for by its number, or by a value that is near
		of_step.time = ahead->next().options.time;
		if (is_a_step && read::timeIndex(times, time) == step_ && of_step == ahead->next().options &&
		    std::chrono::steady_clock::now() - since_ < kLongestAhead && statesOf(inputs, of_step) == before_)
			return std::move(*ahead);
	}
	return read::ReadAhead(inputs, options);
}

std::optional<std::size_t> StepAhead::nextAfter(std::size_t step, std::size_t count)
{
	const std::optional<std::size_t> last = std::exchange(last_, step);
	if (last && *last + 1 == step && step + 1 < count)
		return step + 1;
	if (last && *last == step + 1 && step > 0)
		return step - 1;
	return {};
}

void StepAhead::expect(const std::vector<std::string>& inputs, const read::ReadOptions& options, std::size_t step)
{
	step_ = step;
	before_ = statesOf(inputs, options);
	ahead_.emplace(inputs, options);
	ahead_->start();
	since_ = std::chrono::steady_clock::now();
}

} // namespace vp::session
