#include "lattice_sets.h"

#include "lattice_cells.h"

namespace vp::test
{

namespace
{

// Columns of wedges among hexahedra, pyramids and polyhedra: they share quads.
RawSet mixedCells(Draw& draw, const Disorder& disorder, const LatticeSize& size)
{
	RawBlock block = lattice(draw, disorder, size);
	std::vector<bool> wedges;
	for (std::uint32_t column = 0; column < block.points_along[0] * block.points_along[1]; ++column)
		wedges.push_back(draw.chance(0.3));
	toCells(block,
	        [&](int i, int j, int, const Ids& c)
	        {
		        if (wedges[j * block.points_along[0] + i])
			        return addWedges(block, c);
		        switch (draw.whole(0, 2))
		        {
		        case 0:
			        return addHexahedron(block, c);
		        case 1:
			        return addPyramids(block, c);
		        default:
			        return addPolyhedron(block, c, draw);
		        }
	        });
	return {"mixed cells", {block}};
}

// Pairs of lattice cells along i in one polyhedron of ten faces.
RawSet doublePolyhedra(Draw& draw, const Disorder& disorder, const LatticeSize& size)
{
	RawBlock block = lattice(draw, disorder, size);
	const int along = static_cast<int>(block.points_along[0]) - 1;
	toCells(block,
	        [&](int i, int j, int k, const Ids& c)
	        {
		        if (i % 2 == 0 && i + 1 == along)
			        return addHexahedron(block, c);
		        if (i % 2 == 1)
			        return;
		        std::vector<Ids> faces = facesOf(c);
		        std::vector<Ids> more = facesOf(cornersAt(block, i + 1, j, k));
		        faces.erase(faces.begin() + 1);
		        more.erase(more.begin());
		        faces.insert(faces.end(), more.begin(), more.end());
		        addPolyhedron(block, std::move(faces));
	        });
	return {"double polyhedra", {block}};
}

// A wall of bricks: each has six neighbors in its layer, its top and bottom are hexagons.
RawSet hexagonalPolyhedra(Draw& draw, const Disorder& disorder, const LatticeSize& size)
{
	RawBlock block = lattice(draw, disorder, size);
	const auto [ni, nj, nk] = block.points_along;
	for (int k = 0; k + 1 < int(nk); ++k)
		for (int j = 0; j + 1 < int(nj); ++j)
			for (int i = j % 2; i + 2 < int(ni); i += 2)
			{
				Ids ring;
				for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}})
					ring.push_back(pointAt(block, i + di, j + dj, k));
				const std::int64_t layer = std::int64_t(ni) * nj;
				std::vector<Ids> faces(2);
				for (std::size_t n = 0; n < 6; ++n)
				{
					const std::int64_t a = ring[n];
					const std::int64_t b = ring[(n + 1) % 6];
					faces[0].insert(faces[0].begin(), a);
					faces[1].push_back(a + layer);
					faces.push_back({a, b, b + layer, a + layer});
				}
				addPolyhedron(block, std::move(faces));
			}
	block.kind = RawKind::cells;
	return {"hexagonal polyhedra", {block}};
}

RawSet oneShape(LatticeKind kind, Draw& draw, const Disorder& disorder, const LatticeSize& size)
{
	RawBlock block = lattice(draw, disorder, size);
	toCells(block,
	        [&](int, int, int, const Ids& c)
	        {
		        switch (kind)
		        {
		        case LatticeKind::wedges:
			        return addWedges(block, c);
		        case LatticeKind::tetrahedra:
			        return addTetrahedra(block, c);
		        case LatticeKind::pyramids:
			        return addPyramids(block, c);
		        case LatticeKind::polyhedra:
			        return addPolyhedron(block, c, draw);
		        default:
			        return addHexahedron(block, c);
		        }
	        });
	return {"one shape", {block}};
}

// Cells missing anywhere: holes, cells that hang by an edge or a point.
RawSet blankedCells(Draw& draw, const Disorder& disorder, const LatticeSize& size)
{
	RawBlock block = lattice(draw, disorder, size);
	const double kept = draw.real(0.3, 0.95);
	toCells(block,
	        [&](int, int, int, const Ids& c)
	        {
		        if (draw.chance(kept))
			        addHexahedron(block, c);
	        });
	if (block.cells.empty())
		addHexahedron(block, cornersAt(block, 0, 0, 0));
	return {"blanked cells", {block}};
}

