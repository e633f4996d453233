#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// Holds the facts in a MetaImage header, as MetaIO (the library of ITK and VTK) takes them.
struct MetaHeader
{
	std::vector<std::uint64_t> size; // points along each axis; a fourth one is time
	bool is_picture = false;         // two dimensions; `size` has 1 for the third
	std::string type;                // the type of one value, without "_ARRAY"
	std::uint64_t value_bytes = 0;   // the size of one value; 0 for a type not known
	std::uint64_t channels = 1;      // values of a point
	bool is_text = false;            // numbers in text
	bool compressed = false;         // by zlib or gzip
	std::uint64_t compressed_bytes = 0;
	bool is_big_endian = false;
	std::int64_t skipped_bytes = 0; // before the data in their file; -1: the data end with the file
	std::array<double, 9> direction = {1, 0, 0, 0, 1, 0, 0, 0, 1}; // rows; column i is the direction of axis i
	std::vector<double> spacing;         // along each axis; may be negative; empty where the header gives none
	std::vector<double> offset;          // the place of the first point; likewise
	std::string units;                   // the unit of lengths; mostly empty
	std::string orientation;             // three letters, the sides from which the axes run; mostly empty
	bool has_scale = false;              // a slope or offset that ITK does not apply
	std::vector<std::string> data_files; // one after the other; empty: the data follow the header
	std::uint64_t header_bytes = 0;

	std::uint64_t times() const { return size.size() > 3 ? size[3] : 1; }
	// Returns the size of one time. Throws a Refusal if it is more than can be.
	std::uint64_t volumeBytes() const;
};

// Throws a Refusal where it is no header of a volume, or of a kind that is not read.
MetaHeader readMetaHeader(const std::string& file);

// Turns round the directions of axes whose spacing is negative, as ITK does. The origin stays.
void makeSpacingPositive(MetaHeader& header);

// Where the values at one time lie in their file, as they are.
struct MetaPlace
{
	std::string file;
	std::uint64_t offset;
};
// Returns nothing for text, for what is packed, and for values in several files. Throws as metaBytes() does.
std::optional<MetaPlace> metaPlace(const std::string& file, const MetaHeader& header, std::uint64_t time);

// The values at one time, unpacked, in the file's order of bytes; or the whole text. Throws a Refusal where a data file
// is missing or shorter than the header asks for, or cannot be unpacked.
std::string metaBytes(const std::string& file, const MetaHeader& header, std::uint64_t time);

} // namespace vp::reader::volumes
