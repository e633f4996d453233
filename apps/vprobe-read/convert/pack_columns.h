#pragma once

#include "hdf5_output.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>

namespace vp::reader::convert
{

class PackDivision;

// A list of the file with a row for each point, cell, run of cells, or corner of a cell.
struct Column
{
	RowWriter* rows;
	std::size_t row_bytes;
	std::function<std::size_t(std::size_t part)> rowsOf;
	// Writes the rows of a part. Threads gather parts side by side.
	std::function<void(std::size_t part, std::byte* to)> gather;
};

// Writes lists of all parts. While a thread writes, the others gather.
void writeColumns(const PackDivision& division, const std::deque<Column>& columns);

// Copies the chosen rows of an array.
void copyRows(const std::byte* from, std::size_t row_bytes, std::span<const std::uint32_t> rows, std::byte* to);

} // namespace vp::reader::convert
