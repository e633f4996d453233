#include "session/met_parts.h"

#include "base/progress.h"
#include "base/timeline.h"
#include "parts/kept_parts.h"
#include "session/session.h"
#include "surface/curved.h"

#include <algorithm>
#include <iterator>

namespace vp::session
{

bool looksAtCutAlone(const view::ViewSpec& spec)
{
	return meetsFewValues(spec) && !needsNeighbors(spec) && !spec.input.displace && spec.input.displace_by.empty() &&
	       !spec.input.cell_to_point && !spec.look.logarithmic && !spec.machine.visited &&
	       spec.machine.classify != view::Classify::gpu;
}

std::vector<std::uint32_t> runsMet(const grid::CellRuns& runs, const probe::Probe& probe)
{
	std::vector<std::uint32_t> met;
	for (const probe::Sheet& placed : probe::placed(probe).sheets)
	{
		const auto meeting = [&]
		{
			if (!placed.form)
				return runs.meeting(probe::content(placed).plane());
			return std::visit([&](auto&& curved) { return runs.meeting(surface::BlockSurface(curved)); },
			                  placed.form->placed(placed.axes()));
		};
		std::vector<std::uint32_t> joined;
		std::ranges::set_union(met, meeting(), std::back_inserter(joined));
		met = std::move(joined);
	}
	return met;
}

// Reads what the frame needs of cells that are still in their file: those that it meets, or all.
Status Session::readParts(const FrameRequest& request)
{
	const Result<bool> lacks = needsNeighborsFor(request);
	if (!lacks)
		return lacks.error();
	if (*lacks || !looksAtCutAlone(spec_))
		return readAllParts();
	const TimedSection section(timeline_.get(), "read");
	for (grid::Block& block : blocks_.blocks)
	{
		if (!block.runs)
			continue;
		block.runs->startCounting();
		const std::vector<std::uint32_t> met = runsMet(*block.runs, cutRequest(request).probe);
		if (block.runs->bytesAfter(met) > parts::KeptParts::ofProcess().budget())
		{
			block.runs->letGo();
			++stamp_.cells; // what earlier frames name may be gone
		}
		block.runs->fetch(met);
	}
	return Nothing{};
}

Status Session::readAllParts()
{
	const Progress progress("reading all parts");
	const TimedSection section(timeline_.get(), "read");
	for (grid::Block& block : blocks_.blocks)
		if (block.runs)
			block.runs->startCounting();
	grid::readAllParts(blocks_);
	return Nothing{};
}

} // namespace vp::session
