// After ISO/IEC 15444-1, annex A. Decoders fill up what a codestream lacks, and say nothing.
#include "jpeg2000_parts.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vp::reader::volumes
{

namespace
{

// Markers: SOC, SOT, SOD, EOC.
constexpr std::uint32_t kJpegStart = 0xFF4F, kJpegTilePart = 0xFF90, kJpegData = 0xFF93, kJpegEnd = 0xFFD9;
constexpr std::string_view kJpegStartAndSize = "\xFF\x4F\xFF\x51";
constexpr std::size_t kJpegTilePartHead = 12;  // bytes of the marker and what belongs to it
constexpr std::uint64_t kMaxJpegTiles = 65535; // that an index has room for

// Numbers in the order of big endian; 0 past the end.
class Jpeg2000Numbers
{
public:
	explicit Jpeg2000Numbers(std::string_view bytes) : bytes_(bytes) {}

	std::uint32_t at(std::size_t place, std::size_t width) const
	{
		std::uint32_t number = 0;
		for (std::size_t i = 0; i < width; ++i)
			number = number << 8 | (place + i < bytes_.size() ? static_cast<unsigned char>(bytes_[place + i]) : 0);
		return number;
	}
	std::uint32_t marker(std::size_t place) const { return at(place, 2); }

private:
	std::string_view bytes_;
};

// Tiles that the size (SIZ, at `place`) asks for; 0 where the picture is another.
std::uint64_t tilesOf(const Jpeg2000Numbers& numbers, std::size_t place, std::uint32_t columns, std::uint32_t rows,
                      std::uint32_t samples)
{
	std::uint64_t tiles = numbers.at(place + 38, 2) == samples ? 1 : 0;
	const std::uint32_t wanted[] = {columns, rows};
	for (std::size_t axis = 0; axis < 2; ++axis)
	{
		const std::size_t of_axis = place + 6 + 4 * axis;
		const std::uint64_t end = numbers.at(of_axis, 4), first = numbers.at(of_axis + 8, 4);
		const std::uint64_t side = numbers.at(of_axis + 16, 4), first_tile = numbers.at(of_axis + 24, 4);
		if (end < first || end - first != wanted[axis] || side == 0 || first_tile > first)
			return 0;
		tiles *= (end - first_tile + side - 1) / side;
	}
	return tiles > kMaxJpegTiles ? 0 : tiles;
}

// Behind the marker segments that begin at `at`: the place of the marker that ends them, or past the end.
std::size_t pastSegments(const Jpeg2000Numbers& numbers, std::size_t at, std::size_t size, std::uint32_t last)
{
	while (at < size && numbers.marker(at) != last)
	{
		const std::uint32_t marker = numbers.marker(at), length = numbers.at(at + 2, 2);
		if (marker < 0xFF00 || marker == kJpegTilePart || marker == kJpegData || marker == kJpegEnd || length < 2)
			return size;
		at += 2 + length;
	}
	return std::min(at, size);
}

} // namespace

bool isWholeJpeg2000(std::string_view bytes, std::uint32_t columns, std::uint32_t rows, std::uint32_t samples)
{
	if (!bytes.starts_with(kJpegStartAndSize))
		return bytes.size() >= 2 && Jpeg2000Numbers(bytes).marker(0) != kJpegStart;
	const Jpeg2000Numbers numbers(bytes);
	const std::uint64_t tiles = tilesOf(numbers, 2, columns, rows, samples);
	std::vector<bool> seen(tiles, false);
	std::size_t at = pastSegments(numbers, 2, bytes.size(), kJpegTilePart);
	// Each tile-part: a marker, two bytes, the tile, four bytes of the length, two bytes.
	while (at + kJpegTilePartHead <= bytes.size() && numbers.marker(at) == kJpegTilePart)
	{
		const std::uint32_t tile = numbers.at(at + 4, 2);
		std::size_t length = numbers.at(at + 6, 4);
		if (length == 0) // up to the end of all
		{
			const std::size_t end = bytes.rfind("\xFF\xD9");
			length = end == bytes.npos || end < at ? 0 : end - at;
		}
		const std::size_t data = pastSegments(numbers, at + kJpegTilePartHead, bytes.size(), kJpegData);
		if (tile >= tiles || length > bytes.size() - at || data + 2 > at + length)
			return false;
		seen[tile] = true;
		at += length;
	}
	// Some writers leave the mark of the end out; DICOM's pieces have an even length.
	const bool ends =
	    numbers.marker(at) == kJpegEnd || bytes.substr(at).find_first_not_of('\0') == std::string_view::npos;
	return ends && tiles > 0 && std::ranges::all_of(seen, [](bool is_there) { return is_there; });
}

} // namespace vp::reader::volumes
