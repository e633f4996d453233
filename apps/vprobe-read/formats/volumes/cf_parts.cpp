#include "cf_parts.h"

#include "read/protocol.h"
#include "vprobe-read/base/refusal.h"

#include <vtkDataArray.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <sstream>

namespace vp::reader::volumes
{

namespace
{

using Three = std::array<std::size_t, 3>;

// Parts have so many values at the least: what is read at once takes some time to find.
constexpr std::size_t kLeastItems = 1 << 15;
constexpr std::size_t kMostItems = 1 << 24;
static_assert(kMostItems * sizeof(double) <= read::kMaxPartBytes);

template <std::size_t Width>
void turnAxes(const char* from, char* to, const Three& counts, const Three& strides)
{
	for (std::size_t a = 0; a < counts[0]; ++a)
		for (std::size_t b = 0; b < counts[1]; ++b)
			for (std::size_t c = 0; c < counts[2]; ++c, from += Width)
				std::memcpy(to + (a * strides[0] + b * strides[1] + c * strides[2]) * Width, from, Width);
}

// The axes as the file has them, the fastest one last.
Three inOrderOfFile(const Three& sides)
{
	Three order = {0, 1, 2};
	std::ranges::sort(order, {}, [&](std::size_t axis) { return sides[axis]; });
	return order;
}

// The chunks of the file, several of them together if they are small.
std::optional<Three> partOf(const hdf5::NetcdfFile& file, const CfVolume& volume, const Three& lengths)
{
	const std::vector<std::size_t> chunk = file.chunkOf(volume.variable);
	Three part = {1, 1, 1};
	std::size_t items = 1;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		if (!chunk.empty())
			part[axis] = std::clamp<std::size_t>(chunk.at(volume.sides[axis]), 1, lengths[axis]);
		if (__builtin_mul_overflow(items, part[axis], &items))
			return std::nullopt;
	}
	if (items > kMostItems)
		return std::nullopt;
	const Three order = inOrderOfFile(volume.sides);
	for (std::size_t i = 3; i-- > 0 && items < kLeastItems;)
	{
		std::size_t& side = part[order[i]];
		const std::size_t others = items / side, along = (lengths[order[i]] + side - 1) / side;
		side *= std::min(along, (kLeastItems + items - 1) / items);
		items = others * side;
	}
	return part;
}

} // namespace

vtkSmartPointer<vtkDataArray> withXFastest(vtkSmartPointer<vtkDataArray> array, const Three& sides,
                                           const Three& lengths)
{
	const auto [x, y, z] = sides;
	if (z < y && y < x)
		return array;
	const Three of_axes = {1, lengths[0], lengths[0] * lengths[1]}, order = inOrderOfFile(sides);
	Three counts, strides;
	for (std::size_t i = 0; i < 3; ++i)
	{
		counts[i] = lengths[order[i]];
		strides[i] = of_axes[order[i]];
	}
	const auto turned = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
	turned->SetNumberOfTuples(array->GetNumberOfTuples());
	const auto* from = static_cast<const char*>(array->GetVoidPointer(0));
	auto* to = static_cast<char*>(turned->GetVoidPointer(0));
	switch (array->GetDataTypeSize())
	{
	case 1:
		turnAxes<1>(from, to, counts, strides);
		break;
	case 2:
		turnAxes<2>(from, to, counts, strides);
		break;
	case 4:
		turnAxes<4>(from, to, counts, strides);
		break;
	default:
		turnAxes<8>(from, to, counts, strides);
	}
	return turned;
}

std::optional<arrays::StoredPlace> cfStoredPlace(const hdf5::NetcdfFile& file, const CfVolume& volume,
                                                 const CfSlab& slab, const Three& lengths)
{
	const std::optional<Three> part = partOf(file, volume, lengths);
	if (!part || volume.name.find('\0') != std::string::npos)
		return std::nullopt;
	arrays::StoredPlace place =
	    file.placeOfParts(fmt::format("{} {} {} {} {}", fmt::join(*part, " "), fmt::join(volume.sides, " "),
	                                  slab.starts.size(), fmt::join(slab.starts, " "), volume.name));
	if (place.file.empty())
		return std::nullopt;
	std::ranges::copy(*part, place.part.begin());
	return place;
}

std::mutex CfParts::one_at_a_time_;

CfParts::CfParts(std::unique_ptr<hdf5::NetcdfFile> file, const std::string& words) : file_(std::move(file))
{
	std::istringstream in(words);
	for (std::size_t& side : part_)
		in >> side;
	for (std::size_t& side : sides_)
		in >> side;
	std::size_t count = 0;
	in >> count;
	for (std::size_t start = 0; slab_.starts.size() < count && in >> start;)
		slab_.starts.push_back(start);
	in.get();
	std::string name;
	std::getline(in, name, '\0');
	variable_ = file_->variable(name.c_str());
	const Refusal other = damaged(fmt::format("its {} has other sides than are asked for", name));
	if (!in || variable_ < 0)
		throw other;
	const auto dimensions = file_->dimensions(variable_);
	if (dimensions.size() != slab_.starts.size())
		throw other;
	slab_.counts.assign(dimensions.size(), 1);
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		if (sides_[axis] >= dimensions.size() || slab_.counts[sides_[axis]] == 0 || part_[axis] == 0 ||
		    part_[axis] > kMostItems)
			throw other;
		slab_.counts[sides_[axis]] = 0; // no other axis may have it
		lengths_[axis] = dimensions[sides_[axis]].second;
	}
	for (std::size_t side = 0; side < dimensions.size(); ++side)
		if (slab_.starts[side] >= dimensions[side].second)
			throw other;
	meaning_ = cfMeaning(*file_, variable_);
}

void CfParts::read(std::uint64_t number, std::span<std::byte> to) const
{
	CfSlab slab = slab_;
	Three held;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const std::size_t along = (lengths_[axis] + part_[axis] - 1) / part_[axis];
		const std::size_t first = number % along * part_[axis];
		number /= along;
		held[axis] = std::min(part_[axis], lengths_[axis] - first);
		slab.starts[sides_[axis]] = first;
		slab.counts[sides_[axis]] = held[axis];
	}
	vtkSmartPointer<vtkDataArray> values;
	{
		const std::lock_guard lock(one_at_a_time_);
		values = cfStored(*file_, variable_, slab);
	}
	values = withXFastest(meaning_(values), sides_, held);
	const auto width = static_cast<std::size_t>(values->GetDataTypeSize());
	if (number > 0 || to.size() != part_[0] * part_[1] * part_[2] * width)
		throw damaged("it has other parts than are asked for");
	const auto* from = static_cast<const std::byte*>(values->GetVoidPointer(0));
	for (std::size_t row = 0; row < held[1] * held[2]; ++row)
	{
		const std::size_t to_row = row / held[1] * part_[1] + row % held[1];
		std::memcpy(to.data() + to_row * part_[0] * width, from + row * held[0] * width, held[0] * width);
	}
}

} // namespace vp::reader::volumes
