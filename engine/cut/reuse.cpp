#include "cut/reuse.h"

#include <atomic>
#include <utility>

namespace vp::cut
{

namespace
{

std::vector<bool> restingSheets(const CutRequest& request)
{
	const std::vector<SheetCut>& last = request.last->sheets;
	if (request.surface)
		return std::vector<bool>(1, last.size() == 1 && last.front().surface == request.surface);
	const std::vector<probe::Sheet> sheets = probe::placed(request.probe).sheets;
	std::vector<bool> rests;
	for (std::size_t s = 0; s < sheets.size(); ++s)
		rests.push_back(s < last.size() && !last[s].surface && last[s].shown == sheets[s] &&
		                last[s].corners == request.corners && last[s].hanging == request.hanging &&
		                last[s].field == request.fieldOf(s));
	return rests;
}

} // namespace

Reuse reuseOf(const CutRequest& request)
{
	Reuse reuse{restingSheets(request), request, {}};
	reuse.moved.last.reset();
	reuse.moved.probe.sheets.clear();
	reuse.moved.sheet_fields.clear();
	for (std::size_t s = 0; s < reuse.rests.size(); ++s)
	{
		if (reuse.rests[s])
			continue;
		reuse.was.push_back(s < request.last->sheets.size() ? &request.last->sheets[s] : nullptr);
		if (!request.surface)
			reuse.moved.probe.sheets.push_back(request.probe.sheets[s]);
		if (!request.sheet_fields.empty())
			reuse.moved.sheet_fields.push_back(request.sheet_fields[s]);
	}
	return reuse;
}

Cut withResting(const CutRequest& request, const Reuse& reuse, Cut moved)
{
	Cut whole;
	whole.warnings = request.last->warnings; // warnings about the blocks, which are the same
	std::size_t next = 0;
	for (std::size_t s = 0; s < reuse.rests.size(); ++s)
		whole.sheets.push_back(reuse.rests[s] ? request.last->sheets[s] : std::move(moved.sheets[next++]));
	return whole;
}

void numberSheets(Cut& cut)
{
	static std::atomic<std::uint64_t> last = 0;
	for (SheetCut& sheet : cut.sheets)
		sheet.number = ++last;
}

} // namespace vp::cut
