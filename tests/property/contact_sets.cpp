#include "contact_sets.h"

#include "lattice_cells.h"

#include <cmath>

namespace vp::test
{

namespace
{

using Counts = std::array<std::uint32_t, 3>;

template <class Place>
RawBlock blockOf(RawKind kind, const Counts& points, Place&& place)
{
	RawBlock block;
	block.kind = kind;
	block.points_along = points;
	for (std::uint32_t k = 0; k < points[2]; ++k)
		for (std::uint32_t j = 0; j < points[1]; ++j)
			for (std::uint32_t i = 0; i < points[0]; ++i)
				block.points.push_back(place(i, j, k));
	return block;
}

// Each cell with points that no other has.
RawBlock unmerged(RawBlock block)
{
	std::vector<Vec3> points;
	for (RawCell& cell : block.cells)
		for (std::int64_t& id : cell.ids)
		{
			points.push_back(block.points[static_cast<std::size_t>(id)]);
			id = static_cast<std::int64_t>(points.size() - 1);
		}
	block.points = std::move(points);
	return block;
}

RawBlock asCells(RawBlock block, Draw& draw)
{
	if (draw.chance(0.6))
		block = asHexahedra(block);
	else
		toCells(block, [&](int, int, int, const Ids& c) { addTetrahedra(block, c); });
	return draw.chance(0.4) ? unmerged(block) : block;
}

RawBlock together(RawBlock first, const RawBlock& second)
{
	const auto before = static_cast<std::int64_t>(first.points.size());
	first.points.insert(first.points.end(), second.points.begin(), second.points.end());
	for (RawCell cell : second.cells)
	{
		for (std::int64_t& id : cell.ids)
			id += before;
		first.cells.push_back(std::move(cell));
	}
	return first;
}

// Lattices along the axes, the first with cells of a side of 1.
RawSet straightContact(Draw& draw, const Counts& cells, std::uint32_t parts)
{
	const RawKind kind = draw.chance(0.5) ? RawKind::image : RawKind::rectilinear;
	const double step = 1.0 / parts;
	const auto points = [](Counts c) { return Counts{c[0] + 1, c[1] + 1, c[2] + 1}; };
	return {"straight contact",
	        {blockOf(kind, points(cells), [](int i, int j, int k) { return Vec3(i, j, k); }),
	         blockOf(kind, points({2, parts * cells[1], parts * cells[2]}),
	                 [&](int i, int j, int k) { return Vec3(cells[0] + i * step, j * step, k * step); })}};
}

// The points of the second lattice on the layer lie on the bilinear faces of the first.
RawSet bentContact(Draw& draw, const Counts& cells, std::uint32_t parts)
{
	const double warp = draw.chance(0.5) ? 0.1 : 0.0;
	const Counts points{cells[0] + 1, cells[1] + 1, cells[2] + 1};
	RawBlock large = blockOf(RawKind::curvilinear, points,
	                         [&](std::uint32_t i, int j, int k)
	                         {
		                         Vec3 moved = draw.around(0.15);
		                         if (i == cells[0])
			                         moved.x = draw.real(-warp, warp);
		                         return Vec3(i, j, k) + moved;
	                         });
	const auto onLayer = [&](std::uint32_t j, std::uint32_t k)
	{
		const std::uint32_t low_j = std::min(j / parts, cells[1] - 1);
		const std::uint32_t low_k = std::min(k / parts, cells[2] - 1);
		const double v = (j - low_j * parts) / double(parts);
		const double w = (k - low_k * parts) / double(parts);
		const auto at = [&](std::uint32_t dj, std::uint32_t dk)
		{ return large.points[((low_k + dk) * points[1] + low_j + dj) * points[0] + cells[0]]; };
		return (1.0 - w) * ((1.0 - v) * at(0, 0) + v * at(1, 0)) + w * ((1.0 - v) * at(0, 1) + v * at(1, 1));
	};
	RawBlock small = blockOf(RawKind::curvilinear, {3, parts * cells[1] + 1, parts * cells[2] + 1},
	                         [&](int i, std::uint32_t j, std::uint32_t k) {
		                         return onLayer(j, k) + Vec3(i * 0.7, 0.0, 0.0) + double(i) * draw.around(0.1 / parts);
	                         });
	if (draw.chance(0.3))
		return {"bent contact", {large, small}};
	if (draw.chance(0.3))
		return {"bent contact of a lattice", {large, asCells(small, draw)}};
	large = asCells(large, draw);
	small = asCells(small, draw);
	if (draw.chance(0.5))
		return {"bent contact of cells", {large, small}};
	return {"bent contact in one block", {together(large, small)}};
}

} // namespace

RawSet contactSet(unsigned seed)
{
	Draw draw(seed);
	const auto most = [&] { return static_cast<std::uint32_t>(draw.whole(1, 2)); };
	const Counts cells{most(), most(), most()};
	const auto parts = static_cast<std::uint32_t>(draw.whole(1, 3));
	RawSet set = draw.chance(0.3) ? straightContact(draw, cells, parts) : bentContact(draw, cells, parts);
	set.conforming = false;
	return set;
}

} // namespace vp::test
