#include "ranks/data/share.h"

#include "base/bytes_read.h"
#include "ranks/data/described_block.h"
#include "ranks/data/join_pieces.h"
#include "ranks/data/warnings_of_all.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>

namespace vp::ranks
{

namespace
{

// In the order of grid::AnyGrid.
constexpr const char* kKinds[] = {"image", "rectilinear", "curvilinear", "unstructured"};
constexpr std::size_t kUnstructured = 3;

// As grid::BlockSet::kind() says it of the blocks that one process would have.
std::string kindOf(const std::vector<std::string>& kinds)
{
	const auto isUnstructured = [](const std::string& kind) { return kind == kKinds[kUnstructured]; };
	if (std::ranges::all_of(kinds, isUnstructured))
		return kKinds[kUnstructured];
	if (std::ranges::any_of(kinds, isUnstructured))
		return "hybrid";
	return kinds.size() == 1 ? kinds[0] : "block-structured";
}

read::PartList listForAll(Team& team, const std::optional<read::PartList>& own)
{
	MessageWriter message;
	if (own)
	{
		message.putAll(own->parts);
		message.put(own->blocks.size());
		for (const read::PartList::Whole& whole : own->blocks)
		{
			message.put(whole.kind);
			message.put(whole.points);
		}
		message.putAll(own->times);
		message.put(own->time_units);
	}
	Bytes bytes = message.take();
	team.broadcast(bytes);
	MessageReader reader(bytes);
	read::PartList list;
	list.parts = reader.getAll<read::Part>();
	for (auto left = reader.get<std::size_t>(); left > 0; --left)
	{
		std::string kind = reader.getText();
		list.blocks.push_back({std::move(kind), reader.get<std::size_t>()});
	}
	list.times = reader.getAll<double>();
	list.time_units = reader.getText();
	return list;
}

// Adds a block to the counts of all. `last`: the block of one process that the block before belongs to.
void count(const DescribedBlock& block, const read::PartList& list, std::optional<std::size_t>& last,
           std::vector<std::string>& kinds, Share& share)
{
	const read::PartList::Whole& whole = list.blocks[block.whole];
	const bool goes_on = !whole.kind.empty() && last == block.whole;
	if (!goes_on)
	{
		kinds.push_back(whole.kind.empty() ? kKinds[block.kind] : whole.kind);
		share.counts.points += whole.points;
		share.counts.linear_points += whole.points;
	}
	share.whole.push_back(static_cast<std::uint32_t>(kinds.size() - 1));
	share.counts.cells += block.counts.cells;
	share.counts.linear_cells += block.counts.linear_cells;
	if (whole.points == 0)
	{
		share.counts.points += block.counts.points;
		share.counts.linear_points += block.counts.linear_points;
	}
	last = block.whole;
}

// The blocks of all ranks, those of others without cells.
grid::BlockSet withOthers(Team& team, read::PartBlocks&& own, const read::PartList& list, Share& share)
{
	MessageWriter message;
	message.put(own.set.blocks.size());
	message.put(own.set.left_out);
	message.put(own.set.unplaced);
	for (std::size_t b = 0; b < own.set.blocks.size(); ++b)
		put(message, own.set.blocks[b], own.of_block[b].block);
	const std::vector<Bytes> of_all = team.gatherAll(message.take());

	grid::BlockSet all = std::move(own.set);
	std::vector<grid::Block> mine = std::exchange(all.blocks, {});
	all.left_out = 0;
	all.unplaced = 0;
	std::optional<std::size_t> last;
	std::vector<std::string> kinds;
	for (int rank = 0; rank < team.size(); ++rank)
	{
		MessageReader reader(of_all[static_cast<std::size_t>(rank)]);
		const auto blocks = reader.get<std::size_t>();
		all.left_out += reader.get<std::size_t>();
		all.unplaced += reader.get<std::size_t>();
		if (rank == team.rank())
			share.first_own = static_cast<std::uint32_t>(all.blocks.size());
		for (std::size_t b = 0; b < blocks; ++b)
		{
			DescribedBlock block = described(reader);
			count(block, list, last, kinds, share);
			all.blocks.push_back(rank == team.rank() ? std::move(mine[b]) : standIn(std::move(block)));
		}
		if (rank == team.rank())
			share.end_own = static_cast<std::uint32_t>(all.blocks.size());
	}
	share.counts.blocks = kinds.size();
	share.counts.kind = kindOf(kinds);
	all.times = list.times;
	all.time_units = list.time_units;
	return all;
}

} // namespace

std::vector<int> dealOut(const std::vector<read::Part>& parts, int ranks)
{
	// With so many cells to a rank at most, which rank takes each part.
	const auto deal = [&](std::size_t most)
	{
		std::vector<int> of_part;
		int rank = 0;
		std::size_t cells = 0;
		for (const read::Part& part : parts)
		{
			if (cells > 0 && cells + part.cells > most)
			{
				++rank;
				cells = 0;
			}
			cells += std::max<std::size_t>(1, part.cells);
			of_part.push_back(rank);
		}
		return of_part;
	};
	std::size_t low = 1;
	std::size_t high = 1;
	for (const read::Part& part : parts)
	{
		low = std::max(low, part.cells);
		high += std::max<std::size_t>(1, part.cells);
	}
	while (low < high)
	{
		const std::size_t middle = std::midpoint(low, high);
		const std::vector<int> dealt = deal(middle);
		if (dealt.empty() || dealt.back() < ranks)
			high = middle;
		else
			low = middle + 1;
	}
	return deal(high);
}

Status canCarryOut(const Ranks& ranks, const view::ViewSpec& spec)
{
	if (!ranks.team())
		return Nothing{};
	const view::ProbeSpec& probe = spec.probe;
	const view::LookSpec& look = spec.look;
	// Their places follow from whole lines.
	const bool has_labels =
	    !look.no_labels &&
	    (look.lines > 0 || (probe.own && std::ranges::any_of(probe.own->probe.sheets, [](const auto& s)
	                                                         { return s.wishes.lines.has_value(); })));
	const bool is_window_in_plane =
	    !probe.threshold && !view::implicitSurface(probe.surface) &&
	    (probe.window || (probe.own && std::ranges::any_of(probe.own->probe.sheets,
	                                                       [](const auto& s) { return s.window.has_value(); })));
	struct Refused
	{
		bool given;
		const char* key;
		const char* why;
	};
	const Refused refused[] = {
	    {view::replacesSheets(probe.surface), "surface", "indices and patches are numbered in each part of the data"},
	    {probe.vectors.on() && probe.vectors.path_lines, "path_lines",
	     "each of several processes knows the vectors of one time"},
	    {probe.seeds == seed::SeedMode::boundary && is_window_in_plane, "seeds",
	     "borders between the parts of processes in a window would be taken for the boundary"},
	    {std::ranges::any_of(look.context, [](const auto& c) { return c.kind != view::ContextKind::boundary; }),
	     "context", "indices and patches are numbered in each part of the data"},
	    {look.color_by == view::ColorBy::generation, "color_by", "generations depend on how the parts were dealt out"},
	    {spec.machine.visited.has_value(), "visited", "generations depend on how the parts were dealt out"},
	    {spec.machine.strategy == find::Strategy::generations, "strategy",
	     "generations depend on how the parts were dealt out"},
	    {spec.machine.classify == view::Classify::gpu, "classify", "each of several processes cuts on its processor"},
	    {spec.input.cell_to_point, "cell_to_point",
	     "points between the parts of several processes have cells in each of them"},
	    {read::isTolerance(spec.input.refine), "refine",
	     "cells that a tolerance refines are not joined between processes"}};
	if (has_labels)
		return Error{ErrorKind::usage, "`lines`: values on lines that run through the parts of several processes are "
		                               "not drawn; add `no_labels`, or use vprobe in place of vprobe-mpi"};
	for (const Refused& r : refused)
		if (r.given)
			return Error{ErrorKind::usage,
			             fmt::format("`{}`: {}; leave it out, or use vprobe in place of vprobe-mpi", r.key, r.why)};
	return Nothing{};
}

namespace
{

// Reads this rank's share of the inputs.
Result<grid::BlockSet> readShare(Team& team, const std::vector<std::string>& inputs, const read::ReadOptions& options,
                                 Timeline* timeline, Share& share)
{
	// Several inputs are dealt out as they are: they mostly are parts of one data set.
	read::ReadOptions reading = options;
	reading.slabs = inputs.size() == 1 ? team.size() : 1;
	std::optional<read::PartList> listed;
	if (team.isFirst())
	{
		Result<read::PartList> list = read::listParts(inputs, reading, timeline);
		if (!list)
			return list.error();
		share.bytes_read = list->bytes_read;
		listed = std::move(*list);
	}
	const read::PartList list = listForAll(team, listed);
	const std::vector<int> ranks = dealOut(list.parts, team.size());
	std::vector<read::Part> own;
	for (std::size_t p = 0; p < list.parts.size(); ++p)
		if (ranks[p] == team.rank())
			own.push_back(list.parts[p]);
	Result<read::PartBlocks> read = read::readParts(inputs, own, reading, timeline);
	if (!read)
		return read.error();
	try
	{
		joinPieces(*read, list);
	}
	catch (const grid::WrongPoint& wrong)
	{
		return Error{ErrorKind::input, fmt::format("{}: {}", fmt::join(inputs, ", "), wrong.what())};
	}
	for (const read::InputWarning& warning : warningsOfAll(team, read->warnings))
		read::tell(warning);
	share.bytes_read += read->bytes_read;
	const bool has_interfaces = !read->set.interfaces.blocks.empty();
	share.own_parts = own.size();
	share.has_packs = anyOf(team, std::ranges::any_of(read->set.blocks, [](const grid::Block& block)
	                                                  { return block.runs && block.runs->isShare(); }));
	grid::BlockSet all = withOthers(team, std::move(*read), list, share);
	if (all.blocks.empty())
		return Error{ErrorKind::input,
		             fmt::format("{}: nothing to slice: it holds no three-dimensional cells", fmt::join(inputs, ", "))};
	if (has_interfaces) // their numbers are those of this rank's blocks alone
		grid::matchInterfaces(all);
	return all;
}

} // namespace

Result<grid::BlockSet> readInputs(Ranks& ranks, const std::vector<std::string>& inputs,
                                  const read::ReadOptions& options, Timeline* timeline)
{
	if (!ranks.team())
		return read::readInputs(inputs, options, timeline);
	auto share = std::make_shared<Share>();
	Result<grid::BlockSet> blocks = readShare(*ranks.team(), inputs, options, timeline, *share);
	share->counted_before = bytesRead();
	ranks.take(std::move(share));
	return blocks;
}

Share::Counts countsOf(const Ranks& ranks, const grid::BlockSet& blocks)
{
	if (ranks.team())
		return ranks.share().counts;
	Share::Counts counts{blocks.kind(),      blocks.sourceCellCount(), blocks.sourcePointCount(),
	                     blocks.cellCount(), blocks.pointCount(),      blocks.blocks.size()};
	for (const grid::Block& block : blocks.blocks)
		if (block.whole)
		{
			const Share::Counts here = countsOf(block);
			counts.cells += block.whole->cells - here.cells;
			counts.points += block.whole->points - here.points;
			counts.linear_cells += block.whole->cells - here.linear_cells;
			counts.linear_points += block.whole->points - here.linear_points;
		}
	return counts;
}

bool hasTimeInRuns(const Ranks& ranks, const grid::BlockSet& blocks, std::size_t time)
{
	if (!ranks.team())
		return grid::hasTimeInRuns(blocks, time);
	grid::BlockSet own;
	own.times = blocks.times;
	for (std::size_t b = ranks.share().first_own; b < ranks.share().end_own; ++b)
		own.blocks.push_back(blocks.blocks[b]);
	return ranks.share().has_packs && !ranks.any(!grid::hasTimeInRuns(own, time));
}

void nameWholeBlocks(const Ranks& ranks, std::span<std::int32_t> blocks)
{
	if (ranks.team())
		for (std::int32_t& block : blocks)
			block = static_cast<std::int32_t>(ranks.share().whole[static_cast<std::size_t>(block)]);
}

} // namespace vp::ranks
