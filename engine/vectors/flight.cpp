#include "vectors/flight.h"

#include "locate/place.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::vectors
{

namespace
{

constexpr std::size_t kTaken = 16; // particles by a thread at a time: enough to spread, few to wait for

// Particles of a thread, from block to block.
class Pilot
{
public:
	Pilot(const grid::BlockSet& blocks, std::span<const Flight::BlockTimes> vectors, const Motion& motion,
	      const TimeSpan& span)
	    : blocks_(blocks), vectors_(vectors), motion_(motion), span_(span), finder_(blocks)
	{
	}

	void fly(Particle& particle)
	{
		if (particle.cell == kNoCell && !locateLaunch(particle))
			return particle.stop(TraceEnd::left_grid);
		while (!particle.end)
		{
			const Flight::BlockTimes& vectors = vectors_[particle.block];
			if (!std::ranges::all_of(vectors, &BlockVectors::known))
			{
				particle.vector = Vec3(std::numeric_limits<double>::quiet_NaN());
				return particle.stop(TraceEnd::no_vector);
			}
			const std::optional<Exit> exit = std::visit(
			    [&](const auto& grid)
			    { return Follower(CellLoader(grid, TimedVectors(vectors)), motion_, span_, particle).follow(); },
			    blocks_.blocks[particle.block].grid);
			if (!exit)
				return;
			if (!crossSeam(particle, *exit) && !findBeyond(particle, *exit))
				particle.stop(TraceEnd::left_grid);
		}
	}

private:
	bool locateLaunch(Particle& particle)
	{
		const locate::Place& found = finder_.find(particle.place);
		if (found.found())
			particle.block = found.block;
		particle.cell = found.cell;
		return found.found();
	}

	// Of several cells on the face the one in which the particle lies deepest.
	bool crossSeam(Particle& particle, const Exit& exit)
	{
		const grid::BlockSeams* seams = blocks_.interfaces.of(particle.block);
		if (!seams)
			return false;
		const auto links = seams->of(particle.cell, static_cast<std::uint32_t>(exit.face));
		double deepest = -std::numeric_limits<double>::infinity();
		for (const grid::SeamLink& link : links)
		{
			if (links.size() > 1)
				locate::weighCell(blocks_.blocks[link.block], link.other, particle.place, weights_);
			if (links.size() > 1 && !(weights_.depth > deepest))
				continue;
			deepest = weights_.depth;
			particle.block = link.block;
			particle.cell = link.other;
		}
		return !links.empty();
	}

	// Blocks that overlap, or abut without meeting face to face; in the same block, faces that meet others in part
	// only, and the far side of an axis that faces are collapsed to.
	bool findBeyond(Particle& particle, const Exit& exit)
	{
		constexpr std::size_t kMaxIdle = 4;
		if (particle.idle > kMaxIdle)
			return false;
		const Vec3 velocity = particle.sense * motion_.moving(particle.vector);
		const Vec3 beyond = particle.place + kBeyond / exit.rate * velocity;
		for (std::uint32_t b = 0; b < blocks_.blocks.size(); ++b)
		{
			const bool own = b == particle.block;
			const locate::Place& found =
			    own ? finder_.findAtBoundary(b, beyond, glm::length(beyond - particle.place), particle.cell)
			        : finder_.findByTree(b, beyond);
			if (!found.found())
				continue;
			particle.block = b;
			particle.cell = found.cell;
			return true;
		}
		return false;
	}

	const grid::BlockSet& blocks_;
	std::span<const Flight::BlockTimes> vectors_;
	const Motion& motion_;
	const TimeSpan& span_;
	locate::PlaceFinder finder_;
	locate::CellWeights weights_{};
};

Motion motionOf(const TraceOptions& options, bool steady)
{
	// Sums of fractions on the way to a whole number end beside it by rounding.
	constexpr double kRounding = 1e-9;
	const double whole = std::round(options.steps);
	return {std::abs(options.steps - whole) <= kRounding ? whole : options.steps,
	        options.dt,
	        options.tolerance,
	        options.part,
	        options.normal,
	        steady};
}

} // namespace

Flight::Flight(const grid::BlockSet& blocks, std::span<const Launch> launches, const TraceOptions& options, bool steady)
    : blocks_(blocks), launches_(launches), motion_(motionOf(options, steady)),
      ways_(options.direction == Direction::both ? 2 : 1)
{
	particles_.resize(ways_ * launches.size());
	for (std::size_t i = 0; i < particles_.size(); ++i)
	{
		Particle& particle = particles_[i];
		const Launch& launch = launches[i / ways_];
		particle.place = launch.position;
		particle.block = launch.block;
		particle.cell = launch.cell;
		const bool back = options.direction == Direction::backward || (ways_ == 2 && i % 2 == 0);
		particle.sense = back ? -1.0 : 1.0;
	}
}

Status Flight::advance(std::span<const BlockTimes> vectors, double sense, const TimeSpan& span,
                       const std::stop_token& stop)
{
	tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles_.size(), kTaken),
	                  [&](const tbb::blocked_range<std::size_t>& range)
	                  {
		                  Pilot pilot(blocks_, vectors, motion_, span);
		                  for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i)
			                  if (particles_[i].sense == sense)
				                  pilot.fly(particles_[i]);
	                  });
	if (stop.stop_requested())
		return Error{ErrorKind::cancelled, "tracing was cancelled"};
	return Nothing{};
}

