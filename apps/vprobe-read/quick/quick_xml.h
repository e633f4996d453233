#pragma once

#include "vprobe-read/arrays/array_writer.h"
#include "vprobe-read/base/array_wish.h"
#include "vprobe-read/base/part_filter.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::quick
{

// A block of the manifest without its name.
struct Block
{
	nlohmann::json block;
	std::size_t flat = 0;      // cells of dimension below three
	std::vector<double> times; // that the file names: none or one
};

// Reads a .vti, .vtr, .vts or .vtu file without VTK: on all cores, each array directly to its place in the shared
// memory. It supports files as VTK, ParaView and meshio write them: little endian; appended or inline data, raw, in
// base64 or compressed; linear cells; no hidden cells. Everything else, damaged files too, is left to VTK: then this
// returns nothing and writes nothing. layers: the wanted layers of a lattice; without a value, all layers. stays_above:
// arrays of images and rectilinear grids of more bytes stay in the file where they are not packed.
std::optional<Block> readQuickly(const std::string& file, const ArrayWish& wish, int threads, arrays::Writer& arrays,
                                 arrays::Writer& cells, const std::optional<CellLayers>& layers = {},
                                 std::uint64_t stays_above = ~std::uint64_t(0));

} // namespace vp::reader::quick
