#include "api/border.h"
#include "api/states.h"
#include "base/stop_scope.h"
#include "locate/place.h"
#include "write/place_values.h"
#include "write/set_arrays.h"

#include <vprobe/dataset.h>

#include <algorithm>
#include <limits>

namespace vprobe
{

namespace
{

// Fills one column at a point.
struct SampleAt
{
	const vp::write::SetArray& array;
	const vp::locate::Place& place;
	std::vector<double>& values;

	template <vp::grid::Grid G>
	void operator()(const G& grid) const
	{
		const vp::grid::Field* field = array.per_block[place.block];
		for (int c = 0; c < array.components; ++c)
		{
			double value = std::numeric_limits<double>::quiet_NaN();
			if (field && c < field->components)
				value = field->association == vp::grid::Association::point
				            ? vp::write::valueAt(grid, *field, c, place.weights)
				            : field->value(grid.sourceCell(place.cell), c);
			values.push_back(value);
		}
	}
};

vp::Result<std::vector<vp::write::SetArray>> sampledArrays(const vp::grid::BlockSet& blocks,
                                                           const std::vector<std::string>& names)
{
	std::vector<vp::write::SetArray> all = vp::write::arraysOf(blocks, vp::grid::Association::point);
	for (vp::write::SetArray& array : vp::write::arraysOf(blocks, vp::grid::Association::cell))
		all.push_back(std::move(array));
	if (names.empty())
		return all;
	std::vector<vp::write::SetArray> chosen;
	for (const std::string& name : names)
	{
		const auto choice = vp::grid::chooseField(blocks, name);
		if (!choice)
			return choice.error();
		for (const vp::write::SetArray& array : all)
			for (const vp::grid::Field* field : array.per_block)
				if (field && *choice && array.name == (*choice)->name && field->association == (*choice)->association)
				{
					chosen.push_back(array);
					break;
				}
	}
	return chosen;
}

std::vector<Samples::Column> columnsOf(const std::vector<vp::write::SetArray>& arrays)
{
	std::vector<Samples::Column> columns;
	for (const vp::write::SetArray& array : arrays)
		if (const auto known =
		        std::ranges::find_if(array.per_block, [](const auto* field) { return field != nullptr; });
		    known != array.per_block.end())
		{
			ArrayInfo info = infoOf(**known);
			info.components = array.components;
			columns.push_back({std::move(info), {}});
		}
	return columns;
}

void addPlace(const vp::grid::BlockSet& blocks, const vp::locate::Place& place,
              const std::vector<vp::write::SetArray>& arrays, Samples& samples)
{
	samples.blocks.push_back(place.found() ? static_cast<std::int32_t>(place.block) : -1);
	samples.cells.push_back(place.found() ? vp::grid::cellNumber(blocks.blocks[place.block], place.cell) : -1);
	for (std::size_t a = 0; a < arrays.size(); ++a)
	{
		std::vector<double>& values = samples.columns[a].values;
		if (place.found())
			std::visit(SampleAt{arrays[a], place, values}, blocks.blocks[place.block].grid);
		else
			values.resize(values.size() + static_cast<std::size_t>(arrays[a].components),
			              std::numeric_limits<double>::quiet_NaN());
	}
}

vp::Result<Samples> samplesAt(const vp::grid::BlockSet& blocks, std::span<const Vector3> points,
                              const std::vector<std::string>& names)
{
	const auto arrays = sampledArrays(blocks, names);
	if (!arrays)
		return arrays.error();
	Samples samples;
	samples.columns = columnsOf(*arrays);
	vp::locate::PlaceFinder finder(blocks);
	for (const Vector3& point : points)
	{
		vp::throwIfStopped();
		addPlace(blocks, finder.find({point[0], point[1], point[2]}), *arrays, samples);
	}
	return samples;
}

} // namespace

Result<Samples> Dataset::sample(std::span<const Vector3> points, const std::vector<std::string>& names,
                                std::stop_token stop) const
{
	return guarded(
	    [&]() -> Result<Samples>
	    {
		    const std::lock_guard lock(state_->mutex);
		    if (vp::Status returned = state_->returnToItsTime(); !returned)
			    return publicError(returned.error());
		    if (vp::Status linked = state_->link(stop); !linked)
			    return publicError(linked.error());
		    vp::Result<Samples> samples = vp::endingOnRequest(
		        stop, "sampling", [&] { return samplesAt(state_->session->blocks(), points, names); });
		    return samples ? Result<Samples>(std::move(*samples)) : publicError(samples.error());
	    });
}

} // namespace vprobe
