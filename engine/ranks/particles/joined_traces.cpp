#include "ranks/particles/joined_traces.h"

#include "ranks/data/share.h"
#include "ranks/join/hanging_borders.h"
#include "ranks/neighborhood.h"
#include "ranks/particles/particle_borders.h"
#include "vectors/flight.h"

#include <algorithm>
#include <map>
#include <utility>

namespace vp::ranks
{

namespace
{

/// Particles that go from rank to rank, in rounds: each rank follows those in its blocks as far as it can. Then it
/// sends on those that have come to blocks of others, and asks others for cells of theirs, and for places that they may
/// hold.
class FlightOverRanks
{
public:
	FlightOverRanks(Team& team, const grid::BlockSet& blocks, const ParticleBorders& borders,
	                std::span<const vectors::Flight::BlockTimes> vectors, vectors::Flight& flight)
	    : team_(team), blocks_(blocks), borders_(borders), vectors_(vectors), flight_(flight),
	      elsewhere_(borders.blocks), messages_(borders.boxes.size()),
	      near_(Neighborhood(team_, borders.boxes, 0.0).ranks())
	{
	}

	// Until no particle is under way at any rank.
	void advance(std::span<const vectors::Launch> launches)
	{
		std::vector<std::uint32_t> own;
		for (std::size_t i = 0; i < flight_.particles().size(); ++i)
			if (borders_.blocks.is_here[launches[i / flight_.ways()].block])
				own.push_back(static_cast<std::uint32_t>(i));
		do
		{
			flight_.advanceHere(vectors_, vectors::TimeSpan(), elsewhere_, own);
			own = goOn(own);
		} while (anyOf(team_, !own.empty()));
	}

	// Gives each rank all paths, and why they end.
	void gatherPaths()
	{
		std::vector<vectors::Particle>& particles = flight_.particles();
		MessageWriter message;
		for (std::uint32_t i = 0; i < particles.size(); ++i)
			if (particles[i].end || !particles[i].path.empty())
			{
				message.put(i);
				message.put(particles[i].end);
				message.putAll(std::exchange(particles[i].path, {}));
			}
		for (const Bytes& bytes : team_.gatherAll(message.take()))
			for (MessageReader reader(bytes); !reader.atEnd();)
			{
				vectors::Particle& particle = particles[reader.get<std::uint32_t>()];
				if (const auto end = reader.get<std::optional<vectors::TraceEnd>>())
					particle.end = end;
				const auto path = reader.getAll<vectors::PathPoint>();
				particle.path.insert(particle.path.end(), path.begin(), path.end());
			}
		for (vectors::Particle& particle : particles)
			std::ranges::stable_sort(particle.path, {}, &vectors::PathPoint::time);
	}

private:
	enum class Kind : std::uint8_t
	{
		particle,
		cell, // wanted
		place // asked for
	};

	// Most messages go to ranks beside this one. A thin part between two may be stepped over.
	std::vector<Bytes> exchange()
	{
		std::vector<Bytes> to;
		bool is_far = false;
		for (int rank = 0; rank < team_.size(); ++rank)
		{
			to.push_back(messageFor(rank).take());
			messageFor(rank) = {};
			is_far = is_far || (!to.back().empty() && rank != team_.rank() && !std::ranges::binary_search(near_, rank));
		}
		return anyOf(team_, is_far) ? team_.exchange(std::move(to)) : team_.exchange(std::move(to), near_);
	}

	MessageWriter& messageFor(int rank) { return messages_[static_cast<std::size_t>(rank)]; }
	int rankOf(std::uint32_t block) const { return borders_.rank_of[block]; }
	bool isHere(std::uint32_t block) const { return borders_.blocks.is_here[block]; }

