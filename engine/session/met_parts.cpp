#include "session/met_parts.h"

#include "base/progress.h"
#include "base/timeline.h"
#include "contour/box_contour.h"
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

// Nothing but the sheets of a probe is shown, and what grows from them.
bool showsSheetsAlone(const view::ViewSpec& spec)
{
	return !spec.probe.vectors.on() && spec.look.context.empty() && !view::replacesSheets(spec.probe.surface);
}

bool looksAtSheetsAlone(const view::ViewSpec& spec)
{
	return showsSheetsAlone(spec) && !spec.probe.threshold && !spec.look.contour.isGiven();
}

// Points are where the file has them, values as it has them, and the CPU cuts.
bool takesFileAsItIs(const view::ViewSpec& spec)
{
	return !spec.input.displace && spec.input.displace_by.empty() && !spec.input.cell_to_point &&
	       !spec.machine.visited && spec.machine.classify != view::Classify::gpu;
}

bool hasForm(const probe::Sheet& sheet)
{
	return sheet.form.has_value();
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
	return looksAtSheetsAlone(spec) && !needsNeighbors(spec) && takesFileAsItIs(spec);
}

bool looksNearPlanes(const view::ViewSpec& spec)
{
	const view::ProbeSpec& probe = spec.probe;
	return showsSheetsAlone(spec) && takesFileAsItIs(spec) && !spec.machine.strategy &&
	       std::holds_alternative<std::monostate>(probe.surface) &&
	       !(probe.own && std::ranges::any_of(probe.own->probe.sheets, hasForm)) &&
	       spec.look.color_by != view::ColorBy::generation && spec.look.outline != render::Outline::edges;
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

namespace
{

std::vector<std::uint32_t> joined(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b)
{
	std::vector<std::uint32_t> both;
	std::ranges::set_union(a, b, std::back_inserter(both));
	return both;
}

} // namespace

RunsOfBlocks runsMet(const grid::BlockSet& blocks, const cut::CutRequest& request)
{
	RunsOfBlocks met(blocks.blocks.size());
	const std::vector<probe::Sheet> sheets = probe::placed(request.probe).sheets;
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		const probe::Sheet content = probe::content(sheets[s]);
		std::optional<seed::SheetWindow> window;
		if (content.window)
			window.emplace(content);
		std::vector<surface::BlockSurface> surfaces;
		if (sheets[s].form)
			surfaces = find::surfacesOf(blocks, sheets[s], request.fieldOf(s));
		for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		{
			if (!blocks.blocks[b].runs)
				continue;
			const std::vector<std::uint32_t> more =
			    sheets[s].form ? find::runsMet(blocks.blocks[b], surfaces[b], window ? &*window : nullptr)
			                   : find::runsMet(blocks.blocks[b], content.plane(), window ? &*window : nullptr);
			met[b] = joined(met[b], more);
		}
	}
	return met;
}

RunsOfBlocks runsNear(const grid::BlockSet& blocks, const cut::CutRequest& request, const view::ContourSpec& contour)
{
	RunsOfBlocks near = runsMet(blocks, request);
	if (!contour.isGiven())
		return near;
	// Without a window a box reaches as far as the sheet does. Nothing was cut yet, so it is taken for as wide as all.
	mesh::SheetMesh widest;
	const Box bounds = blocks.bounds();
	for (int corner = 0; corner < 8; ++corner)
		widest.positions.emplace_back((corner & 1 ? bounds.hi : bounds.lo).x, (corner & 2 ? bounds.hi : bounds.lo).y,
		                              (corner & 4 ? bounds.hi : bounds.lo).z);
	const auto depth = contour.depth > 0.0 ? std::optional(contour.depth) : std::nullopt;
	for (const probe::Sheet& sheet : probe::placed(request.probe).sheets)
	{
		cut::SheetCut cut;
		cut.sheet = probe::content(sheet);
		const contour::ClipBox box = contour::boxOf(cut, contour::rectOf(cut, widest), depth);
		for (std::size_t b = 0; b < near.size(); ++b)
			if (const auto& runs = blocks.blocks[b].runs)
				near[b] = joined(near[b], runs->meeting(box));
	}
	return near;
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
	const RunsOfBlocks met = runsMet(blocks_, cutRequest(request));
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
	const RunsOfBlocks met_of_blocks = runsMet(blocks_, cutRequest(request));
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

// Returns true if the settings look at nothing but what frames read, also before there is a frame.
bool Session::doesWithParts(const view::ViewSpec& spec) const
{
	return looksAtCutAlone(spec, blocks_) ||
	       (is_for_one_frame_ && looksNearPlanes(spec) && (!spec.look.logarithmic || knowsLeastPositive(blocks_)));
}

bool Session::mayLinkNear() const
{
	const auto isInRuns = [](const grid::Block& block) { return block.runs != nullptr; };
	return ranks_.holdsAll() && doesWithParts(spec_) && looksNearPlanes(spec_) && is_for_one_frame_ &&
	       std::ranges::all_of(blocks_.blocks, isInRuns);
}

// Takes the cells near the sheets for all there are. Returns false if these are so many that all may as well be read.
Result<bool> Session::linkNear(const FrameRequest& request)
{
	const RunsOfBlocks near = runsNear(blocks_, cutRequest(request), spec_.look.contour);
	std::size_t runs = 0, all = 0;
	for (std::size_t b = 0; b < near.size(); ++b)
	{
		runs += near[b].size();
		all += blocks_.blocks[b].runs->runs().size();
	}
	if (2 * runs > all)
		return false;
	{
		const Progress progress("reading parts");
		const TimedSection section(timeline_.get(), "read");
		for (std::size_t b = 0; b < near.size(); ++b)
		{
			blocks_.blocks[b].runs->startCounting();
			blocks_.blocks[b].runs->fetch(near[b]);
		}
	}
	{
		const Progress progress("finding neighbors");
		const TimedSection section(timeline_.get(), "adjacency");
		for (std::size_t b = 0; b < near.size(); ++b)
			blocks_.blocks[b] = grid::linkedRuns(blocks_.blocks[b], near[b]);
		grid::matchInterfaces(blocks_);
	}
	if (Status made = makeCutter(); !made)
		return made.error();
	return true;
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
