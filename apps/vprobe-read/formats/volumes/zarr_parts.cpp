// Arrays of Zarr that stay where they are, and are read a chunk at a time.
#include "read/protocol.h"
#include "vprobe-read/base/refusal.h"
#include "zarr_array.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>

namespace vp::reader::volumes
{

std::optional<arrays::StoredPlace> ZarrArray::storedPlace(const std::vector<std::size_t>& front) const
{
	if (layout_.shape.size() != front.size() + 3 || partBytes() > read::kMaxPartBytes)
		return std::nullopt;
	std::error_code ignored;
	const bool is_second = std::filesystem::is_regular_file(folder_ / ".zarray", ignored);
	const char* about = layout_.has_block_heads ? "attributes.json" : is_second ? ".zarray" : "zarr.json";
	arrays::StoredPlace place{.file = (folder_ / about).string()};
	for (std::size_t axis = 0; axis < 3; ++axis)
		place.part[axis] = layout_.chunk[front.size() + 2 - axis];
	place.reader = turned_.empty() ? fmt::format("zarr {}", fmt::join(front, " "))
	                               : fmt::format("zarr turned {} {}", fmt::join(turned_, " "), fmt::join(front, " "));
	return place;
}

std::size_t ZarrArray::partBytes() const
{
	const std::size_t sides = layout_.chunk.size();
	if (sides < 3)
		return 0;
	return layout_.chunk[sides - 3] * layout_.chunk[sides - 2] * layout_.chunk[sides - 1] * widthInMemory();
}

void ZarrArray::readPart(const std::vector<std::size_t>& front, std::uint64_t number, std::span<std::byte> to) const
{
	const std::size_t sides = layout_.shape.size();
	if (sides != front.size() + 3 || to.size() != partBytes())
		throw damaged(fmt::format("its {} has other sides than are asked for", name_));
	std::vector<std::size_t> starts = front;
	std::vector<std::size_t> counts(front.size(), 1);
	starts.resize(sides);
	counts.resize(sides);
	for (std::size_t side = sides; side-- > front.size();
	     number /= (layout_.shape[side] + layout_.chunk[side] - 1) / layout_.chunk[side])
	{
		starts[side] =
		    number % ((layout_.shape[side] + layout_.chunk[side] - 1) / layout_.chunk[side]) * layout_.chunk[side];
		counts[side] = std::min(layout_.chunk[side], layout_.shape[side] - starts[side]);
	}
	for (std::size_t side = 0; side < front.size(); ++side)
		if (front[side] >= layout_.shape[side])
			throw damaged(fmt::format("its {} has other sides than are asked for", name_));
	const std::vector<std::size_t> held(counts.end() - 3, counts.end());
	const std::size_t width = widthInMemory();
	std::vector<std::byte> values(held[0] * held[1] * held[2] * width);
	read(starts, counts, values.data());
	for (std::size_t row = 0; row < held[0] * held[1]; ++row)
	{
		const std::size_t to_row = row / held[1] * layout_.chunk[sides - 2] + row % held[1];
		std::memcpy(to.data() + to_row * layout_.chunk[sides - 1] * width, values.data() + row * held[2] * width,
		            held[2] * width);
	}
}

} // namespace vp::reader::volumes
