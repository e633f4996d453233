#pragma once

#include "vectors/tracer.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace vp::vectors
{

// The array of each block; of no components where a block lacks it. Copies share its memory.
std::vector<grid::Field> vectorsOf(const grid::BlockSet& blocks, const grid::FieldChoice& array);

// Values of one array over grids that stay as they are, at several times.
struct StoredVectors
{
	std::vector<double> times; // ascending, no two alike; two or more
	// At times[index], per block as vectorsOf() gives them.
	std::function<Result<std::vector<grid::Field>>(std::size_t index)> load;
};

// Path lines: particles launched together at a time, in vectors that change linearly between stored times. dt is in the
// unit of the times. As trace(), but a vector may be zero for a while, and with the first or the last stored time
// traces end with TraceEnd::no_vector. Each time is loaded when the particles reach it, in either direction from the
// launch, and two are held. Usage errors as trace() has them, and a launch before the first time or after the last.
Result<Traces> tracePathLines(const grid::BlockSet& blocks, const StoredVectors& stored, double launch_time,
                              std::span<const Launch> launches, const TraceOptions& options, std::stop_token stop = {});

} // namespace vp::vectors
