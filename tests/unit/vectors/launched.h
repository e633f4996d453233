#pragma once

#include "grid/demo/demo.h"
#include "locate/find_cell.h"
#include "locate/interpolate.h"
#include "sliced_sheet.h"
#include "test_grids.h"
#include "vectors/tracer.h"
#include "vectors/vector_array.h"

#include <string>

namespace vp::test
{

constexpr TestPlane kAskew{{0.3, 0.9, 0.1}, {0.3, 0.5, 0.81}};

inline vectors::TraceOptions forTime(double steps, double dt,
                                     vectors::Direction direction = vectors::Direction::forward)
{
	vectors::TraceOptions options;
	options.steps = steps;
	options.dt = dt;
	options.direction = direction;
	return options;
}

inline grid::BlockSet demo(const std::string& name, int n)
{
	return std::move(*grid::makeDemo(name, n));
}

// From the cut of a plane, without a window.
inline vectors::SheetLattice latticeOn(const grid::BlockSet& blocks, const TestPlane& plane,
                                       const vectors::LatticeChoice& choice = {})
{
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, plane);
	return vectors::launchLattice(sheet.mesh, sheet.slice.sheet, choice);
}

inline vectors::Traces traced(const grid::BlockSet& blocks, std::span<const vectors::Launch> launches,
                              const vectors::TraceOptions& options, const std::string& array = "")
{
	const grid::FieldChoice choice = vectors::chooseVectors(blocks, array).value();
	return std::move(vectors::trace(blocks, choice, launches, options).value());
}

// Returns the place to which the demos' vector (-y, x, 0.3) takes a place.
inline Vec3 alongHelix(const Vec3& from, double time)
{
	return {from.x * std::cos(time) - from.y * std::sin(time), from.x * std::sin(time) + from.y * std::cos(time),
	        from.z + 0.3 * time};
}

} // namespace vp::test
