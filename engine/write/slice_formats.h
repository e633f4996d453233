#pragma once

#include "write/atomic_file.h"
#include "write/poly_data.h"
#include "write/slice_table.h"

namespace vp::write
{

// One a format; failures of the file are its commit()'s to tell.
void writeVtp(const SliceTable& table, AtomicFile& file);
void writePly(const SliceTable& table, AtomicFile& file);
void writeCsv(const SliceTable& table, AtomicFile& file);

// Returns the content of a .vtp file of the table. It refers to the table's memory.
PolyData polyDataOf(const SliceTable& table);

} // namespace vp::write
