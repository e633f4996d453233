#pragma once

#include "vprobe-read/arrays/packed_parts.h"
#include "vprobe-read/arrays/stored_array.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::reader::convert
{

// Reads an array that stays in its file some layers at a time, so that it is never in memory as a whole.
class StoredLayers
{
public:
	// place: of an array with this layout. threads: the most to use.
	StoredLayers(const arrays::StoredPlace& place, const arrays::ValueLayout& layout, int threads);

	std::uint64_t layerBytes() const { return layer_bytes_; }
	// How many layers are read best at once: those of a row of parts.
	std::uint64_t layersAtOnce() const { return place_.part[2]; }
	// Reads layers from k = first on, as many as `to` has room for. Throws a Refusal.
	void read(std::uint64_t first, std::span<std::byte> to) const;

private:
	void readRows(std::uint64_t first, std::span<std::byte> to) const;
	void readParts(std::uint64_t first, std::span<std::byte> to) const;
	void readPart(std::uint64_t number, std::span<std::byte> part) const;

	const arrays::StoredPlace& place_;
	std::array<std::uint64_t, 3> items_;
	std::uint64_t item_bytes_;
	std::uint64_t number_bytes_;
	std::uint64_t layer_bytes_;
	int threads_;
	arrays::UnpackPart unpack_; // null for rows
};

} // namespace vp::reader::convert