	// Returns the particles that this rank follows in the next round.
	std::vector<std::uint32_t> goOn(const std::vector<std::uint32_t>& flown)
	{
		std::vector<std::uint32_t> next;
		std::vector<std::uint32_t> asking;
		for (const std::uint32_t number : flown)
		{
			vectors::Particle& particle = flight_.particles()[number];
			if (particle.missing)
				want(*std::exchange(particle.missing, std::nullopt));
			else if (particle.asked)
				ask(number, *particle.asked);
			else if (!particle.end && !isHere(particle.block))
			{
				send(number, particle);
				continue;
			}
			if (particle.asked)
				asking.push_back(number);
			else if (!particle.end)
				next.push_back(number);
		}
		answer(exchange(), next);
		takeAnswers(exchange());
		for (const std::uint32_t number : asking)
			if (moveBeyond(number))
				next.push_back(number);
		std::ranges::sort(next);
		return next;
	}

	void send(std::uint32_t number, const vectors::Particle& particle)
	{
		MessageWriter& message = messageFor(rankOf(particle.block));
		message.put(Kind::particle);
		message.put(number);
		message.put(static_cast<const vectors::ParticleState&>(particle));
	}
	void want(const mesh::BlockCell& cell)
	{
		MessageWriter& message = messageFor(rankOf(cell.block));
		message.put(Kind::cell);
		message.put(cell);
	}
	void ask(std::uint32_t number, const vectors::AskedPlace& asked)
	{
		const std::uint32_t whole = borders_.blocks.whole[flight_.particles()[number].block];
		for (const std::uint32_t block : asked.blocks)
		{
			MessageWriter& message = messageFor(rankOf(block));
			message.put(Kind::place);
			message.put(number);
			message.put(asked.place);
			message.put(asked.reach);
			message.put(whole);
			message.put(block);
		}
	}

	void answer(const std::vector<Bytes>& came, std::vector<std::uint32_t>& next)
	{
		locate::PlaceFinder finder(blocks_);
		for (int rank = 0; rank < static_cast<int>(came.size()); ++rank)
			for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
				switch (reader.get<Kind>())
				{
				case Kind::particle:
				{
					const auto number = reader.get<std::uint32_t>();
					static_cast<vectors::ParticleState&>(flight_.particles()[number]) =
					    reader.get<vectors::ParticleState>();
					next.push_back(number);
					break;
				}
				case Kind::cell:
				{
					const auto cell = reader.get<mesh::BlockCell>();
					for (const vectors::FarCell& far :
					     vectors::cellsAround(blocks_, vectors_[cell.block], borders_.blocks, cell))
					{
						messageFor(rank).put(Kind::cell);
						messageFor(rank).put(far);
					}
					break;
				}
				case Kind::place:
				{
					const auto number = reader.get<std::uint32_t>();
					const auto place = reader.get<Vec3>();
					const auto reach = reader.get<double>();
					const auto whole = reader.get<std::uint32_t>();
					const auto block = reader.get<std::uint32_t>();
					const auto found = vectors::cellBeyond(finder, block, place, reach,
					                                       borders_.blocks.whole[block] == whole, kNoCell);
					if (!found)
						break;
					messageFor(rank).put(Kind::place);
					messageFor(rank).put(number);
					messageFor(rank).put(*found);
				}
				}
	}

	void takeAnswers(const std::vector<Bytes>& came)
	{
		for (const Bytes& bytes : came)
			for (MessageReader reader(bytes); !reader.atEnd();)
				if (reader.get<Kind>() == Kind::cell)
					elsewhere_.add(reader.get<vectors::FarCell>());
				else
				{
					// Blocks are asked in their order, by one process as well.
					std::optional<mesh::BlockCell>& own = flight_.particles()[reader.get<std::uint32_t>()].asked->own;
					const auto found = reader.get<mesh::BlockCell>();
					if (!own || found.block < own->block)
						own = found;
				}
	}

	// Returns false if nobody holds the place, so that the particle has left the grid.
	bool moveBeyond(std::uint32_t number)
	{
		vectors::Particle& particle = flight_.particles()[number];
		const std::optional<mesh::BlockCell> found = std::exchange(particle.asked, std::nullopt)->own;
		if (!found)
			particle.stop(vectors::TraceEnd::left_grid);
		else
		{
			particle.block = found->block;
			particle.cell = found->cell;
		}
		return found.has_value();
	}

