#pragma once

#include "grid/field_choice.h"
#include "vectors/lattice.h"
#include "vectors/particle.h"

#include <cstdint>

namespace vp::app
{

enum class TraceKind : std::uint8_t
{
	tufts,
	lines,
	ribbons,
	tubes
};

// What is launched from the sheets of a session.
struct VectorChoice
{
	TraceKind kind = TraceKind::tufts;
	vectors::LatticeChoice lattice;
	double steps = 1.0;
	double dt = 1.0;      // of a step
	double spacing = 1.0; // about how far the lattice's points are apart, in the grid's units: for widths
	vectors::Direction direction = vectors::Direction::forward;
	vectors::VectorPart part = vectors::VectorPart::whole;
	bool own_dt = false; // the step was not given
};

} // namespace vp::app
