#pragma once

#include "grid/grid.h"
#include "surface/curved.h"

#include <algorithm>
#include <array>
#include <span>

namespace vp::seed
{

// The places where a surface crosses the edges of a face, in coordinates of N axes: those of a window or of a box.
template <int N>
struct FaceCuts
{
	using Place = glm::vec<N, double>;
	static constexpr int kMax = 16; // if a face is cut more often, only these cuts count

	std::array<Place, kMax> at;
	int count = 0;
};

// To the last bit the same seen from either of the face's cells. place(point) gives the coordinates. False where the
// surface crosses none.
template <int N, class G, class Surface, class ToPlace>
bool findCuts(const G& grid, const Surface& surface, std::span<const PointId> face, const ToPlace& place,
              FaceCuts<N>& cuts)
{
	struct Corner
	{
		PointId id;
		Vec3 place;
		double distance;
	};
	const auto cornerAt = [&](PointId p)
	{
		const Vec3 at = grid.point(p);
		return Corner{p, at, surface::heightAt(grid, surface, p)};
	};
	cuts.count = 0;
	Corner previous = cornerAt(face.back());
	for (const PointId p : face)
	{
		const Corner corner = cornerAt(p);
		if ((corner.distance >= 0.0) != (previous.distance >= 0.0) && cuts.count < FaceCuts<N>::kMax)
		{
			const Corner& low = previous.id < p ? previous : corner;
			const Corner& high = previous.id < p ? corner : previous;
			cuts.at[cuts.count++] =
			    place(low.place + surface::crossingOf(surface, low.place, high.place, low.distance, high.distance) *
			                          (high.place - low.place));
		}
		previous = corner;
	}
	return cuts.count > 0;
}

// Returns true if a segment reaches into [lo, hi], its rim included. Uses the method of Liang and Barsky: a part of the
// segment must be left between each pair of sides.
template <int N>
bool reachesInto(const glm::vec<N, double>& from, const glm::vec<N, double>& to, const glm::vec<N, double>& lo,
                 const glm::vec<N, double>& hi)
{
	double first = 0.0;
	double last = 1.0;
	for (int axis = 0; axis < N; ++axis)
	{
		const double along = to[axis] - from[axis];
		const double to_lo = lo[axis] - from[axis];
		const double to_hi = hi[axis] - from[axis];
		if (along == 0.0)
		{
			if (to_lo > 0.0 || to_hi < 0.0)
				return false;
			continue;
		}
		const double a = to_lo / along;
		const double b = to_hi / along;
		first = std::max(first, std::min(a, b));
		last = std::min(last, std::max(a, b));
	}
	return first <= last;
}

// Any two cuts count as joined: of a twisted face, cut more than twice, nothing is lost so.
template <int N>
bool anyReaches(const FaceCuts<N>& cuts, const glm::vec<N, double>& lo, const glm::vec<N, double>& hi)
{
	for (int i = 0; i + 1 < cuts.count; ++i)
		for (int j = i + 1; j < cuts.count; ++j)
			if (reachesInto(cuts.at[i], cuts.at[j], lo, hi))
				return true;
	return false;
}

} // namespace vp::seed
