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
	double steps = 1.0; // 0 or more; a fraction ends in a part of a step
	double dt = 0.0;    // > 0, in units of length over those of the vectors
	Direction direction = Direction::forward;
	VectorPart part = VectorPart::whole;
	Vec3 normal{0.0, 0.0, 1.0}; // of the sheet, unit
	// Error of a substep, in the coordinates of the cell; there are as many substeps in a step as it asks for.
	double tolerance = 1e-5;
};

// Of all traces; they take some 140 bytes each while they are made.
constexpr double kMaxTracePoints = 1e8;

// Usage errors: dt not positive or not finite, steps negative or not finite, more points than kMaxTracePoints.
Status checkOptions(const TraceOptions& options, std::size_t launches);

// Particles from the launches along the vectors of an array (chooseVectors()), with a point every dt. Between points of
// the grid vectors are interpolated by the cells' shape functions (locate/cell_polynomial.h); vectors of cells are
// constant in each. Particles cross from block to block where faces meet (grid::Interfaces), and where another cell
// lies within kBeyond of a cell behind the boundary. Traces come in the launches' order, the same for any number of
// threads. On all cores. Asked to stop it ends with ErrorKind::cancelled.
Result<Traces> trace(const grid::BlockSet& blocks, const grid::FieldChoice& array, std::span<const Launch> launches,
                     const TraceOptions& options, std::stop_token stop = {});

constexpr double kBeyond = 0.02; // of a cell

} // namespace vp::vectors
