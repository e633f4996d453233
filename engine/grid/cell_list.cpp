#include "grid/cell_list.h"

#include "base/parallel_for.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <type_traits>

namespace vp::grid
{

namespace
{

/// Returns a negative number if the id names no point. last: the greatest id that names one. The sign bit tells, since
/// many machines cannot compare several 64-bit numbers at a time. The difference wraps if the id is negative, but then
/// the id's own sign bit tells.
template <class Id>
Id signOf(Id id, Id last)
{
	using Bits = std::make_unsigned_t<Id>;
	return static_cast<Id>((static_cast<Bits>(last) - static_cast<Bits>(id)) | static_cast<Bits>(id));
}

} // namespace

void checkIds(const IdArray& all, std::size_t points)
{
	constexpr std::size_t kGrain = 1 << 16;
	const auto check = [&]<class Id>(std::span<const Id> ids)
	{
		constexpr auto kMaxId = static_cast<std::size_t>(std::numeric_limits<Id>::max());
		const auto last = static_cast<Id>(points > kMaxId ? kMaxId : points - 1); // -1 without points
		std::atomic<bool> fits = true;
		parallelFor(tbb::blocked_range<std::size_t>(0, ids.size(), kGrain),
		            [&, last](const tbb::blocked_range<std::size_t>& range)
		            {
			            Id signs = 0;
			            for (std::size_t i = range.begin(); i < range.end(); ++i)
				            signs |= signOf(ids[i], last);
			            if (signs < 0)
				            fits = false;
		            });
		if (fits)
			return;
		const auto bad = std::ranges::find_if(ids, [&](Id id) { return signOf(id, last) < 0; });
		throw WrongPoint(fmt::format("a cell lists point {} of {}", *bad, points));
	};
	all.as(check);
}

int vtkDimension(std::uint8_t vtk_type)
{
	// By VTK's cell type number; 9: no such type.
	static constexpr char dimension[] = "0001122222" // 0: empty, vertices, lines, triangle, strip, polygon, pixel, quad
	                                    "3333333999" // 10: tetrahedron … hexagonal prism
	                                    "9122333323" // 20: quadratic edge, triangle, quad, tetrahedron …
	                                    "2333212399" // 30: … cubic line, quadratic polygon, triquadratic pyramid
	                                    "9339999999" // 40: convex point set, polyhedron
	                                    "9122233999" // 50: parametric
	                                    "1222333312" // 60: higher order; Lagrange from 68
	                                    "2333312233" // 70: Bezier from 75
	                                    "33";
	if (vtk_type >= sizeof(dimension) - 1 || dimension[vtk_type] == '9')
		return -1;
	return dimension[vtk_type] - '0';
}

bool isSliceable(std::uint8_t vtk_type)
{
	return (vtk_type >= 10 && vtk_type <= 14) || vtk_type == 42;
}

} // namespace vp::grid
