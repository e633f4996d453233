#pragma once

#include "grid/field.h"
#include "ranks/data/share.h"
#include "seamed_sets.h"
#include "test_grids.h"
#include "thread_team.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vp::test
{

enum class Kind
{
	lattice, // one curvilinear grid, which is parted in slabs
	cells    // hexahedra; each part has points of its own
};

// Adds a point field "hills" and a vector field "wind". Both are functions of the place.
inline grid::Block withArrays(grid::Block block)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    std::vector<double> hills(grid.pointCount());
		    std::vector<double> wind(3 * grid.pointCount());
		    for (PointId p = 0; p < grid.pointCount(); ++p)
		    {
			    const Vec3 at = grid.point(p);
			    const std::size_t source = grid.sourcePoint(p);
			    hills[source] = std::sin(3.0 * at.x) * std::cos(4.0 * at.y) + 0.6 * std::sin(5.0 * at.z);
			    const Vec3 flow{1.0 + 0.2 * at.y, 0.3 * std::sin(2.0 * at.x), 0.1 - 0.2 * at.z};
			    for (int i = 0; i < 3; ++i)
				    wind[3 * source + static_cast<std::size_t>(i)] = flow[i];
		    }
		    block.fields = {grid::makeField("hills", grid::Association::point, 1, std::move(hills)),
		                    grid::makeField("wind", grid::Association::point, 3, std::move(wind))};
	    },
	    block.grid);
	return block;
}

// The part between u = part and u = part + 1.
inline grid::Block partOf(Kind kind, Place place, int part)
{
	return withArrays(kind == Kind::lattice ? latticeBlock(place, part, false)
	                                        : hexahedraBlock(place, part, part + 1.0, true));
}

// What one process has that holds all parts. A lattice is whole then; cells meet at seams.
inline grid::BlockSet wholeOf(Kind kind, Place place, int parts)
{
	std::vector<grid::Block> blocks;
	if (kind == Kind::lattice)
	{
		constexpr double step = 1.0 / kSteps;
		const auto along = static_cast<std::uint32_t>(parts * kSteps + 1);
		blocks.push_back(
		    withArrays(curvilinearBlock("whole", {along, kSteps + 1, kSteps + 1},
		                                [&](int i, int j, int k) { return place(step * i, step * j, step * k); })));
	}
	else
		for (int part = 0; part < parts; ++part)
			blocks.push_back(partOf(kind, place, part));
	return setOfBlocks(std::move(blocks));
}

// A block that another rank holds, as ranks::readInputs() leaves it.
inline grid::Block withoutCells(const grid::Block& block)
{
	grid::Block empty;
	empty.name = block.name;
	empty.bounds = block.bounds;
	std::visit([&]<class G>(const G&) { empty.grid = G(); }, block.grid);
	for (const grid::Field& field : block.fields)
	{
		grid::Field& without_values = empty.fields.emplace_back();
		without_values.name = field.name;
		without_values.association = field.association;
		without_values.components = field.components;
		without_values.type = field.type;
	}
	empty.tree = std::make_shared<grid::LazyBlockTree>();
	empty.cell_places = std::make_shared<grid::LazyCellPlaces>();
	return empty;
}

// The blocks of a rank, which has `per_rank` of them.
inline grid::BlockSet shareOf(std::vector<grid::Block> blocks, int rank, std::size_t per_rank = 1)
{
	for (std::size_t b = 0; b < blocks.size(); ++b)
		if (b / per_rank != static_cast<std::size_t>(rank))
			blocks[b] = withoutCells(blocks[b]);
	return setOfBlocks(std::move(blocks));
}

inline ranks::Ranks ranksOf(ranks::Team& team, bool is_one_lattice, std::uint32_t per_rank = 1)
{
	auto share = std::make_shared<ranks::Share>();
	share->first_own = static_cast<std::uint32_t>(team.rank()) * per_rank;
	share->end_own = share->first_own + per_rank;
	share->own_parts = per_rank;
	for (std::uint32_t b = 0; b < static_cast<std::uint32_t>(team.size()) * per_rank; ++b)
		share->whole.push_back(is_one_lattice ? 0 : b);
	return ranks::Ranks(&team, std::move(share));
}

using WorkOfRank = std::function<void(ranks::Ranks& ranks, const grid::BlockSet& blocks)>;

// Runs `work` for each rank of a team that holds these blocks, `per_rank` at each.
inline void withMany(const std::vector<grid::Block>& blocks, bool is_one_lattice, std::uint32_t per_rank,
                     const WorkOfRank& work)
{
	ranks::withTeam(static_cast<int>(blocks.size() / per_rank),
	                [&](ranks::Team& team)
	                {
		                ranks::Ranks ranks = ranksOf(team, is_one_lattice, per_rank);
		                work(ranks, shareOf(blocks, team.rank(), per_rank));
	                });
}

// Runs `work` for one process with all blocks, and for each of as many ranks with one block each.
inline void withOneAndWithMany(const std::vector<grid::Block>& blocks, const WorkOfRank& alone,
                               const WorkOfRank& of_rank)
{
	const grid::BlockSet whole = setOfBlocks(blocks);
	ranks::Ranks one = ranks::Ranks::alone();
	alone(one, whole);
	withMany(blocks, false, 1, of_rank);
}

// A grid in parts, `per_rank` at each rank.
struct Parting
{
	Kind kind;
	Place place;
	int parts;
	std::uint32_t per_rank = 1;
};

// The same for the parts of a grid, which one process has as a whole.
inline void withOneAndWithMany(const Parting& parting, const WorkOfRank& alone, const WorkOfRank& of_rank)
{
	const grid::BlockSet whole = wholeOf(parting.kind, parting.place, parting.parts);
	ranks::Ranks one = ranks::Ranks::alone();
	alone(one, whole);
	std::vector<grid::Block> blocks;
	for (int part = 0; part < parting.parts; ++part)
		blocks.push_back(partOf(parting.kind, parting.place, part));
	withMany(blocks, parting.kind == Kind::lattice, parting.per_rank, of_rank);
}

} // namespace vp::test
