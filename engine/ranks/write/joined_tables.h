#pragma once

#include "base/result.h"
#include "ranks/ranks.h"
#include "vectors/traces.h"
#include "write/slice_table.h"

#include <span>
#include <string>

namespace vp::ranks
{

/// Returns an error if several ranks cannot write polygons to a file of this name. To be called before long work.
Status canWrite(const Ranks& ranks, const std::string& path);

/// Returns the polygons of some sheets and contours as one table. The first of several ranks gets those of all, in the
/// order of writeSlice(), and the others a part.
write::SliceTable tabulate(const Ranks& ranks, const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> sheets,
                           std::span<const write::ContourPiece> contours);

/// Returns the rows of all ranks at the first one. table: the rows that this process has.
write::SliceTable gathered(const Ranks& ranks, write::SliceTable table);

/// As write::writeSlice(). As .pvtp, each of several ranks writes a part of its own; any other file, the first one
/// writes. Polygons come sheet by sheet there, and within a sheet by ranks; contours behind them in the same way.
Status writeSlice(const Ranks& ranks, const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> sheets,
                  const std::string& path, std::span<const write::ContourPiece> contours);

/// As write::writeTraces(), at the first rank. Each row comes from the rank that has the point's cell.
Status writeTraces(const Ranks& ranks, const grid::BlockSet& blocks, std::span<const vectors::Traces> traces,
                   const std::string& path);

} // namespace vp::ranks
