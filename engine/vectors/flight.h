#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"
#include "vectors/follower.h"
#include "vectors/tracer.h"

#include <array>
#include <span>
#include <stop_token>
#include <vector>

namespace vp::vectors
{

// Particles under way, from their launch to their traces: what steady and time-dependent tracing have in common.
class Flight
{
public:
	// The launches' particles, at rest; all of them outlive the flight.
	Flight(const grid::BlockSet& blocks, std::span<const Launch> launches, const TraceOptions& options, bool steady);

	// Vectors of one block at the begin of a span and at its end; steady: one of them.
	using BlockTimes = std::vector<BlockVectors>;

	// Moves the particles of one sense until they end or the span does, on all cores.
	Status advance(std::span<const BlockTimes> vectors, double sense, const TimeSpan& span,
	               const std::stop_token& stop);
	bool anyLeft(double sense) const;     // under way
	void end(double sense, TraceEnd why); // of those that are under way

	Traces take();

private:
	const grid::BlockSet& blocks_;
	std::span<const Launch> launches_;
	Motion motion_;
	std::size_t ways_;                // particles a launch: one, or backward and forward
	std::vector<Particle> particles_; // of a launch side by side, backward first
};

} // namespace vp::vectors
