#include "stored_place.h"

#include "array_writer.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace vp::reader::arrays
{

using nlohmann::json;

StoredPlace storedRows(const std::string& file, std::uint64_t offset, const std::array<std::uint64_t, 3>& items,
                       std::uint64_t item_bytes, bool swaps)
{
	constexpr std::uint64_t kBytesOfRows = 16 << 10;
	const std::uint64_t row = std::max<std::uint64_t>(items[0] * item_bytes, 1);
	const std::uint64_t rows = std::clamp<std::uint64_t>(kBytesOfRows / row, 1, std::max<std::uint64_t>(items[1], 1));
	return {.file = file, .part = {items[0], rows, 1}, .offset = offset, .swaps = swaps};
}

StoredPlace storedLayers(const std::string& file, const std::vector<std::uint64_t>& layers,
                         const std::array<std::uint64_t, 3>& items, std::uint64_t item_bytes, bool swaps)
{
	StoredPlace place = storedRows(file, 0, items, item_bytes, swaps);
	std::uint64_t& rows = place.part[1];
	while (items[1] % rows != 0) // all parts are of one size
		--rows;
	place.offsets.reserve(layers.size() * (items[1] / rows));
	for (const std::uint64_t layer : layers)
		for (std::uint64_t row = 0; row < items[1]; row += rows)
			place.offsets.push_back(layer + row * items[0] * item_bytes);
	place.fill.assign(item_bytes, '\0');
	return place;
}

json describeStored(const StoredPlace& place, Writer& writer)
{
	json described = {{"file", place.file}, {"part", place.part}, {"swaps", place.swaps}};
	if (!place.reader.empty())
		described["reader"] = place.reader;
	else if (place.offsets.empty())
	{
		described["offset"] = place.offset;
	}
	if (place.offsets.empty())
		return described;
	const auto writeList = [&](const std::vector<std::uint64_t>& list)
	{ return writer.write(grid::NumberType::uint64, list.data(), list.size() * sizeof(list[0])); };
	described["offsets"] = writeList(place.offsets);
	if (!place.filters.empty())
	{
		described["filters"] = place.filters;
		described["sizes"] = writeList(place.sizes);
		described["left_out_filters"] = writeList(place.left_out);
	}
	described["fill"] = writer.write(grid::NumberType::uint8, place.fill.data(), place.fill.size());
	return described;
}

} // namespace vp::reader::arrays
