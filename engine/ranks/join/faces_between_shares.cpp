#include "ranks/join/faces_between_shares.h"

#include "grid/cell_runs.h"
#include "ranks/neighborhood.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace vp::ranks
{

namespace
{

// The points of a face as the pack numbers them, behind the numbers of its sheet and its block.
using FaceOfPack = std::vector<PointId>;

// Calls visit(index, key, place of a point that all ranks choose) for each of the faces of a block.
template <class Visit>
void forFacesOfPack(std::size_t sheet, std::size_t block, const grid::UnstructuredGrid& grid,
                    std::span<const grid::BoundaryIndex::Face> of_block, const Visit& visit)
{
	grid::CellFaces faces;
	for (std::size_t i = 0; i < of_block.size(); ++i)
	{
		grid.cellFaces(of_block[i].cell, faces);
		const std::span<const PointId> points = faces[static_cast<int>(of_block[i].face)];
		FaceOfPack key(points.begin(), points.end());
		std::ranges::sort(key);
		const Vec3 place = grid.point(key.front());
		key.insert(key.begin(), {static_cast<PointId>(sheet), static_cast<PointId>(block)});
		visit(i, key, place);
	}
}

} // namespace

void dropFacesBetweenShares(Team& team, const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                            cut::Cut& cut)
{
	const auto isAnywhere = [](const cut::SheetCut& sheet)
	{ return std::ranges::any_of(sheet.seeds.faces_in_plane, [](const auto& faces) { return !faces.empty(); }); };
	if (!anyOf(team, std::ranges::any_of(cut.sheets, isAnywhere)))
		return;
	struct Place
	{
		std::uint32_t sheet, block, index;
	};
	Neighborhood near(team, boxesOf(team, blocks), 0.0);
	for (std::uint32_t s = 0; s < cut.sheets.size(); ++s)
		for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		{
			const grid::Block& block = blocks.blocks[b];
			if (!block.runs || !block.runs->isShare())
				continue;
			const auto& grid = std::get<grid::UnstructuredGrid>(block.grid);
			const seed::SheetSeeds& seeds = cut.sheets[s].seeds;
			const auto send = [&](bool is_shown)
			{
				return [&, is_shown](std::size_t i, const FaceOfPack& key, const Vec3& place)
				{
					MessageWriter& message = near.messageFor(place);
					message.put(Place{s, b, static_cast<std::uint32_t>(i)});
					message.put(is_shown);
					message.putAll(key);
				};
			};
			forFacesOfPack(s, whole[b], grid, seeds.faces_in_plane[b], send(false));
			forFacesOfPack(s, whole[b], grid, seeds.faces_of_cut_cells[b], send(true));
		}
	struct Sent
	{
		int rank;
		Place place;
		bool is_shown;
	};
	std::map<FaceOfPack, std::vector<Sent>> faces;
	const std::vector<Bytes> came = near.exchange();
	for (int rank = 0; rank < static_cast<int>(came.size()); ++rank)
		for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
		{
			const auto place = reader.get<Place>();
			const bool is_shown = reader.get<bool>();
			faces[reader.getAll<PointId>()].push_back({rank, place, is_shown});
		}
	for (const auto& [key, on_each_other] : faces)
		for (const Sent& face : on_each_other)
			if (on_each_other.size() > 1 && !face.is_shown)
				near.messageFor(face.rank).put(face.place);
	std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> dropped;
	for (const Bytes& answer : near.exchange())
		for (MessageReader reader(answer); !reader.atEnd();)
		{
			const auto place = reader.get<Place>();
			dropped[{place.sheet, place.block}].push_back(place.index);
		}
	for (const auto& [at, indices] : dropped)
	{
		auto& of_block = cut.sheets[at.first].seeds.faces_in_plane[at.second];
		const std::set<std::uint32_t> out(indices.begin(), indices.end());
		std::uint32_t index = 0;
		std::erase_if(of_block, [&](const auto&) { return out.contains(index++); });
	}
}

} // namespace vp::ranks
