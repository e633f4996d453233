#include "pack_checks.h"

#include "read/check_mesh.h"
#include "vprobe-read/base/refusal.h"

#include <algorithm>
#include <cstddef>

namespace vp::reader::vtk
{

namespace
{

template <class Number>
void refusePlacesOutside(std::span<const std::int32_t> ids, const Number* places, const std::array<double, 6>& box)
{
	if (box[0] > box[3])
		return; // cells that nobody sees
	bool is_outside = false;
	for (const std::int32_t id : ids)
		for (std::size_t axis = 0; axis < 3; ++axis)
		{
			const double at = places[3 * static_cast<std::size_t>(id) + axis];
			is_outside |= (at < box[axis] || at > box[axis + 3]) && read::isPlace(at);
		}
	if (is_outside)
		throw damaged("a point lies outside the box of its cells; pack the file again");
}

} // namespace

void refuseWrongIds(std::span<const std::int32_t> ids, std::uint64_t first, std::size_t points)
{
	std::uint32_t largest = 0; // an id below the first becomes a large number
	for (const std::int32_t id : ids)
		largest = std::max(largest, static_cast<std::uint32_t>(id) - static_cast<std::uint32_t>(first));
	if (!ids.empty() && largest >= points)
		throw damaged("a cell has a point that is not there");
}

void refuseOutside(std::span<const std::int32_t> ids, const float* places, const std::array<double, 6>& box)
{
	refusePlacesOutside(ids, places, box);
}

void refuseOutside(std::span<const std::int32_t> ids, const double* places, const std::array<double, 6>& box)
{
	refusePlacesOutside(ids, places, box);
}

void refuseWrongEnds(std::span<const std::int32_t> ends, std::uint64_t ids)
{
	if (ends.front() < 0 || !std::ranges::is_sorted(ends) ||
	    static_cast<std::uint64_t>(ends.back() - ends.front()) != ids)
		throw damaged("the Offsets of a part do not match it");
}

} // namespace vp::reader::vtk
