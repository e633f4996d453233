#pragma once

#include "write/atomic_file.h"
#include "write/slice_table.h"

namespace vp::write
{

// One a format; failures of the file are its commit()'s to tell.
void writeVtp(const SliceTable& table, AtomicFile& file);
void writePly(const SliceTable& table, AtomicFile& file);
void writeCsv(const SliceTable& table, AtomicFile& file);

} // namespace vp::write
