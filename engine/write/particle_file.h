#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "vectors/traces.h"
#include "write/slice_table.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vp::write
{

// Traces as VTK's XML poly data (.vtp), a line each, or a vertex where it is one point. Points carry vprobe:time (since
// the launch), vprobe:vector, vprobe:block, vprobe:cell (as the file numbers them, from 0) and all point arrays,
// interpolated in the cell as writeSamples() does. Both carry vprobe:sheet, vprobe:seed (its place in the sheet's
// lattice), vprobe:begin and vprobe:end: why it goes on no farther, as a number into the field data's words
// "vprobe:ends". traces[i] are sheet i's. "-" is standard output.
Status writeTraces(const grid::BlockSet& blocks, std::span<const vectors::Traces> traces, const std::string& path);

// The columns of a file at the points of a sheet's traces, from the cells that contain the points. Each of several
// processes finds the rows of points in its own blocks.
struct TraceColumns
{
	std::vector<Column> arrays; // the same for all sheets
	std::vector<std::int32_t> block;
	std::vector<std::int64_t> cell; // source id, -1 outside
};
TraceColumns traceColumns(const grid::BlockSet& blocks, const vectors::Traces& traces);

// The same file. columns[i]: of traces[i].
Status writeTraces(std::span<const vectors::Traces> traces, std::span<const TraceColumns> columns,
                   const std::string& path);

} // namespace vp::write
