#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"
#include "locate/place.h"
#include "vectors/elsewhere.h"
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
	// With blocks of other processes: moves particles of either sense that are in blocks which are here, as far as they
	// get: each ends, or the span does, or it is in a block that is not here, or it waits (Particle).
	void advanceHere(std::span<const BlockTimes> vectors, const TimeSpan& span, const Elsewhere& elsewhere,
	                 std::span<const std::uint32_t> numbers);
	std::vector<Particle>& particles() { return particles_; }
	std::size_t ways() const { return ways_; } // number of particles of each launch
	bool anyLeft(double sense) const;          // returns true if any particle still moves
	void end(double sense, TraceEnd why);      // ends the particles that still move

	Traces take();

private:
	const grid::BlockSet& blocks_;
	std::span<const Launch> launches_;
	Motion motion_;
	std::size_t ways_;                // particles a launch: one, or backward and forward
	std::vector<Particle> particles_; // the particles of a launch side by side, backward first
};

// Returns the cell of a block that holds a place beyond the end of a block; nothing if none does. of_same_whole: the
// block that ends there is of the same whole, and the place not farther than `reach` from its end.
std::optional<mesh::BlockCell> cellBeyond(locate::PlaceFinder& finder, std::uint32_t block, const Vec3& place,
                                          double reach, bool of_same_whole, CellId besides);

} // namespace vp::vectors
