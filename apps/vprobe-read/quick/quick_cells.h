#pragma once

#include "quick_file.h"
#include "tasks.h"
#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace vp::reader::quick
{

struct Piece
{
	const text::XmlElement* element;
	std::uint64_t points;
	std::uint64_t cells;
	std::uint64_t first_point = 0; // in the arrays; those before are left out
	std::uint64_t first_cell = 0;
	std::uint64_t all_points = points; // with those that are left out
	std::uint64_t all_cells = cells;
};

// Returns the cell lists of the pieces, one after the other. Throws NotQuick. The added tasks write the rest.
struct Cells
{
	// An object from the first: nlohmann's operator[] makes one of null, and leaves no valid one where memory fails.
	nlohmann::json lists = nlohmann::json::object();
	std::size_t flat = 0;
};
Cells readCells(const File& file, const std::vector<Piece>& pieces, arrays::Writer& writer, Tasks& tasks);

// A range of bytes of an array.
struct ByteRange
{
	std::uint64_t first = 0;
	std::uint64_t count = 0;
	std::uint64_t all = 0; // bytes of the whole array
};

// Adds tasks that copy some bytes of an array to a place in the shared memory.
void copyArray(const File& file, const text::XmlElement& array, const ByteRange& range, arrays::Writer& writer,
               std::size_t at, Tasks& tasks);

} // namespace vp::reader::quick
