#include "session/cut_frame.h"

namespace vp::session
{

Result<CutFrame> cutFrame(const Session& session, std::stop_token stop)
{
	CutFrame frame;
	Result<cut::Cut> slice = cut(session, nullptr, stop);
	if (!slice)
		return slice.error();
	frame.slice = std::move(*slice);
	if (Status told = reportWarnings(session, frame.slice); !told)
		return told.error();
	Result<std::vector<SheetStats>> sheets = sheetStats(session, frame.slice);
	if (!sheets)
		return sheets.error();
	frame.sheets = std::move(*sheets);
	if (stop.stop_requested())
		return Error{ErrorKind::cancelled, "cutting was cancelled"};
	Result<Contours> contours = growContours(session, frame.slice, frame.sheets, session.spec.look.contour, Tell::all);
	if (!contours)
		return contours.error();
	frame.contours = std::move(*contours);
	return frame;
}

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

} // namespace vp::session
