#include "refine/refiner.h"

#include "refine/refine_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::refine
{

namespace
{

/// A listed grid of the parts.
grid::UnstructuredGrid gridOf(const PartList& parts, std::size_t source_points)
{
	const std::size_t count = parts.types().size();
	std::vector<double> coordinates;
	coordinates.reserve(3 * parts.points().size());
	for (const PartPoint& point : parts.points())
		coordinates.insert(coordinates.end(), {point.position.x, point.position.y, point.position.z});
	std::vector<std::int64_t> offsets{0};
	offsets.reserve(count + 1);
	for (const std::uint8_t type : parts.types())
		offsets.push_back(offsets.back() + grid::topology(grid::shapeOf(type)).points);
	grid::CellList cells;
	cells.types = std::vector<std::uint8_t>(parts.types().begin(), parts.types().end());
	cells.offsets = std::move(offsets);
	cells.connectivity = std::vector<std::int32_t>(parts.corners().begin(), parts.corners().end());
	cells.source_cells = std::vector<std::int64_t>(parts.cells().begin(), parts.cells().end());
	cells.source_points = source_points;
	return grid::UnstructuredGrid::listed(grid::Points(Array<double>(std::move(coordinates))), std::move(cells));
}

grid::Block blockOf(const grid::Block& block, const CellKinds& kinds, const PartList& parts)
{
	grid::Block made;
	made.name = block.name;
	made.length_units = block.length_units;
	made.imaging = block.imaging;
	made.arrays_left_out = block.arrays_left_out;
	made.grid = gridOf(parts, block.curved->points.size());
	for (const grid::Field& field : block.fields)
		made.fields.push_back(
		    field.association == grid::Association::cell ? field : fieldOfParts(*block.curved, kinds, parts, field));
	finishBlock(made);
	return made;
}

std::string warningOf(const grid::Block& block, const Unfinished& unfinished)
{
	const std::string why = unfinished.by_cut
	                            ? fmt::format("all cells of the cut would have more than {} parts", kMaxPartsOfCut)
	                            : fmt::format("it would have more than {} parts", kMaxPartsOfCell);
	return fmt::format("`refine` {}: cell {} of block {} is shown as far as it was refined, since {}; look at its "
	                   "nodes, or give a larger tolerance",
	                   block.curved->tolerance, unfinished.first, block.name, why);
}

Error tooMany(const grid::Block& block)
{
	return {ErrorKind::usage, fmt::format("`refine` {}: block {} would have more than {} parts on the sheets; give a "
	                                      "larger tolerance",
	                                      block.curved->tolerance, block.name, kMaxParts)};
}

} // namespace

Refiner::Refiner(const grid::BlockSet& blocks) : blocks_(blocks), known_(blocks.blocks.size()) {}

Refiner::~Refiner() = default;

const Refiner::Known& Refiner::knownOf(std::size_t block)
{
	if (!known_[block])
		known_[block] = std::make_unique<Known>(*blocks_.blocks[block].curved);
	return *known_[block];
}

double Refiner::rangeOf(const grid::FieldChoice& choice)
{
	const auto known = std::ranges::find(ranges_, choice, &std::pair<grid::FieldChoice, double>::first);
	if (known != ranges_.end())
		return known->second;
	const auto [lo, hi] = grid::fieldRange(blocks_, choice);
	// Rounding is no feature of the values.
	const double range = hi - lo > 1e-12 * std::max(std::abs(lo), std::abs(hi)) ? hi - lo : 0.0;
	ranges_.emplace_back(choice, range);
	return range;
}

Result<Refined> Refiner::refine(const Sheets& sheets, std::span<const grid::FieldChoice> shown,
                                const std::stop_token& stop)
{
	const std::lock_guard lock(mutex_);
	Refined refined;
	auto set = std::make_shared<grid::BlockSet>();
	set->times = blocks_.times;
	for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
	{
		const grid::Block& block = blocks_.blocks[b];
		if (!block.curved)
		{
			set->blocks.push_back(block);
			continue;
		}
		std::vector<ShownArray> arrays;
		int width = 0;
		for (const grid::FieldChoice& choice : shown)
		{
			const grid::Field* field = choice.in(block);
			const double allowed = block.curved->tolerance * rangeOf(choice);
			if (!field || field->association != grid::Association::point || !(allowed > 0.0) || !std::isfinite(allowed))
				continue;
			arrays.push_back({field, choice.component, allowed});
			width += arrays.back().width();
		}
		if (width > kMaxShownNumbers)
			return Error{ErrorKind::usage,
			             fmt::format("`refine` {}: a tolerance applies to {} numbers of a point at most, and the "
			                         "sheets show {}; show a component in place of a magnitude, or give a level",
			                         block.curved->tolerance, kMaxShownNumbers, width)};
		try
		{
			const Known& known = knownOf(b);
			const std::size_t max_parts = kMaxPartsOfCut - std::min(kMaxPartsOfCut, refined.parts);
			const BlockParts made =
			    refineBlock(*block.curved, known.kinds, known.boxes, sheets, arrays, max_parts, stop);
			if (stop.stop_requested())
				return Error{ErrorKind::cancelled, "cutting was cancelled"};
			refined.looked_at += made.looked_at;
			refined.cells += made.cells;
			refined.parts += made.parts.types().size();
			if (made.unfinished.cells > 0 && refined.unfinished == 0)
				refined.warning = warningOf(block, made.unfinished);
			refined.unfinished += made.unfinished.cells;
			set->blocks.push_back(blockOf(block, known.kinds, made.parts));
		}
		catch (const TooManyParts&)
		{
			return tooMany(block);
		}
	}
	refined.blocks = std::move(set);
	return refined;
}

void Refiner::forgetValues()
{
	const std::lock_guard lock(mutex_);
	ranges_.clear();
}

std::size_t Refiner::bytes() const
{
	const std::lock_guard lock(mutex_);
	std::size_t sum = 0;
	for (const auto& known : known_)
		sum += known ? known->kinds.bytes() + known->boxes.bytes() : 0;
	return sum;
}

bool hasCurvedCells(const grid::BlockSet& blocks)
{
	return std::ranges::any_of(blocks.blocks, [](const grid::Block& block) { return block.curved != nullptr; });
}

} // namespace vp::refine
