#include "session/met_parts.h"

#include "base/progress.h"
#include "base/timeline.h"
#include "find/curved_sheet.h"
#include "find/scan.h"
#include "grid/least_positive.h"
#include "parts/kept_parts.h"
#include "parts/stoppable.h"
#include "session/session.h"
#include "surface/curved.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace vp::session
{

namespace
{

// Nothing but the sheets of a probe is shown.
bool looksAtSheetsAlone(const view::ViewSpec& spec)
{
	const view::ProbeSpec& probe = spec.probe;
	return !probe.threshold && !probe.vectors.on() && !spec.look.contour.isGiven() && spec.look.context.empty() &&
	       !view::replacesSheets(probe.surface);
}

} // namespace

bool meetsFewValues(const view::ViewSpec& spec)
{
	const view::ProbeSpec& probe = spec.probe;
	const surface::ImplicitSurface* surface = view::implicitSurface(probe.surface);
	const auto asksForValues = [](const probe::Sheet& sheet) { return sheet.form && sheet.form->isoValue(); };
	return looksAtSheetsAlone(spec) && !(surface && surface->isoValue()) &&
	       !(probe.own && std::ranges::any_of(probe.own->probe.sheets, asksForValues));
}

bool looksAtCutAlone(const view::ViewSpec& spec)
{
	return looksAtSheetsAlone(spec) && !needsNeighbors(spec) && !spec.input.displace &&
	       spec.input.displace_by.empty() && !spec.input.cell_to_point && !spec.machine.visited &&
	       spec.machine.classify != view::Classify::gpu;
}

bool knowsLeastPositive(const grid::BlockSet& blocks)
{
	return std::ranges::all_of(blocks.blocks, [](const grid::Block& block)
	                           { return !block.runs || std::ranges::all_of(block.fields, grid::knowsLeastPositive); });
}

bool looksAtCutAlone(const view::ViewSpec& spec, const grid::BlockSet& blocks)
{
	return looksAtCutAlone(spec) && (!spec.look.logarithmic || knowsLeastPositive(blocks));
}

std::vector<std::vector<std::uint32_t>> runsMet(const grid::BlockSet& blocks, const cut::CutRequest& request)
{
	std::vector<std::vector<std::uint32_t>> met(blocks.blocks.size());
	const std::vector<probe::Sheet> sheets = probe::placed(request.probe).sheets;
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		std::vector<surface::BlockSurface> surfaces;
		if (sheets[s].form)
			surfaces = find::surfacesOf(blocks, sheets[s], request.fieldOf(s));
		for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		{
			if (!blocks.blocks[b].runs)
				continue;
			const std::vector<std::uint32_t> more =
			    sheets[s].form ? find::runsMet(blocks.blocks[b], surfaces[b])
			                   : find::runsMet(blocks.blocks[b], probe::content(sheets[s]).plane());
			std::vector<std::uint32_t> joined;
			std::ranges::set_union(met[b], more, std::back_inserter(joined));
			met[b] = std::move(joined);
		}
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
	if (!looksAtCutAlone(spec_, blocks_))
		return true;
	const auto fitsWhole = [](const grid::Block& block)
	{ return !block.runs || !mustLetGo(*block.runs, block.runs->all()); };
	if (std::ranges::all_of(blocks_.blocks, fitsWhole))
		return false;
	const std::vector<std::vector<std::uint32_t>> met = runsMet(blocks_, cutRequest(request));
	for (std::size_t b = 0; b < met.size(); ++b)
		if (!fitsWhole(blocks_.blocks[b]) && mustLetGo(*blocks_.blocks[b].runs, met[b]))
			return true;
	return false;
}

// Reads what the frame needs of cells that are still in their file: those that it meets, or all.
Status Session::readParts(const FrameRequest& request, const std::stop_token& stop)
{
	const Result<bool> lacks = needsNeighborsFor(request);
	if (!lacks)
		return lacks.error();
	if (*lacks || !looksAtCutAlone(spec_, blocks_))
		return readAllParts(stop);
	const TimedSection section(timeline_.get(), "read");
	const std::vector<std::vector<std::uint32_t>> met_of_blocks = runsMet(blocks_, cutRequest(request));
	for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
	{
		grid::Block& block = blocks_.blocks[b];
		const std::vector<std::uint32_t>& met = met_of_blocks[b];
		if (!block.runs)
			continue;
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
