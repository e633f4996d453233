#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "vectors/lattice.h"
#include "vectors/particle.h"
#include "vectors/traces.h"

#include <span>
#include <stop_token>

namespace vp::vectors
{

struct TraceOptions
{
	double steps = 1.0; // 0 or more; a fraction means a part of a step at the end
	double dt = 0.0;    // > 0, in units of length over those of the vectors
	Direction direction = Direction::forward;
	VectorPart part = VectorPart::whole;
	Vec3 normal{0.0, 0.0, 1.0}; // unit normal of the sheet
	// Allowed error of a substep, in the coordinates of the cell. It determines the number of substeps in a step.
	double tolerance = 1e-5;
};

// Limit for all traces together. A point takes some 140 bytes while traces are made.
constexpr double kMaxTracePoints = 1e8;

// Usage errors: dt not positive or not finite, steps negative or not finite, more points than kMaxTracePoints.
Status checkOptions(const TraceOptions& options, std::size_t launches);

// Moves particles from the launches along the vectors of an array (chooseVectors()), with a point every dt. Vectors of
// points are interpolated by the shape functions of the cells (locate/cell_polynomial.h). Vectors of cells are constant
// in each cell. Particles go from block to block where faces meet (grid::Interfaces), and if another cell lies within
// kBeyond of a cell behind the boundary. Traces have the order of the launches. It runs on all cores, with the same
// result for any number of threads. On a stop request it ends with ErrorKind::cancelled.
Result<Traces> trace(const grid::BlockSet& blocks, const grid::FieldChoice& array, std::span<const Launch> launches,
                     const TraceOptions& options, std::stop_token stop = {});

constexpr double kBeyond = 0.02; // share of a cell

} // namespace vp::vectors
