#include "kept_grid.h"

#include <algorithm>
#include <bit>

namespace vprobe_paraview
{

void KeptGrid::forget()
{
	data_.reset();
	grid_stamps_.clear();
	field_stamps_.clear();
	leaf_of_block_.clear();
	crops_.clear();
	has_neighbors_ = false;
}

void KeptGrid::take(const std::vector<Leaf>& leaves, double tolerance, std::stop_token stop)
{
	Stamps grids{std::bit_cast<std::uint64_t>(tolerance)}, fields;
	for (const Leaf& leaf : leaves)
	{
		addGridStamps(leaf, grids);
		addFieldStamps(leaf, fields);
	}
	if (!data_ || grids != grid_stamps_)
	{
		forget();
		wrap(leaves, tolerance, std::move(stop));
	}
	else if (fields != field_stamps_)
		setFields(leaves);
	grid_stamps_ = std::move(grids);
	field_stamps_ = std::move(fields);
}

void KeptGrid::wrap(const std::vector<Leaf>& leaves, double tolerance, std::stop_token stop)
{
	std::vector<vprobe::Block> blocks;
	std::string left_out;
	for (const Leaf& leaf : leaves)
	{
		try
		{
			blocks.push_back(blockOf(leaf, tolerance));
			leaf_of_block_.push_back(leaf.index);
			crops_.push_back(cropOf(*leaf.data));
		}
		catch (const NoVolume& none)
		{
			left_out = none.what();
		}
	}
	if (blocks.empty())
	{
		if (!left_out.empty())
			throw NoVolume(left_out);
		return;
	}
	// On the CPU: ranks of a server would share one device.
	vprobe::Result<vprobe::Dataset> data =
	    vprobe::Dataset::wrap(std::move(blocks), vprobe::Classify::cpu, "", std::move(stop));
	if (!data && data.error().kind == vprobe::ErrorKind::cancelled)
		throw Cancelled();
	if (!data)
		throw Refused(data.error().message);
	data_ = std::move(*data);
	++counts_.grids;
}

void KeptGrid::setFields(const std::vector<Leaf>& leaves)
{
	std::vector<std::vector<vprobe::Field>> fields;
	for (const std::uint32_t index : leaf_of_block_)
		fields.push_back(fieldsOf(*std::ranges::find(leaves, index, &Leaf::index)->data));
	if (const vprobe::Status set = data_->setFields(std::move(fields)); !set)
		throw Refused(set.error().message);
}

vprobe::Result<vprobe::Cut> KeptGrid::cut(const vprobe::View& view, std::stop_token stop)
{
	vprobe::Result<vprobe::Cut> cut = data_->cut(view, std::move(stop));
	++counts_.cuts;
	// The first cut of an unstructured grid does without neighbors, and so do all cuts of straight axes.
	if (!has_neighbors_ && data_->memory().copied)
	{
		has_neighbors_ = true;
		++counts_.neighbors;
	}
	return cut;
}

} // namespace vprobe_paraview
