#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "vectors/traces.h"

#include <span>
#include <string>

namespace vp::write
{

// Traces as VTK's XML poly data (.vtp), a line each, or a vertex where it is one point. Points carry vprobe:time (since
// the launch), vprobe:vector, vprobe:block, vprobe:cell (as the file numbers them, from 0) and all point arrays,
// interpolated in the cell as writeSamples() does. Both carry vprobe:sheet, vprobe:seed (its place in the sheet's
// lattice), vprobe:begin and vprobe:end: why it goes on no farther, as a number into the field data's words
// "vprobe:ends". traces[i] are sheet i's. "-" is standard output.
Status writeTraces(const grid::BlockSet& blocks, std::span<const vectors::Traces> traces, const std::string& path);

} // namespace vp::write
