#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// What a MetaImage header says of its data, as far as VTK's reader does not check or use it.
struct MetaHeader
{
	std::vector<std::uint64_t> size; // points along each axis
	std::string type;                // of one value, without "_ARRAY"
	std::uint64_t element_bytes = 0; // of one point; 0 for a type not known
	bool compressed = false;
	std::uint64_t compressed_bytes = 0;
	std::uint64_t skipped_bytes = 0; // before the data in their file; 0 where the data come last
	std::array<double, 9> direction = {1, 0, 0, 0, 1, 0, 0, 0, 1}; // rows; column i is the direction of axis i
	std::vector<double> spacing;         // along each axis; may be negative; empty where the header gives none
	std::vector<std::string> data_files; // one, or one per slice; empty: the data follow the header
	std::uint64_t header_bytes = 0;
};

MetaHeader readMetaHeader(const std::string& file);

// Turns round the directions of axes whose spacing is negative, as ITK does. The origin stays.
void makeSpacingPositive(MetaHeader& header);

// Throws a Refusal where a data file is missing or shorter than the header asks for; VTK's reader would show what
// happens to be in memory.
void refuseShortData(const std::string& file, const MetaHeader& header);
