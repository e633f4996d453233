#pragma once

#include "vectors/traces.h"

#include <cmath>

namespace vp::test
{

// The path of v = (-y, x, 0.3) through (radius, 0, 0).
inline Vec3 onHelix(double radius, double time)
{
	return {radius * std::cos(time), radius * std::sin(time), 0.3 * time};
}

// Adds one of so many steps before its launch and after it, step apart in time; of block 0, cell 0.
inline void addHelix(vectors::Traces& traces, double radius, double step, int before, int after)
{
	traces.seeds.push_back(static_cast<std::uint32_t>(traces.count()));
	traces.launches.push_back(traces.starts.back() + static_cast<std::uint32_t>(before));
	traces.begins.push_back(vectors::TraceEnd::steps);
	traces.ends.push_back(vectors::TraceEnd::steps);
	for (int i = -before; i <= after; ++i)
	{
		const Vec3 at = onHelix(radius, i * step);
		traces.points.push_back(at);
		traces.times.push_back(i * step);
		traces.vectors.emplace_back(-at.y, at.x, 0.3);
		traces.blocks.push_back(0);
		traces.cells.push_back(0);
	}
	traces.starts.push_back(static_cast<std::uint32_t>(traces.points.size()));
}

} // namespace vp::test
