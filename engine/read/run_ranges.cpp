// Which runs of a pack hold a value (packed_cells.h).
#include "read/run_ranges.h"

#include "base/parallel_for.h"
#include "grid/shown_value.h"
#include "read/packed_cells.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace vp::read
{

using grid::Association;

// Only for the values that the block has now.
std::optional<std::size_t> PackedCells::arrayOf(const grid::Field& field) const
{
	for (std::size_t a = 0; a < arrays_.size(); ++a)
		if (field.bytes.data() == arrays_[a]->data())
			return a;
	return std::nullopt;
}

// Returns null if the file does not tell them, or they cannot be read.
const PackedCells::Ranges* PackedCells::rangesOf(std::size_t array) const
{
	const std::lock_guard lock(ranges_mutex_);
	if (const auto known = ranges_.find(array); known != ranges_.end())
		return &known->second;
	const ArrayLists& lists = contents_.arrays[array];
	const std::optional<std::uint64_t> offset = lists.times[contents_.time].ranges;
	if (!offset || lists.field.association != Association::point)
		return nullptr;
	Ranges ranges;
	ranges.ends.resize(runs().size() * columnsOfRanges(lists.field.components) * 2);
	try
	{
		readRows({*offset, bytesOfRanges(lists.field)}, 0, runs().size(), ranges.ends.data());
	}
	catch (const parts::Unreadable&)
	{
		return nullptr; // whoever reads the runs is told
	}
	ranges.are_checked.resize(runs().size());
	return &ranges_.emplace(array, std::move(ranges)).first->second;
}

std::vector<std::uint32_t> PackedCells::holding(const grid::Field& field, int component, double value) const
{
	const std::optional<std::size_t> array = arrayOf(field);
	const std::size_t columns = columnsOfRanges(field.components);
	const auto column = component == grid::kMagnitude ? columns - 1 : static_cast<std::size_t>(component);
	const bool has_column = component != grid::kMagnitude || field.components > 1;
	const Ranges* ranges = array && has_column ? rangesOf(*array) : nullptr;
	if (!ranges)
		return all();
	std::vector<std::uint32_t> held;
	for (std::uint32_t run = own().begin; run < own().end; ++run)
	{
		const float* ends = ranges->ends.data() + (run * columns + column) * 2;
		if (ends[0] <= value && value <= ends[1])
			held.push_back(run);
	}
	return held;
}

// A surface of one value goes by the ranges, so values that were changed by hand would lose cells without a word.
void PackedCells::checkRanges(std::span<const std::uint32_t> numbers)
{
	std::vector<std::pair<std::size_t, Ranges*>> asked_for;
	{
		const std::lock_guard lock(ranges_mutex_);
		for (auto& [array, ranges] : ranges_)
			asked_for.emplace_back(array, &ranges);
	}
	for (const auto& [array, ranges] : asked_for)
	{
		std::vector<std::uint32_t> unchecked;
		for (const std::uint32_t run : numbers)
			if (!ranges->are_checked[run])
				unchecked.push_back(run);
		tracedFor(std::size_t(0), unchecked.size(),
		          [&, a = array, &ends = ranges->ends](std::size_t i) { checkRange(a, unchecked[i], ends); });
		for (const std::uint32_t run : unchecked)
			ranges->are_checked[run] = true;
	}
}

void PackedCells::checkRange(std::size_t array, std::uint32_t run, std::span<const float> ends) const
{
	grid::Field field = contents_.arrays[array].field;
	field.bytes = {arrays_[array], arrays_[array]->data(), arrays_[array]->size()};
	const std::size_t columns = columnsOfRanges(field.components);
	const float* of_run = ends.data() + run * columns * 2;
	const auto* ids = id_memory_->as<std::int32_t>() + first_ids_[run];
	for (std::uint64_t id = 0; id < contents_.run_ids[run]; ++id)
		for (std::size_t column = 0; column < columns; ++column)
		{
			const bool is_length = column + 1 == columns && columns > 1;
			const double value = grid::shownValue(field, static_cast<std::size_t>(ids[id]),
			                                      is_length ? grid::kMagnitude : static_cast<int>(column));
			if (std::isfinite(value) && !(of_run[2 * column] <= value && value <= of_run[2 * column + 1]))
				throw parts::Unreadable(
				    fmt::format("{}: truncated or damaged: a value of {} lies outside the range of its "
				                "cells; pack the file again",
				                contents_.file->name(), field.name));
		}
}

} // namespace vp::read
