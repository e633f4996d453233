#include "ranks/join/boundary_edges.h"

#include "ranks/data/share.h"
#include "ranks/join/hanging_borders.h"
#include "ranks/join/unmatched_faces.h"
#include "render/scene/feature_edges.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace vp::ranks
{

namespace
{

using InsideFaces = std::vector<std::vector<bool>>; // per block, of each face of its boundary

/// Whether other pieces of its lattice lie on each face, in this rank or another one.
Result<InsideFaces> insideFaces(Team& team, const Share& share, const grid::BlockSet& blocks,
                                const std::vector<Box>& boxes)
{
	const std::vector<std::uint32_t>& whole = share.whole;
	const std::vector<Box> others = boxesOfOthers(team, boxes);
	InsideFaces inside(blocks.blocks.size());
	std::vector<UnmatchedFace> lone;
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
	{
		const auto& faces = blocks.blocks[b].boundary.faces;
		const grid::BlockSeams* seams = blocks.interfaces.of(b);
		inside[b].resize(faces.size());
		for (std::uint32_t f = 0; f < faces.size(); ++f)
		{
			if (seams)
				inside[b][f] =
				    std::ranges::any_of(seams->of(faces[f].cell, faces[f].face), [&](const grid::SeamLink& link)
				                        { return areOneLattice(blocks, whole, b, link.block); });
			std::optional<UnmatchedFace> face =
			    unmatchedFace(blocks, {b, faces[f].cell}, static_cast<int>(faces[f].face));
			if (!face || !touchesAny(face->box(), others))
				continue;
			face->number = f;
			lone.push_back(std::move(*face));
		}
	}
	const MatchedFaces matched = matchFaces(team, boxes, lone);
	if (matched.hang)
		return sizesDiffer("outline");
	for (std::size_t i = 0; i < lone.size(); ++i)
	{
		const std::uint32_t block = lone[i].cell.block;
		if (std::ranges::any_of(matched.across[i], [&](const FaceAcross& across)
		                        { return areOneLattice(blocks, whole, block, across.block); }))
			inside[block][lone[i].number] = true;
	}
	return inside;
}

/// An edge of a block, by its places.
struct EdgeKey
{
	std::uint32_t whole;
	std::array<double, 6> places; // places of its ends, in order

	auto operator<=>(const EdgeKey&) const = default;
};

EdgeKey keyOf(const render::Segment& edge, std::uint32_t whole)
{
	std::array<double, 3> a{edge.a.x, edge.a.y, edge.a.z};
	std::array<double, 3> b{edge.b.x, edge.b.y, edge.b.z};
	if (b < a)
		std::swap(a, b);
	return {whole, {a[0], a[1], a[2], b[0], b[1], b[2]}};
}

} // namespace

Result<std::vector<render::Segment>> boundaryEdgesOfAll(Team& team, const Share& share, const grid::BlockSet& blocks)
{
	const std::vector<Box> boxes = boxesOf(team, blocks);
	const Result<InsideFaces> inside = insideFaces(team, share, blocks, boxes);
	if (!inside)
		return inside.error();
	std::vector<render::Segment> own;
	Neighborhood near(team, boxes, 0.0);
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
	{
		std::vector<render::OpenEdge> open;
		render::addFeatureEdges(blocks.blocks[b], (*inside)[b], own, open);
		for (const render::OpenEdge& edge : open)
		{
			MessageWriter& message = near.messageFor(0.5 * (edge.segment.a + edge.segment.b));
			message.put(share.whole[b]);
			message.put(edge.segment);
			message.putAll(edge.normals);
		}
	}
	// An edge that one rank has, others may have too: its owner knows the faces around it.
	std::map<EdgeKey, std::vector<Vec3f>> normals;
	for (const Bytes& bytes : near.exchange())
		for (MessageReader reader(bytes); !reader.atEnd();)
		{
			const auto whole = reader.get<std::uint32_t>();
			const auto edge = reader.get<render::Segment>();
			std::vector<Vec3f>& of_edge = normals[keyOf(edge, whole)];
			const auto some = reader.getAll<Vec3f>();
			of_edge.insert(of_edge.end(), some.begin(), some.end());
		}
	for (const auto& [key, of_edge] : normals)
		if (const auto& [ax, ay, az, bx, by, bz] = key.places; render::isFeature(of_edge))
			own.push_back({{ax, ay, az}, {bx, by, bz}});
	MessageWriter message;
	message.putAll(own);
	std::vector<render::Segment> all;
	for (const Bytes& bytes : team.gatherAll(message.take()))
	{
		const auto some = MessageReader(bytes).getAll<render::Segment>();
		all.insert(all.end(), some.begin(), some.end());
	}
	render::putInOrder(all);
	return all;
}

} // namespace vp::ranks
