#pragma once

#include "array_writer.h"
#include "quick_file.h"
#include "tasks.h"

#include <nlohmann/json.hpp>

#include <vector>

struct QuickPiece
{
	const XmlElement* element;
	std::uint64_t points;
	std::uint64_t cells;
	std::uint64_t first_point = 0; // of the arrays; those before are left out
	std::uint64_t first_cell = 0;
};

// The cell lists of the pieces, one behind the other. Throws NotQuick. What is added to the tasks writes the rest.
struct QuickCells
{
	nlohmann::json lists;
	std::size_t flat = 0;
};
QuickCells readQuickCells(const QuickFile& file, const std::vector<QuickPiece>& pieces, ArrayWriter& writer,
                          Tasks& tasks);

// Adds the copying of so many bytes of an array, behind the first ones, to a place in the shared memory.
void copyArray(const QuickFile& file, const XmlElement& array, std::uint64_t first, std::uint64_t bytes,
               ArrayWriter& writer, std::size_t at, Tasks& tasks);
