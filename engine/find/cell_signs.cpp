#include "find/cell_signs.h"

#include <array>
#include <vector>

namespace vp::find
{

namespace
{

std::vector<std::uint32_t> wordsOf(grid::CellShape shape)
{
	std::vector<std::uint32_t> codes;
	for (const cases::Case& entry : cases::caseTable(shape))
	{
		const auto index = static_cast<std::uint32_t>(codes.size());
		if (entry.needs_walk)
			codes.push_back(index | shared::kCodeCut | shared::kCodeWalk);
		else if (entry.edges == 0)
			codes.push_back(index);
		else
			codes.push_back(index | static_cast<std::uint32_t>(entry.faces) << shared::kCodeFacesShift |
			                shared::kCodeCut);
	}
	return codes;
}

} // namespace

const std::uint32_t* caseCodes(grid::CellShape shape)
{
	static const auto codes = []
	{
		std::array<std::vector<std::uint32_t>, grid::kTableShapes> made;
		for (int s = 0; s < grid::kTableShapes; ++s)
			made[s] = wordsOf(static_cast<grid::CellShape>(s));
		return made;
	}();
	return codes[static_cast<std::size_t>(shape)].data();
}

} // namespace vp::find
