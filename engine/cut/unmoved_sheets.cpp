#include "cut/unmoved_sheets.h"

#include <atomic>
#include <utility>

namespace vp::cut
{

void numberSheets(Cut& slice)
{
	static std::atomic<std::uint64_t> last = 0;
	for (SheetCut& sheet : slice.sheets)
		sheet.number = ++last;
}

std::vector<bool> unmovedSheets(const CutRequest& request)
{
	const std::vector<SheetCut>& last = request.last->sheets;
	if (request.surface)
		return std::vector<bool>(1, last.size() == 1 && last.front().surface == request.surface);
	const std::vector<probe::Sheet> sheets = probe::placed(request.probe).sheets;
	std::vector<bool> unmoved;
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		const std::optional<grid::FieldChoice>& field =
		    request.sheet_fields.empty() ? request.field : request.sheet_fields[s];
		unmoved.push_back(s < last.size() && !last[s].surface && last[s].shown == sheets[s] &&
		                  last[s].corners == request.corners && last[s].field == field);
	}
	return unmoved;
}

std::vector<bool> sheetsWithForm(const CutRequest& request)
{
	std::vector<bool> has_form;
	for (const probe::Sheet& sheet : request.probe.sheets)
		has_form.push_back(sheet.form.has_value());
	return has_form;
}

CutRequest withoutSheets(const CutRequest& request, const std::vector<bool>& left_out)
{
	CutRequest rest = request;
	rest.last.reset();
	if (request.surface)
		return rest;
	rest.probe.sheets.clear();
	rest.sheet_fields.clear();
	for (std::size_t s = 0; s < left_out.size(); ++s)
		if (!left_out[s])
		{
			rest.probe.sheets.push_back(request.probe.sheets[s]);
			if (!request.sheet_fields.empty())
				rest.sheet_fields.push_back(request.sheet_fields[s]);
		}
	return rest;
}

Cut joinSheets(const CutRequest& request, const std::vector<bool>& unmoved, Cut moved)
{
	Cut whole;
	whole.words = request.last->words; // of the blocks, which are the same
	std::size_t next = 0;
	for (std::size_t s = 0; s < unmoved.size(); ++s)
		whole.sheets.push_back(unmoved[s] ? request.last->sheets[s] : std::move(moved.sheets[next++]));
	return whole;
}

} // namespace vp::cut
