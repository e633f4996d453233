#pragma once

#include "vprobe-read/arrays/array_writer.h"
#include "vprobe-read/base/array_wish.h"
#include "vprobe-read/base/part_filter.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

// A block of the manifest, but for its name.
struct QuickBlock
{
	nlohmann::json block;
	std::size_t flat = 0;      // cells of dimension below three
	std::vector<double> times; // that the file names: none or one
};

// Reads a .vti, .vtr, .vts or .vtu file without VTK: on all cores, each array straight to where it is handed over.
// Takes files as VTK, ParaView and meshio write them: little endian, appended or inline data as they are, in base64 or
// compressed, linear cells, nothing hidden. All else it leaves to VTK, also what is damaged: nothing, and nothing
// written. layers: those of a lattice that are wanted; none: all.
std::optional<QuickBlock> readQuickly(const std::string& file, const ArrayWish& wish, int threads, ArrayWriter& arrays,
                                      ArrayWriter& cells, const std::optional<CellLayers>& layers = {});