	Team& team_;
	const grid::BlockSet& blocks_;
	const ParticleBorders& borders_;
	std::span<const vectors::Flight::BlockTimes> vectors_;
	vectors::Flight& flight_;
	vectors::Elsewhere elsewhere_;
	std::vector<MessageWriter> messages_; // per rank
	std::vector<int> near_;
};

std::optional<probe::Window> areaOf(Team& team, const mesh::SheetMesh& mesh, const probe::Sheet& content)
{
	if (content.window)
		return content.window;
	Box area; // two of its axes
	if (mesh.polygons() > 0)
	{
		const probe::Window own = vectors::boundsInPlane(mesh, content);
		area.include(Vec3(own.x0, own.y0, 0.0));
		area.include(Vec3(own.x1, own.y1, 0.0));
	}
	sumOverAll(team, area, [](Box& all, const Box& other) { all.include(other); });
	if (area.empty())
		return std::nullopt;
	return probe::Window{area.lo.x, area.hi.x, area.lo.y, area.hi.y};
}

} // namespace

std::vector<vectors::Launch> launchLattice(const Ranks& ranks, const mesh::SheetMesh& mesh, const probe::Sheet& content,
                                           const vectors::LatticeChoice& choice)
{
	if (!ranks.team())
		return vectors::launchLattice(mesh, content, choice).launches;
	Team& team = *ranks.team();
	const std::optional<probe::Window> area = areaOf(team, mesh, content);
	if (!area)
		return {};
	MessageWriter message;
	message.putAll(vectors::launchLattice(mesh, content, choice, *area).launches);
	std::map<std::uint32_t, vectors::Launch> by_seed;
	for (const Bytes& bytes : team.gatherAll(message.take()))
		for (const vectors::Launch& launch : MessageReader(bytes).getAll<vectors::Launch>())
		{
			// If polygons overlap, the last one counts, as in one process.
			const auto [at, is_new] = by_seed.try_emplace(launch.seed, launch);
			if (!is_new && (launch.inside || !at->second.inside))
				at->second = launch;
		}
	std::vector<vectors::Launch> launches;
	for (const auto& [seed, launch] : by_seed)
		launches.push_back(launch);
	return launches;
}

Result<vectors::Traces> trace(const Ranks& ranks, const grid::BlockSet& blocks, const grid::FieldChoice& array,
                              std::span<const vectors::Launch> launches, const vectors::TraceOptions& options)
{
	if (!ranks.team())
		return vectors::trace(blocks, array, launches, options);
	if (Status sound = vectors::checkOptions(options, launches.size()); !sound)
		return sound.error();
	const ParticleBorders& borders = particleBorders(ranks, blocks);
	if (borders.hang)
		return sizesDiffer("vectors");
	std::vector<vectors::Flight::BlockTimes> of_blocks;
	for (const grid::Field* field : array.inEach(blocks))
		of_blocks.push_back({vectors::BlockVectors(field)});
	vectors::Flight flight(blocks, launches, options, true);
	FlightOverRanks over_ranks(*ranks.team(), blocks, borders, of_blocks, flight);
	over_ranks.advance(launches);
	over_ranks.gatherPaths();
	return flight.take();
}

void takeFromOwners(const Ranks& ranks, const grid::BlockSet& blocks, const vectors::Traces& traces,
                    std::span<std::byte> values, std::size_t bytes)
{
	if (!ranks.team())
		return;
	const ParticleBorders& borders = particleBorders(ranks, blocks);
	Bytes own;
	for (std::size_t i = 0; i < traces.points.size(); ++i)
		if (borders.blocks.is_here[traces.blocks[i]])
		{
			const auto value = values.subspan(i * bytes, bytes);
			own.insert(own.end(), value.begin(), value.end());
		}
	const std::vector<Bytes> of_all = ranks.team()->gatherAll(own);
	std::vector<std::size_t> taken(of_all.size(), 0);
	for (std::size_t i = 0; i < traces.points.size(); ++i)
	{
		const auto rank = static_cast<std::size_t>(borders.rank_of[traces.blocks[i]]);
		const auto value = std::span(of_all[rank]).subspan(taken[rank], bytes);
		std::ranges::copy(value, values.begin() + static_cast<std::ptrdiff_t>(i * bytes));
		taken[rank] += bytes;
	}
}

} // namespace vp::ranks
