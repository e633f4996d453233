#pragma once

#include "array_wish.h"
#include "read/source_stamp.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vp::reader
{

// Holds the parent's request.
struct Request
{
	std::string file;
	std::vector<std::string> slices; // files that are slices of one volume, `file` the first; mostly empty
	bool is_slice = false;           // the file is one of them, and may have two dimensions
	std::string format;              // its name in format_table.inl; empty where the file tells
	std::string raw;                 // how the values of a raw volume are laid out, see read/raw_layout.h; may be empty
	std::string solution;            // PLOT3D q file; may be empty
	enum class Time
	{
		last,
		first,
		nearest,
		index
	} time = Time::last;
	double time_value = 0.0;
	std::size_t time_index = 0;
	bool packs_all_times = false;  // the last time stands for all
	std::string displace;          // "FACTOR" or "FACTOR NAME": how far points move, and by which array; mostly empty
	bool patches = false;          // whether the parts of the boundary that the file names are wanted
	double refine = 0.0;           // how often the linear parts of curved cells are halved, or a tolerance
	std::size_t level = 0;         // which of several resolutions of an image, 0 the finest
	int threads = 1;               // the most to use
	std::string convert_to;        // the file that is to be written; mostly empty
	std::string convert_folder;    // a folder of the parent's, into which it is written
	std::size_t cells_of_part = 0; // at most, where the file that is written comes in parts; else 0
	read::SourceStamp stamp{};     // what the file was before it was read, where its index is written
	std::vector<std::string> said; // likewise, what its reader warned of
	ArrayWish arrays;              // those to hand over
	std::uint64_t stays_above = ~std::uint64_t(0); // arrays of more bytes may stay in the file
	std::string unpack;                            // how the parts are packed that are to be unpacked; mostly empty
	std::string sandbox = "off";                   // auto, require or off
	std::vector<std::string> follow;               // folders with files that the input may name, or "anywhere"
	std::string parts;                             // those to hand over, see PartFilter; mostly empty
	bool wants_places = false;                     // the parent reads the cells of a pack by itself
	char** arguments = nullptr;                    // as the process was started with them

	// Returns true if the index of the file is to be written.
	bool writesIndex() const { return convert_to.ends_with(read::kIndexEnding); }
	// Returns true if so many bytes of values may stay in the file.
	bool leaves(std::uint64_t bytes) const { return bytes > stays_above; }
};

} // namespace vp::reader
