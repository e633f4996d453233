#include "ranks/particles/particle_borders.h"

#include "ranks/data/share.h"
#include "ranks/join/unmatched_faces.h"
#include "ranks/neighborhood.h"
#include "vectors/cell_across.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace vp::ranks
{

namespace
{

std::vector<int> ranksOfBlocks(Team& team, const Share& share, std::size_t blocks)
{
	MessageWriter message;
	message.put(share.first_own);
	message.put(share.end_own);
	std::vector<int> ranks(blocks, 0);
	const std::vector<Bytes> of_all = team.gatherAll(message.take());
	for (int rank = 0; rank < team.size(); ++rank)
	{
		MessageReader reader(of_all[static_cast<std::size_t>(rank)]);
		const auto first = reader.get<std::uint32_t>();
		const auto end = reader.get<std::uint32_t>();
		std::fill(ranks.begin() + first, ranks.begin() + end, rank);
	}
	return ranks;
}

bool isLattice(const grid::Block& block)
{
	return std::visit([]<class G>(const G&) { return vectors::kIsLattice<G>; }, block.grid);
}

struct BorderFace
{
	mesh::BlockCell cell;
	int face;
};

/// Faces that may lie on those of other ranks. lone: the same.
std::vector<BorderFace> borderFaces(const grid::BlockSet& blocks, const Share& share, std::span<const Box> others,
                                    std::vector<UnmatchedFace>& lone)
{
	std::vector<BorderFace> faces;
	for (std::uint32_t b = share.first_own; b < share.end_own; ++b)
		blocks.blocks[b].boundary.visitWhere([&](const Box& box) { return touchesAny(box, others); },
		                                     [&](const grid::BoundaryIndex::Face& at)
		                                     {
			                                     const auto face = static_cast<int>(at.face);
			                                     auto found = unmatchedFace(blocks, {b, at.cell}, face);
			                                     if (!found || !touchesAny(found->box(), others))
				                                     return;
			                                     found->number = static_cast<std::uint32_t>(faces.size());
			                                     lone.push_back(std::move(*found));
			                                     faces.push_back({{b, at.cell}, face});
		                                     });
	return faces;
}

/// Pieces of a lattice that are both here.
void linkOwnPieces(const grid::BlockSet& blocks, const Share& share, vectors::BlockBorders& borders)
{
	for (std::uint32_t b = share.first_own; b < share.end_own; ++b)
	{
		const grid::BlockSeams* seams = isLattice(blocks.blocks[b]) ? blocks.interfaces.of(b) : nullptr;
		if (!seams)
			continue;
		for (const grid::SeamLink& link : seams->all())
			if (link.block != b && areOneLattice(blocks, share.whole, b, link.block))
				borders.across[b][vectors::BlockBorders::faceKey(link.cell, static_cast<int>(link.face))].push_back(
				    {link.block, link.other});
	}
}

/// Tells each rank the cells that lie across its faces.
void linkOverRanks(Team& team, const std::vector<Box>& boxes, const std::vector<BorderFace>& faces,
                   const std::vector<std::vector<FaceAcross>>& across, vectors::BlockBorders& borders)
{
	Neighborhood near(team, boxes, 0.0);
	for (std::size_t f = 0; f < faces.size(); ++f)
		for (const FaceAcross& other : across[f])
		{
			near.messageFor(other.rank).put(other.number);
			near.messageFor(other.rank).put(faces[f].cell);
		}
	for (const Bytes& bytes : near.exchange())
		for (MessageReader reader(bytes); !reader.atEnd();)
		{
			const BorderFace& face = faces[reader.get<std::uint32_t>()];
			borders.across[face.cell.block][vectors::BlockBorders::faceKey(face.cell.cell, face.face)].push_back(
			    reader.get<mesh::BlockCell>());
		}
}

ParticleBorders bordersOf(Team& team, const Share& share, const grid::BlockSet& blocks)
{
	ParticleBorders borders;
	borders.boxes = boxesOf(team, blocks);
	borders.rank_of = ranksOfBlocks(team, share, blocks.blocks.size());
	borders.blocks.whole = share.whole;
	borders.blocks.across.resize(blocks.blocks.size());
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
	{
		borders.blocks.is_here.push_back(share.isOwn(b));
		borders.blocks.is_lattice.push_back(isLattice(blocks.blocks[b]));
	}
	linkOwnPieces(blocks, share, borders.blocks);
	std::vector<UnmatchedFace> lone;
	const std::vector<BorderFace> faces = borderFaces(blocks, share, boxesOfOthers(team, borders.boxes), lone);
	const MatchedFaces matched = matchFaces(team, borders.boxes, lone);
	linkOverRanks(team, borders.boxes, faces, matched.across, borders.blocks);
	borders.hang = matched.hang;
	return borders;
}

} // namespace

const ParticleBorders& particleBorders(const Ranks& ranks, const grid::BlockSet& blocks)
{
	if (!ranks.knownBorders())
		ranks.knownBorders() = std::make_shared<const ParticleBorders>(bordersOf(*ranks.team(), ranks.share(), blocks));
	return *ranks.knownBorders();
}

} // namespace vp::ranks