// Corners drawn together: by number, by place, or onto a line.
RawSet degenerateCells(Draw& draw, const LatticeSize& size)
{
	RawBlock block = lattice(draw, {0.2}, size);
	std::vector<Vec3>& points = block.points;
	const int moves = draw.whole(1, 6);
	for (int n = 0; n < moves; ++n)
	{
		const auto at = static_cast<std::size_t>(draw.whole(0, static_cast<int>(points.size()) - 2));
		points[at] = draw.chance(0.7) ? points[at + 1] : 0.5 * (points[at + 1] + points[at ? at - 1 : at + 1]);
	}
	const bool by_number = draw.chance(0.5);
	if (by_number || draw.chance(0.5))
		toCells(block,
		        [&](int, int, int, Ids c)
		        {
			        for (std::int64_t& id : c)
				        if (by_number && std::size_t(id) + 1 < points.size() && points[id] == points[id + 1])
					        ++id;
			        addHexahedron(block, c);
		        });
	return {"degenerate cells", {block}, true, false, true};
}

// A ring that meets itself at i = 0, perhaps with its inner side drawn to an axis.
RawSet closedRing(Draw& draw, const LatticeSize& size)
{
	RawBlock block = lattice(draw, {}, {std::max(3, size.least), size.most});
	const double inner = draw.chance(0.5) ? 0.0 : draw.real(0.2, 2.0);
	const double around = 2.0 * std::numbers::pi / (block.points_along[0] - 1);
	for (Vec3& p : block.points)
	{
		const double radius = inner + p.y;
		p = {radius * std::cos(around * p.x), -radius * std::sin(around * p.x), p.z};
	}
	return {"closed ring", {block}, true, true, inner == 0.0};
}

RawSet plainLattice(Draw& draw, const LatticeSize& size)
{
	RawBlock block = lattice(draw, {}, size);
	const bool image = draw.chance(0.5);
	block.kind = image ? RawKind::image : RawKind::rectilinear;
	const double power = image ? 1.0 : draw.real(0.5, 3.0);
	const Vec3 growth(power, 0.5 * (power + 1.0), 1.0);
	for (Vec3& p : block.points)
		p = glm::pow(p, growth);
	return {image ? "image" : "rectilinear", {block}, true, true};
}

// Two lattices that abut along i with equal, shifted or overlapping layers.
RawSet severalBlocks(Draw& draw, const LatticeSize& size)
{
	RawBlock first = lattice(draw, {0.2}, size);
	RawBlock second = first;
	const double width = first.points_along[0] - 1.0;
	const auto ni = first.points_along[0];
	const int meeting = draw.whole(0, 2);
	for (std::size_t p = 0; p < first.points.size(); ++p)
	{
		second.points[p].x += meeting == 1 ? width - 0.7 : width;
		// The last layer of the first is the first of the second.
		if (meeting == 0 && p % ni == 0)
			second.points[p] = first.points[p + ni - 1];
	}
	if (draw.chance(0.5))
		second = asHexahedra(second);
	return {"several blocks", {first, second}, meeting == 0};
}

} // namespace

RawBlock asHexahedra(RawBlock lattice)
{
	toCells(lattice, [&](int, int, int, const Ids& c) { addHexahedron(lattice, c); });
	return lattice;
}

RawSet latticeSet(LatticeKind kind, Draw& draw, const Disorder& disorder, const LatticeSize& size)
{
	switch (kind)
	{
	case LatticeKind::plain:
		return plainLattice(draw, size);
	case LatticeKind::ring:
		return closedRing(draw, size);
	case LatticeKind::degenerate:
		return degenerateCells(draw, size);
	case LatticeKind::blocks:
		return severalBlocks(draw, size);
	case LatticeKind::curvilinear:
		return {"curvilinear", {lattice(draw, disorder, size)}};
	case LatticeKind::blanked:
		return blankedCells(draw, disorder, size);
	case LatticeKind::mixed:
		return mixedCells(draw, disorder, size);
	case LatticeKind::doubles:
		return doublePolyhedra(draw, disorder, size);
	case LatticeKind::hexagonal:
		return hexagonalPolyhedra(draw, disorder, size);
	default:
		return oneShape(kind, draw, disorder, size);
	}
}

} // namespace vp::test
