#include "cut/refined_cut.h"

#include "base/timeline.h"
#include "cut/cutter.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace vp::cut
{

namespace
{

refine::Sheets sheetsOf(const probe::Probe& probe)
{
	refine::Sheets sheets;
	for (const probe::Sheet& sheet : probe::placed(probe).sheets)
		if (sheet.form)
			sheets.others.push_back(std::visit([](auto&& placed) { return surface::BlockSurface(placed); },
			                                   sheet.form->placed(sheet.axes())));
		else
			sheets.planes.push_back(probe::content(sheet).plane());
	return sheets;
}

std::vector<grid::FieldChoice> shownFields(const CutRequest& request)
{
	std::vector<grid::FieldChoice> fields;
	for (std::size_t s = 0; s < request.probe.sheets.size(); ++s)
		if (const auto& field = request.fieldOf(s); field && std::ranges::find(fields, *field) == fields.end())
			fields.push_back(*field);
	return fields;
}

} // namespace

Result<Cut> cutRefined(refine::Refiner& refiner, const grid::BlockSet& blocks, const CutRequest& request,
                       const std::stop_token& stop)
{
	if (const Result<find::CutPlan> plan = find::planCut(request.forPlan(), blocks, nullptr); !plan)
		return plan.error();
	std::optional<TimedSection> section(std::in_place, request.timeline, "refine");
	Result<refine::Refined> refined = refiner.refine(sheetsOf(request.probe), shownFields(request), stop);
	if (!refined)
		return refined.error();
	section.reset();
	CutRequest scan = request;
	scan.seeds = {};
	scan.device_first = false;
	scan.strategy = find::Strategy::scan;
	scan.last = nullptr;
	Result<Cut> cut = Cutter(*refined->blocks).cut(scan, stop);
	if (!cut)
		return cut;
	cut->refined = std::move(refined->blocks);
	cut->refined_counts = {refined->looked_at, refined->cells, refined->parts, refined->unfinished};
	if (!refined->warning.empty())
		cut->warnings.push_back(std::move(refined->warning));
	return cut;
}

} // namespace vp::cut
