#include "cut_frame.h"

namespace vp::app
{

Result<std::vector<SheetStats>> statsSince(const Session& session, const cut::Cut& slice, const CutFrame* last,
                                           bool wants_figures)
{
	std::vector<SheetStats> all;
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
	{
		if (last && s < last->sheets.size() && last->slice.sheets[s].number == slice.sheets[s].number)
		{
			all.push_back(last->sheets[s]);
			continue;
		}
		Result<SheetStats> stats = sheetMesh(session, slice, s);
		if (!stats)
			return stats.error();
		all.push_back(std::move(*stats));
		(wants_figures ? measureSheet : measureForPicture)(session, slice, s, all.back());
	}
	return all;
}

} // namespace vp::app
