#include "ranks/search/contour_faces.h"

#include "ranks/join/unmatched_faces.h"
#include "ranks/joined_across.h"

#include <optional>
#include <utility>

namespace vp::ranks
{

ReachedGroups reachedGroups(Team& team, const std::vector<Box>& boxes, const grid::BlockSet& blocks,
                            const contour::ContourParts& parts)
{
	std::vector<UnmatchedFace> faces;
	for (const contour::WayOut& way : parts.ways_out)
		if (std::optional<UnmatchedFace> face =
		        unmatchedFace(blocks, {way.block, way.face.cell}, static_cast<int>(way.face.face)))
		{
			face->number = way.group;
			faces.push_back(std::move(*face));
		}
	const MatchedFaces matched = matchFaces(team, boxes, faces);
	std::vector<Link> links;
	for (std::size_t f = 0; f < faces.size(); ++f)
		for (const FaceAcross& across : matched.across[f])
			links.push_back({team.rank(), faces[f].number, across.rank, across.number});
	std::vector<std::uint8_t> from_sheet(parts.group_count, 0);
	from_sheet[0] = 1;
	return {joinOverRanks(team, from_sheet, std::move(links)).marks, matched.hang};
}

} // namespace vp::ranks
