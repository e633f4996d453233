#pragma once

#include <vprobe/dataset.h>

#include <pybind11/pybind11.h>

#include <vector>

namespace binding
{

namespace py = pybind11;

// Blocks from Python: a list of dictionaries with `kind`, the arrays of that kind, and `fields`, a list of
// (name, "point" or "cell", components, array, units). A block with `checks_ids_later` leaves its ids to the first cut.
std::vector<vprobe::Block> blocksOf(const py::list& blocks);

// The fields of each block, as above.
std::vector<vprobe::Field> fieldsOf(const py::list& fields);

} // namespace binding
