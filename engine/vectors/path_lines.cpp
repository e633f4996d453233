#include "vectors/path_lines.h"

#include "vectors/flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace vp::vectors
{

namespace
{

// Holds the vectors of the two stored times before and after the particles. Vectors that the last pair already had are
// not loaded again.
class HeldVectors
{
public:
	explicit HeldVectors(const StoredVectors& stored) : stored_(stored) {}

	// first: what holds at the begin of the span, in the particles' sense.
	Status hold(std::size_t first, std::size_t second)
	{
		Held begin = std::move(second_);
		if (begin.index != first)
			if (Status loaded = load(first, begin); !loaded)
				return loaded;
		first_ = std::move(begin);
		return load(second, second_);
	}

	std::vector<Flight::BlockTimes> vectors() const
	{
		std::vector<Flight::BlockTimes> times;
		for (std::size_t b = 0; b < first_.fields.size(); ++b)
			times.push_back({BlockVectors(&first_.fields[b]), BlockVectors(&second_.fields[b])});
		return times;
	}

private:
	static constexpr std::size_t kNone = ~std::size_t(0);
	struct Held
	{
		std::size_t index = kNone;
		std::vector<grid::Field> fields;
	};

	Status load(std::size_t index, Held& held) const
	{
		Result<std::vector<grid::Field>> fields = stored_.load(index);
		if (!fields)
			return fields.error();
		held = {index, std::move(*fields)};
		return Nothing{};
	}

	const StoredVectors& stored_;
	Held first_;
	Held second_;
};

Status fly(Flight& flight, const StoredVectors& stored, double launch_time, double sense, const std::stop_token& stop)
{
	const std::vector<double>& times = stored.times;
	const bool ahead = sense > 0.0;
	// The pair that the launch is in, and what follows in the particles' sense: a launch at a stored time begins a
	// span.
	const auto at = ahead ? std::ranges::upper_bound(times, launch_time) : std::ranges::lower_bound(times, launch_time);
	auto second = static_cast<std::ptrdiff_t>(at - times.begin()) - (ahead ? 0 : 1);
	const auto last = static_cast<std::ptrdiff_t>(times.size()) - 1;
	second = std::clamp<std::ptrdiff_t>(second, ahead ? 1 : 0, ahead ? last : last - 1);
	HeldVectors held(stored);
	for (; second >= 0 && second <= last && flight.anyLeft(sense); second += ahead ? 1 : -1)
	{
		const std::ptrdiff_t first = second + (ahead ? -1 : 1);
		if (Status loaded = held.hold(static_cast<std::size_t>(first), static_cast<std::size_t>(second)); !loaded)
			return loaded;
		const TimeSpan span{sense * (times[first] - launch_time), sense * (times[second] - launch_time)};
		if (Status flown = flight.advance(held.vectors(), sense, span, stop); !flown)
			return flown;
	}
	flight.end(sense, TraceEnd::no_vector);
	return Nothing{};
}

} // namespace

std::vector<grid::Field> vectorsOf(const grid::BlockSet& blocks, const grid::FieldChoice& array)
{
	std::vector<grid::Field> fields;
	for (const grid::Field* field : array.inEach(blocks))
	{
		if (field)
			fields.push_back(*field);
		else
			fields.emplace_back().components = 0;
	}
	return fields;
}

Result<Traces> tracePathLines(const grid::BlockSet& blocks, const StoredVectors& stored, double launch_time,
                              std::span<const Launch> launches, const TraceOptions& options, std::stop_token stop)
{
	assert(stored.times.size() >= 2);
	if (Status sound = checkOptions(options, launches.size()); !sound)
		return sound.error();
	if (!(launch_time >= stored.times.front() && launch_time <= stored.times.back()))
		return Error{ErrorKind::usage,
		             fmt::format("`time` {}: path lines start between the stored times; give {} to {}", launch_time,
		                         stored.times.front(), stored.times.back())};
	Flight flight(blocks, launches, options, false);
	for (const double sense : {-1.0, 1.0})
		if (Status flown = fly(flight, stored, launch_time, sense, stop); !flown)
			return flown.error();
	return flight.take();
}

} // namespace vp::vectors
