#include "find/cell_signs.h"

#include <array>
#include <vector>

namespace vp::find
{

namespace
{

std::vector<std::uint32_t> wordsOf(grid::CellShape shape)
{
	std::vector<std::uint32_t> words;
	for (const cases::Case& entry : cases::caseTable(shape))
	{
		const auto index = static_cast<std::uint32_t>(words.size());
		if (entry.needs_walk)
			words.push_back(index | shared::kCodeCut | shared::kCodeWalk);
		else if (entry.edges == 0)
			words.push_back(index);
		else
			words.push_back(index | static_cast<std::uint32_t>(entry.faces) << shared::kCodeFacesShift |
			                shared::kCodeCut);
	}
	return words;
}

} // namespace

const std::uint32_t* caseWords(grid::CellShape shape)
{
	static const auto words = []
	{
		std::array<std::vector<std::uint32_t>, grid::kTableShapes> made;
		for (int s = 0; s < grid::kTableShapes; ++s)
			made[s] = wordsOf(static_cast<grid::CellShape>(s));
		return made;
	}();
	return words[static_cast<std::size_t>(shape)].data();
}

} // namespace vp::find
