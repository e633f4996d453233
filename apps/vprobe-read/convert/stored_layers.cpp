#include "stored_layers.h"

#include "parts/part_bytes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/quick/tasks.h"

#include <algorithm>
#include <cstring>

namespace vp::reader::convert
{

StoredLayers::StoredLayers(const arrays::StoredPlace& place, const arrays::ValueLayout& layout, int threads)
    : place_(place), items_{layout.points[0], layout.points[1], layout.points[2]},
      item_bytes_(layout.components * byteSize(layout.type)), number_bytes_(byteSize(layout.type)),
      layer_bytes_(items_[0] * items_[1] * item_bytes_), threads_(threads)
{
	if (!place.reader.empty() || !place.offsets.empty())
		unpack_ = arrays::unpackerOf(place.file, place.reader.empty() ? place.filters : place.reader);
}

void StoredLayers::read(std::uint64_t first, std::span<std::byte> to) const
{
	unpack_ ? readParts(first, to) : readRows(first, to);
	if (place_.swaps)
		parts::swapNumbers(to, number_bytes_);
}

void StoredLayers::readRows(std::uint64_t first, std::span<std::byte> to) const
{
	const MappedText file(place_.file);
	const std::uint64_t begin = place_.offset + first * layer_bytes_;
	if (begin > file.text().size() || to.size() > file.text().size() - begin)
		throw damaged("it ends before its values do");
	std::memcpy(to.data(), file.text().data() + begin, to.size());
}

void StoredLayers::readPart(std::uint64_t number, std::span<std::byte> part) const
{
	if (!place_.reader.empty())
		return unpack_({number, 0, 0}, part);
	if (place_.offsets[number] == ~std::uint64_t(0))
		return parts::fillItems(part, std::as_bytes(std::span(place_.fill)));
	const bool is_packed = !place_.filters.empty();
	unpack_({place_.offsets[number], is_packed ? place_.sizes[number] : part.size(),
	         is_packed ? place_.left_out[number] : 0},
	        part);
}

void StoredLayers::readParts(std::uint64_t first, std::span<std::byte> to) const
{
	const auto& side = place_.part;
	std::array<std::uint64_t, 3> along{};
	for (std::size_t axis = 0; axis < 3; ++axis)
		along[axis] = (items_[axis] + side[axis] - 1) / side[axis];
	const std::uint64_t end = first + to.size() / layer_bytes_;
	const std::uint64_t of_layer = along[0] * along[1];
	const std::uint64_t first_part = first / side[2] * of_layer;
	const std::uint64_t end_part = (end + side[2] - 1) / side[2] * of_layer;
	quick::Tasks tasks(threads_);
	tasks.add(end_part - first_part,
	          [&](std::size_t task, arrays::Scratch& scratch)
	          {
		          const std::uint64_t number = first_part + task;
		          scratch.unpacked.assign(side[0] * side[1] * side[2] * item_bytes_, std::byte(0));
		          readPart(number, scratch.unpacked);
		          const std::uint64_t i = number % along[0] * side[0];
		          const std::uint64_t j = number / along[0] % along[1] * side[1];
		          const std::uint64_t k = number / of_layer * side[2];
		          const std::uint64_t row = std::min(side[0], items_[0] - i) * item_bytes_;
		          for (std::uint64_t z = std::max(k, first); z < std::min(k + side[2], end); ++z)
			          for (std::uint64_t y = j; y < std::min(j + side[1], items_[1]); ++y)
				          std::memcpy(to.data() + (z - first) * layer_bytes_ + (y * items_[0] + i) * item_bytes_,
				                      scratch.unpacked.data() + ((z - k) * side[1] + (y - j)) * side[0] * item_bytes_,
				                      row);
	          });
	tasks.run();
}

} // namespace vp::reader::convert
