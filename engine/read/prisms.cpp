#include "read/prisms.h"

#include "read/cell_types.h"
#include "read/check_mesh.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::read
{

namespace
{

std::vector<std::int64_t> pointsOfPrism(const grid::CellList& cells, std::size_t cell)
{
	const auto sides = static_cast<std::size_t>(prismSides(cells.types[cell]));
	const std::int64_t begin = cells.offsets[cell];
	const std::int64_t end = cells.offsets[cell + 1];
	if (begin < 0 || end < begin || static_cast<std::size_t>(end) > cells.connectivity.size())
		throw Unusable("the cell offsets do not match what they point into");
	if (static_cast<std::size_t>(end - begin) < 2 * sides)
		throw Unusable(fmt::format("cell {}, a prism of {} sides, lists {} points", cell, sides, end - begin));
	std::vector<std::int64_t> points;
	for (std::size_t i = 0; i < 2 * sides; ++i)
		points.push_back(cells.connectivity[static_cast<std::size_t>(begin) + i]);
	return points;
}

} // namespace

void rewritePrisms(grid::CellList& cells)
{
	const auto is_prism = [](std::uint8_t type) { return prismSides(type) > 0; };
	if (std::ranges::none_of(cells.types.span(), is_prism))
		return;
	const bool has_faces = !cells.face_offsets.empty();
	std::vector<std::uint8_t> types(cells.types.data(), cells.types.data() + cells.size());
	std::vector<std::int64_t> face_offsets{0};
	std::vector<std::int64_t> stream;
	for (std::size_t c = 0; c < types.size(); ++c)
	{
		if (is_prism(types[c]))
		{
			const std::vector<std::int64_t> points = pointsOfPrism(cells, c);
			const std::vector<std::int64_t> faces = prismFaces(std::span<const std::int64_t>(points));
			stream.insert(stream.end(), faces.begin(), faces.end());
			types[c] = kPolyhedron;
		}
		else if (types[c] == kPolyhedron && has_faces)
		{
			const std::int64_t begin = cells.face_offsets[c];
			const std::int64_t end = cells.face_offsets[c + 1];
			if (begin < 0 || end < begin || static_cast<std::size_t>(end) > cells.face_stream.size())
				throw Unusable("the face offsets do not match what they point into");
			stream.insert(stream.end(), cells.face_stream.data() + begin, cells.face_stream.data() + end);
		}
		face_offsets.push_back(static_cast<std::int64_t>(stream.size()));
	}
	cells.types = Array(std::move(types));
	cells.face_offsets = Array(std::move(face_offsets));
	cells.face_stream = Array(std::move(stream));
}

} // namespace vp::read
