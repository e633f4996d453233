#include "vectors/flight.h"

#include "base/parallel_for.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::vectors
{

namespace
{

constexpr std::size_t kTaken = 16; // particles by a thread at a time: enough to spread, few to wait for

int faceHere(const grid::AnyGrid& grid, int face)
{
	return std::visit(
	    [&]<class G>(const G& g)
	    {
		    if constexpr (kIsLattice<G>)
			    return faceOfSource(axesOf(g), face);
		    else
			    return face;
	    },
	    grid);
}

// Particles of a thread, from block to block.
class Pilot
{
public:
	// elsewhere: null if all blocks are here.
	Pilot(const grid::BlockSet& blocks, std::span<const Flight::BlockTimes> vectors, const Motion& motion,
	      const TimeSpan& span, const Elsewhere* elsewhere = nullptr)
	    : blocks_(blocks), vectors_(vectors), motion_(motion), span_(span), elsewhere_(elsewhere), finder_(blocks)
	{
	}

	void fly(Particle& particle)
	{
		if (particle.cell == kNoCell && !locateLaunch(particle))
			return particle.stop(TraceEnd::left_grid);
		while (!particle.end && isHere(particle.block))
		{
			if (!particle.exit && !follow(particle))
				return;
			if (!particle.exit || !isHere(particle.block))
				continue;
			const Exit exit = *std::exchange(particle.exit, std::nullopt);
			if (crossSeam(particle, exit) || findBeyond(particle, exit))
				continue;
			if (particle.asked)
				return;
			particle.stop(TraceEnd::left_grid);
		}
	}

private:
	bool isHere(std::uint32_t block) const { return !elsewhere_ || elsewhere_->isHere(block); }
	bool areOneWhole(std::uint32_t a, std::uint32_t b) const
	{
		return elsewhere_ ? elsewhere_->borders().whole[a] == elsewhere_->borders().whole[b] : a == b;
	}

	// Within the block that it is in. Returns true if it goes on from there at once.
	bool follow(Particle& particle)
	{
		const Flight::BlockTimes& vectors = vectors_[particle.block];
		if (!std::ranges::all_of(vectors, &BlockVectors::known))
		{
			particle.vector = Vec3(std::numeric_limits<double>::quiet_NaN());
			particle.stop(TraceEnd::no_vector);
			return false;
		}
		particle.exit = std::visit(
		    [&](const auto& grid)
		    {
			    const CellLoader loader(grid, TimedVectors(vectors), particle.block, elsewhere_);
			    return Follower(loader, motion_, span_, particle).follow();
		    },
		    blocks_.blocks[particle.block].grid);
		return !particle.missing && (particle.exit || particle.stand);
	}

	bool locateLaunch(Particle& particle)
	{
		const locate::Place& found = finder_.find(particle.place);
		if (found.found())
			particle.block = found.block;
		particle.cell = found.cell;
		return found.found();
	}

	// If several cells lie on the face, takes the one in which the particle lies deepest. Cells of other processes come
	// last.
	bool crossSeam(Particle& particle, const Exit& exit)
	{
		const mesh::BlockCell cell{particle.block, particle.cell};
		const int face = faceHere(blocks_.blocks[cell.block].grid, exit.face);
		if (const grid::BlockSeams* seams = blocks_.interfaces.of(cell.block))
			if (crossTo(particle, seams->of(cell.cell, static_cast<std::uint32_t>(face))))
				return true;
		if (!elsewhere_)
			return false;
		const auto others = elsewhere_->borders().acrossFace(cell, face);
		if (!others.empty())
			moveTo(particle, others.front());
		return !others.empty();
	}

	bool crossTo(Particle& particle, std::span<const grid::SeamLink> links)
	{
		double deepest = -std::numeric_limits<double>::infinity();
		for (const grid::SeamLink& link : links)
		{
			if (links.size() > 1)
				locate::weighCell(blocks_.blocks[link.block], link.other, particle.place, weights_);
			if (links.size() > 1 && !(weights_.depth > deepest))
				continue;
			deepest = weights_.depth;
			moveTo(particle, {link.block, link.other});
		}
		return !links.empty();
	}

	static void moveTo(Particle& particle, const mesh::BlockCell& cell)
	{
		particle.block = cell.block;
		particle.cell = cell.cell;
	}

	// Blocks that overlap, or abut without meeting face to face; in the same block, faces that meet others in part
	// only, and the far side of an axis that faces are collapsed to. Asks if blocks that come first are elsewhere.
	bool findBeyond(Particle& particle, const Exit& exit)
	{
		constexpr std::size_t kMaxIdle = 4;
		if (particle.idle > kMaxIdle)
			return false;
		const Vec3 velocity = particle.sense * motion_.moving(particle.vector);
		AskedPlace asked;
		asked.place = particle.place + kBeyond / exit.rate * velocity;
		asked.reach = glm::length(asked.place - particle.place);
		for (std::uint32_t b = 0; b < blocks_.blocks.size() && !asked.own; ++b)
			if (isHere(b))
				asked.own = cellBeyond(finder_, b, asked.place, asked.reach, areOneWhole(b, particle.block),
				                       b == particle.block ? particle.cell : kNoCell);
			else if (mayHold(b, asked.place))
				asked.blocks.push_back(b);
		if (!asked.blocks.empty())
			particle.asked = std::move(asked);
		else if (asked.own)
			moveTo(particle, *asked.own);
		return !particle.asked && asked.own;
	}

	bool mayHold(std::uint32_t block, const Vec3& place) const
	{
		constexpr double kRounding = 1e-9;
		const Box& box = blocks_.blocks[block].bounds;
		const Vec3 margin(kRounding * box.diagonal());
		return glm::all(glm::lessThanEqual(box.lo - margin, place)) &&
		       glm::all(glm::lessThanEqual(place, box.hi + margin));
	}

	const grid::BlockSet& blocks_;
	std::span<const Flight::BlockTimes> vectors_;
	const Motion& motion_;
	const TimeSpan& span_;
	const Elsewhere* elsewhere_;
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
	tracedFor(tbb::blocked_range<std::size_t>(0, particles_.size(), kTaken),
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

void Flight::advanceHere(std::span<const BlockTimes> vectors, const TimeSpan& span, const Elsewhere& elsewhere,
                         std::span<const std::uint32_t> numbers)
{
	tracedFor(tbb::blocked_range<std::size_t>(0, numbers.size(), kTaken),
	          [&](const tbb::blocked_range<std::size_t>& range)
	          {
		          Pilot pilot(blocks_, vectors, motion_, span, &elsewhere);
		          for (std::size_t i = range.begin(); i < range.end(); ++i)
			          pilot.fly(particles_[numbers[i]]);
	          });
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
	// Both ways of a trace have the launch, so one thread puts both.
	tracedFor(std::size_t(0), count,
	          [&](std::size_t t)
	          {
		          const std::size_t launch = traces.launches[t];
		          for (Particle& particle : std::span(particles_).subspan(t * ways_, ways_))
		          {
			          const bool back = particle.sense < 0.0;
			          for (std::size_t n = 0; n < particle.path.size(); ++n)
				          put(back ? launch - n : launch + n, particle.path[n], particle.sense);
			          particle.path = {};
		          }
	          });
	return traces;
}

std::optional<mesh::BlockCell> cellBeyond(locate::PlaceFinder& finder, std::uint32_t block, const Vec3& place,
                                          double reach, bool of_same_whole, CellId besides)
{
	const locate::Place& found =
	    of_same_whole ? finder.findAtBoundary(block, place, reach, besides) : finder.findByTree(block, place);
	if (!found.found())
		return std::nullopt;
	return mesh::BlockCell{block, found.cell};
}

} // namespace vp::vectors