bool Flight::anyLeft(double sense) const
{
	return std::ranges::any_of(particles_, [&](const Particle& p) { return p.sense == sense && !p.end; });
}

void Flight::end(double sense, TraceEnd why)
{
	for (Particle& particle : particles_)
		if (particle.sense == sense && !particle.end)
			particle.stop(why);
}

Traces Flight::take()
{
	Traces traces;
	const std::size_t count = launches_.size();
	for (std::size_t t = 0; t < count; ++t)
	{
		const std::span<const Particle> ways = std::span(particles_).subspan(t * ways_, ways_);
		const bool both = ways.size() == 2; // the launch is in both
		std::size_t points = both ? ways[0].path.size() - 1 : 0;
		const bool back = ways[0].sense < 0.0;
		points += ways.back().path.size();
		traces.launches.push_back(traces.starts.back() +
		                          (back ? static_cast<std::uint32_t>(ways[0].path.size()) - 1 : 0));
		traces.starts.push_back(traces.starts.back() + static_cast<std::uint32_t>(points));
		traces.seeds.push_back(launches_[t].seed);
		traces.begins.push_back(back ? *ways[0].end : TraceEnd::steps);
		traces.ends.push_back(back && !both ? TraceEnd::steps : *ways.back().end);
	}
	const std::size_t points = traces.starts.back();
	traces.points.resize(points);
	traces.times.resize(points);
	traces.vectors.resize(points);
	traces.blocks.resize(points);
	traces.cells.resize(points);
	const auto put = [&](std::size_t at, const PathPoint& point, double sense)
	{
		traces.points[at] = point.place;
		traces.times[at] = point.time == 0.0 ? 0.0 : sense * point.time;
		traces.vectors[at] = point.vector;
		traces.blocks[at] = point.block;
		traces.cells[at] = point.cell;
	};
	tbb::parallel_for(std::size_t(0), particles_.size(),
	                  [&](std::size_t i)
	                  {
		                  Particle& particle = particles_[i];
		                  const std::size_t launch = traces.launches[i / ways_];
		                  const bool back = particle.sense < 0.0;
		                  for (std::size_t n = 0; n < particle.path.size(); ++n)
			                  put(back ? launch - n : launch + n, particle.path[n], particle.sense);
		                  particle.path = {};
	                  });
	return traces;
}

} // namespace vp::vectors
