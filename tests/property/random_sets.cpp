#include "random_sets.h"

#include "lattice_sets.h"

namespace vp::test
{

namespace
{

RawSet shapedSet(Draw& draw)
{
	const auto kind = static_cast<LatticeKind>(draw.whole(0, kLatticeKinds - 1));
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
	RawSet set = latticeSet(kind, draw, disorder);
	const bool even = disorder.jitter == 0.0 && disorder.bumps == 0;
	set.flat_faces = set.flat_faces || (even && kind >= LatticeKind::curvilinear && kind != LatticeKind::doubles);
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
		return {box.center() + (0.4 + 0.4 * draw.real(0.0, 1.0)) * box.diagonal() * direction, direction};
	default:
		return {inside, generic};
	}
}

} // namespace vp::test
