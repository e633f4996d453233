#pragma once

#include "session/session.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vp::session
{

/// Values and places that the inputs have at several of their times, for colors and a camera that serve all of them.
struct TimesSeen
{
	struct Array
	{
		grid::FieldChoice field;
		grid::ValueSpan span{};
		double least_positive = 0.0; // 0: no value is above 0
	};

	std::vector<Array> arrays;
	Box bounds; // around all of these grids, if one has other bounds than the session; otherwise empty

	const Array* of(const grid::FieldChoice& field) const; // null if nobody asked for it
};

/// Reads the inputs at some times, given as indices of BlockSet::times, one after the other. Nothing of the session
/// changes. Where a grid is the same, only values are read. All ranks call this together.
Result<TimesSeen> lookAtTimes(const Session& session, std::span<const std::size_t> steps,
                              std::span<const grid::FieldChoice> fields);

/// Returns the first, the middle and the last of so many times.
std::vector<std::size_t> firstMiddleAndLast(std::size_t times);

} // namespace vp::session
