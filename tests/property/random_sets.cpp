#include "random_sets.h"

#include <functional>

namespace vp::test
{

namespace
{

using Ids = std::vector<std::int64_t>;

enum VtkType : std::uint8_t
{
	kTetra = 10,
	kHexahedron = 12,
	kWedge = 13,
	kPyramid = 14,
	kPolyhedron = 42
};

// Draws numbers by name of their range.
class Draw
{
public:
	explicit Draw(unsigned seed) : random_(seed) {}

	double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
	int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
	bool chance(double probability) { return real(0.0, 1.0) < probability; }
	Vec3 around(double reach)
	{
		const double x = real(-reach, reach);
		const double y = real(-reach, reach);
		return {x, y, real(-reach, reach)};
	}
	Vec3 direction() { return randomDirection(random_); }

private:
	std::mt19937 random_;
};

// How far from a lattice the points lie: all of them, and a few that fold the cells about them.
struct Disorder
{
	double jitter = 0.0;
	int bumps = 0;
	double bump = 0.0;
};

// Points of a lattice at whole numbers, moved.
RawBlock lattice(Draw& draw, const Disorder& disorder, int least = 2, int most = 6)
{
	RawBlock block;
	block.kind = RawKind::curvilinear;
	for (std::uint32_t& n : block.points_along)
		n = static_cast<std::uint32_t>(draw.whole(least, most)) + 1;
	const auto [ni, nj, nk] = block.points_along;
	for (std::uint32_t k = 0; k < nk; ++k)
		for (std::uint32_t j = 0; j < nj; ++j)
			for (std::uint32_t i = 0; i < ni; ++i)
				block.points.push_back(Vec3(i, j, k) + draw.around(disorder.jitter));
	for (int n = 0; n < disorder.bumps; ++n)
		block.points[draw.whole(0, static_cast<int>(block.points.size()) - 1)] += disorder.bump * draw.direction();
	return block;
}

std::int64_t pointAt(const RawBlock& block, int i, int j, int k)
{
	return (std::int64_t(k) * block.points_along[1] + j) * block.points_along[0] + i;
}

Ids cornersAt(const RawBlock& block, int i, int j, int k)
{
	const auto at = [&](int di, int dj, int dk) { return pointAt(block, i + di, j + dj, k + dk); };
	return {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)};
}

template <class Visit>
void forCells(const RawBlock& block, Visit&& visit)
{
	for (int k = 0; k + 1 < int(block.points_along[2]); ++k)
		for (int j = 0; j + 1 < int(block.points_along[1]); ++j)
			for (int i = 0; i + 1 < int(block.points_along[0]); ++i)
				visit(i, j, k);
}

std::vector<Ids> facesOf(const Ids& ids)
{
	const grid::ShapeTopology& shape = grid::topology(grid::CellShape::hexahedron);
	std::vector<Ids> faces;
	for (int f = 0; f < shape.faces; ++f)
	{
		faces.emplace_back();
		for (const std::uint8_t corner : shape.facePoints(f))
			faces.back().push_back(ids[corner]);
	}
	return faces;
}

// The lattice as explicit cells: `add(i, j, k, corners)` appends those of one lattice cell.
template <class Add>
void toCells(RawBlock& block, Add&& add)
{
	forCells(block, [&](int i, int j, int k) { add(i, j, k, cornersAt(block, i, j, k)); });
	block.kind = RawKind::cells;
}

void addHexahedron(RawBlock& block, const Ids& c)
{
	block.cells.push_back({kHexahedron, c, {}});
}

// Two wedges by the diagonal of the faces normal to k.
void addWedges(RawBlock& block, const Ids& c)
{
	block.cells.push_back({kWedge, {c[0], c[2], c[1], c[4], c[6], c[5]}, {}});
	block.cells.push_back({kWedge, {c[0], c[3], c[2], c[4], c[7], c[6]}, {}});
}

// Six about the diagonal 0-6, alike in every cell, so that they fit.
void addTetrahedra(RawBlock& block, const Ids& c)
{
	for (const auto& [a, b] : {std::pair(1, 2), {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
		block.cells.push_back({kTetra, {c[0], c[a], c[b], c[6]}, {}});
}

std::int64_t addCentre(RawBlock& block, const Ids& c)
{
	Vec3 sum(0.0);
	for (const std::int64_t id : c)
		sum += block.points[id] / 8.0;
	block.points.push_back(sum);
	return static_cast<std::int64_t>(block.points.size() - 1);
}

void addPyramids(RawBlock& block, const Ids& c)
{
	const std::int64_t tip = addCentre(block, c);
	for (const Ids& face : facesOf(c))
		block.cells.push_back({kPyramid, {face[3], face[2], face[1], face[0], tip}, {}});
}

void addPolyhedron(RawBlock& block, const Ids& c, Draw& draw)
{
	std::vector<Ids> faces = facesOf(c);
	for (Ids& face : faces)
		if (draw.chance(0.3))
			std::ranges::reverse(face); // files list faces either way round
	block.cells.push_back({kPolyhedron, {}, faces});
}

// Columns of wedges among hexahedra, pyramids and polyhedra: they share quads.
RawSet mixedCells(Draw& draw, const Disorder& disorder)
{
	RawBlock block = lattice(draw, disorder);
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
RawSet doublePolyhedra(Draw& draw, const Disorder& disorder)
{
	RawBlock block = lattice(draw, disorder);
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
		        block.cells.push_back({kPolyhedron, {}, faces});
	        });
	return {"double polyhedra", {block}};
}

// A wall of bricks: each has six neighbours in its layer, its top and bottom are hexagons.
RawSet hexagonalPolyhedra(Draw& draw, const Disorder& disorder)
{
	RawBlock block = lattice(draw, disorder, 3, 6);
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
				block.cells.push_back({kPolyhedron, {}, faces});
			}
	block.kind = RawKind::cells;
	return {"hexagonal polyhedra", {block}};
}

RawSet oneShape(Draw& draw, const Disorder& disorder)
{
	RawBlock block = lattice(draw, disorder);
	const int shape = draw.whole(0, 4);
	toCells(block,
	        [&](int, int, int, const Ids& c)
	        {
		        switch (shape)
		        {
		        case 0:
			        return addHexahedron(block, c);
		        case 1:
			        return addWedges(block, c);
		        case 2:
			        return addTetrahedra(block, c);
		        case 3:
			        return addPyramids(block, c);
		        default:
			        return addPolyhedron(block, c, draw);
		        }
	        });
	return {"one shape", {block}};
}

// Cells missing anywhere: holes, cells that hang by an edge or a point.
RawSet blankedCells(Draw& draw, const Disorder& disorder)
{
	RawBlock block = lattice(draw, disorder, 3, 6);
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
RawSet degenerateCells(Draw& draw)
{
	RawBlock block = lattice(draw, {0.2});
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
RawSet closedRing(Draw& draw)
{
	RawBlock block = lattice(draw, {}, 3, 6);
	const double inner = draw.chance(0.5) ? 0.0 : draw.real(0.2, 2.0);
	const double around = 2.0 * std::numbers::pi / (block.points_along[0] - 1);
	for (Vec3& p : block.points)
	{
		const double radius = inner + p.y;
		p = {radius * std::cos(around * p.x), -radius * std::sin(around * p.x), p.z};
	}
	return {"closed ring", {block}, true, true, inner == 0.0};
}

RawSet plainLattice(Draw& draw)
{
	RawBlock block = lattice(draw, {});
	const bool image = draw.chance(0.5);
	block.kind = image ? RawKind::image : RawKind::rectilinear;
	const double power = image ? 1.0 : draw.real(0.5, 3.0);
	const Vec3 growth(power, 0.5 * (power + 1.0), 1.0);
	for (Vec3& p : block.points)
		p = glm::pow(p, growth);
	return {image ? "image" : "rectilinear", {block}, true, true};
}

// Two lattices that abut along i with equal, shifted or overlapping layers.
RawSet severalBlocks(Draw& draw)
{
	RawBlock first = lattice(draw, {0.2});
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
		toCells(second, [&](int, int, int, const Ids& c) { addHexahedron(second, c); });
	return {"several blocks", {first, second}, meeting == 0};
}

RawSet shapedSet(Draw& draw)
{
	const int kind = draw.whole(0, 11);
	Disorder disorder;
	const double fault = draw.real(0.0, 1.0);
	if (fault < 0.2) // folded everywhere
		disorder.jitter = draw.real(0.3, 1.3);
	else if (fault < 0.5 || fault > 0.7)
		disorder.jitter = draw.real(0.0, 0.12);
	if (fault > 0.6) // or here and there
	{
		disorder.bumps = draw.whole(1, 4);
		disorder.bump = draw.real(0.5, 3.0);
	}
	const auto made = [&]() -> RawSet
	{
		switch (kind)
		{
		case 0:
			return plainLattice(draw);
		case 1:
			return closedRing(draw);
		case 2:
			return degenerateCells(draw);
		case 3:
			return severalBlocks(draw);
		case 4:
		case 5:
			return {"curvilinear", {lattice(draw, disorder)}};
		case 6:
			return blankedCells(draw, disorder);
		case 7:
			return mixedCells(draw, disorder);
		case 8:
			return doublePolyhedra(draw, disorder);
		case 9:
			return hexagonalPolyhedra(draw, disorder);
		default:
			return oneShape(draw, disorder);
		}
	};
	RawSet set = made();
	set.flat_faces = set.flat_faces || (kind > 3 && kind != 8 && disorder.jitter == 0.0 && disorder.bumps == 0);
	return set;
}

} // namespace

RawSet randomSet(unsigned seed)
{
	Draw draw(seed);
	RawSet set = shapedSet(draw);
	// One axis much thinner than the others, or left-handed; turned; far away.
	Vec3 scale(draw.chance(0.2) ? -1.0 : 1.0, 1.0, 1.0);
	if (draw.chance(0.4))
		scale[draw.whole(0, 2)] *= std::pow(10.0, -draw.real(0.0, 6.0));
	const bool turns = draw.chance(0.3);
	const Vec3 axis = draw.direction();
	const double angle = draw.real(0.0, 6.0);
	// An offset leaves the thinnest cells some thousand ulps.
	const double thinnest = std::min({std::abs(scale.x), scale.y, scale.z});
	const Vec3 offset = draw.chance(0.3) ? draw.around(std::min(1e7, 1e10 * thinnest)) : Vec3(0.0);
	const bool floats = draw.chance(0.3) && offset == Vec3(0.0);
	for (RawBlock& block : set.blocks)
	{
		const bool boxes = block.kind == RawKind::image || block.kind == RawKind::rectilinear;
		for (Vec3& p : block.points)
		{
			p *= scale;
			if (turns && !boxes)
				p = std::cos(angle) * p + std::sin(angle) * glm::cross(axis, p) +
				    (1.0 - std::cos(angle)) * glm::dot(axis, p) * axis;
			p += offset;
			if (floats && !boxes)
				p = Vec3(Vec3f(p));
		}
		block.floats = floats && !boxes;
	}
	return set;
}

namespace
{

Vec3 anyCorner(const grid::BlockSet& set, Draw& draw, Vec3* others)
{
	const grid::Block& block = set.blocks[draw.whole(0, static_cast<int>(set.blocks.size()) - 1)];
	const auto cell = static_cast<CellId>(draw.whole(0, static_cast<int>(cellCount(block)) - 1));
	const std::vector<Vec3> corners = cellCorners(block, cell);
	const auto any = [&] { return corners[draw.whole(0, static_cast<int>(corners.size()) - 1)]; };
	const Vec3 first = any();
	others[0] = any();
	others[1] = any();
	return first;
}

} // namespace

TestPlane randomPlane(const grid::BlockSet& set, unsigned seed)
{
	Draw draw(seed);
	const Box box = set.bounds();
	// By the set's proportions, so that thin layers are cut across as well as along.
	const Vec3 stretch = glm::max(box.size(), Vec3(1e-300));
	const Vec3 inside = box.lo + (0.5 + draw.around(0.5)) * box.size();
	const Vec3 direction = draw.direction();
	const Vec3 generic = glm::normalize(draw.chance(0.5) ? direction / stretch : direction);
	Vec3 along(0.0);
	along[draw.whole(0, 2)] = draw.chance(0.5) ? 1.0 : -1.0;
	Vec3 others[2];
	const Vec3 corner = anyCorner(set, draw, others);
	const Vec3 face = glm::cross(others[0] - corner, others[1] - corner);
	switch (draw.whole(0, 8))
	{
	case 0: // through a vertex
		return {corner, generic};
	case 1: // through an edge, or across a face's diagonal
		return {corner, glm::length(others[0] - corner) > 0.0 ? glm::cross(others[0] - corner, direction) : generic};
	case 2: // through a face
		return {corner, glm::length(face) > 0.0 ? face : generic};
	case 3: // along a layer
		return {corner, along};
	case 4: // along a side of the bounds
		return {draw.chance(0.5) ? box.lo : box.hi, along};
	case 5:
		return {inside, along};
	case 6: // at most touching
		return {box.centre() + (0.4 + 0.4 * draw.real(0.0, 1.0)) * box.diagonal() * direction, direction};
	default:
		return {inside, generic};
	}
}

} // namespace vp::test
