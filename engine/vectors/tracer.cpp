#include "vectors/tracer.h"

#include "vectors/flight.h"

#include <fmt/format.h>

#include <cmath>

namespace vp::vectors
{

Status checkOptions(const TraceOptions& options, std::size_t launches)
{
	if (!(options.dt > 0.0) || !std::isfinite(options.dt))
		return Error{ErrorKind::usage, fmt::format("`vector_dt` {}: not a step; give a number above 0", options.dt)};
	if (!(options.steps >= 0.0) || !std::isfinite(options.steps * options.dt))
		return Error{ErrorKind::usage,
		             fmt::format("`vector_steps` {}: not a number of steps; give 0 or more", options.steps)};
	const double ways = options.direction == Direction::both ? 2.0 : 1.0;
	const double points = static_cast<double>(launches) * (ways * (std::ceil(options.steps) + 1.0));
	if (points > kMaxTracePoints)
		return Error{ErrorKind::usage, fmt::format("`vector_steps` {}: of {} traces there would be {:.3g} points; "
		                                           "take fewer steps, or fewer points in the lattice",
		                                           options.steps, launches, points)};
	return Nothing{};
}

Result<Traces> trace(const grid::BlockSet& blocks, const grid::FieldChoice& array, std::span<const Launch> launches,
                     const TraceOptions& options, std::stop_token stop)
{
	if (Status sound = checkOptions(options, launches.size()); !sound)
		return sound.error();
	std::vector<Flight::BlockTimes> vectors;
	for (const grid::Field* field : array.inEach(blocks))
		vectors.push_back({BlockVectors(field)});
	Flight flight(blocks, launches, options, true);
	for (const double sense : {-1.0, 1.0})
		if (flight.anyLeft(sense))
			if (Status done = flight.advance(vectors, sense, TimeSpan(), stop); !done)
				return done.error();
	return flight.take();
}

} // namespace vp::vectors
