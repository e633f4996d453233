#include "session/met_parts.h"

#include "base/progress.h"
#include "base/timeline.h"
#include "parts/kept_parts.h"
#include "parts/stoppable.h"
#include "session/session.h"
#include "surface/curved.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>

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

namespace
{

// Returns true if these runs do not fit into the memory for parts beside those that were read before.
bool mustLetGo(const grid::CellRuns& runs, std::span<const std::uint32_t> met)
{
	return runs.use().kept > 0 && runs.bytesAfter(met) > parts::KeptParts::ofProcess().budget();
}

// More bytes than these take some time to read.
constexpr std::uint64_t kTold = 128 << 20;

} // namespace

Result<bool> Session::changesBlocksFor(const FrameRequest& request) const
{
	const Result<bool> lacks = needsNeighborsFor(request);
	if (!lacks || *lacks || !grid::lacksParts(blocks_))
		return lacks;
	const auto changes = [&](const grid::Block& block)
	{
		return block.runs && mustLetGo(*block.runs, block.runs->all()) &&
		       mustLetGo(*block.runs, runsMet(*block.runs, cutRequest(request).probe));
	};
	return !looksAtCutAlone(spec_) || std::ranges::any_of(blocks_.blocks, changes);
}

// Reads what the frame needs of cells that are still in their file: those that it meets, or all.
Status Session::readParts(const FrameRequest& request, const std::stop_token& stop)
{
	const Result<bool> lacks = needsNeighborsFor(request);
	if (!lacks)
		return lacks.error();
	if (*lacks || !looksAtCutAlone(spec_))
		return readAllParts(stop);
	const TimedSection section(timeline_.get(), "read");
	for (grid::Block& block : blocks_.blocks)
	{
		if (!block.runs)
			continue;
		const std::vector<std::uint32_t> met = runsMet(*block.runs, cutRequest(request).probe);
		std::optional<Progress> progress;
		if (block.runs->bytesAfter(met) > block.runs->bytesAfter({}) + kTold)
			progress.emplace("reading parts");
		if (!mustLetGo(*block.runs, met))
		{
			block.runs->startCounting();
			block.runs->fetch(met);
			continue;
		}
		grid::Block fresh = block;
		block.runs->renew(fresh);
		fresh.runs->fetch(met);
		block = std::move(fresh);
		++stamp_.cells; // an earlier frame may name cells that are not here
	}
	return Nothing{};
}

Status Session::readAllParts(const std::stop_token& stop)
try
{
	if (!grid::lacksParts(blocks_))
		return Nothing{};
	const Progress progress("reading all parts");
	const TimedSection section(timeline_.get(), "read");
	const parts::Stoppable reading(stop);
	for (grid::Block& block : blocks_.blocks)
		if (block.runs)
			block.runs->startCounting();
	grid::readAllParts(blocks_);
	return Nothing{};
}
catch (const parts::Stopped&)
{
	return Error{ErrorKind::cancelled, "reading was cancelled"};
}
catch (const parts::Unreadable& unreadable)
{
	return Error{ErrorKind::input, unreadable.what()};
}

} // namespace vp::session
