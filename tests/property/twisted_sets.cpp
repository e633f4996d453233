#include "twisted_sets.h"

namespace vp::test
{

namespace
{

std::vector<std::int64_t> cellPointIds(const RawBlock& block, std::size_t cell)
{
	if (block.kind != RawKind::cells) // the middle cell of 3^3
	{
		std::vector<std::int64_t> ids;
		for (const std::int64_t id : {0, 1, 5, 4, 16, 17, 21, 20})
			ids.push_back(id + 21);
		return ids;
	}
	const RawCell& raw = block.cells[cell];
	if (raw.faces.empty())
		return raw.ids;
	std::vector<std::int64_t> ids;
	for (const std::vector<std::int64_t>& face : raw.faces)
		ids.insert(ids.end(), face.begin(), face.end());
	std::ranges::sort(ids);
	ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
	return ids;
}

// From the frame in which the plane is z = 0; a turn about (1, 2, 2) / 3 and a shift, of no round numbers.
Vec3 turned(const Vec3& p)
{
	const Vec3 axis = Vec3(1, 2, 2) / 3.0;
	return std::cos(0.7) * p + std::sin(0.7) * glm::cross(axis, p) + (1.0 - std::cos(0.7)) * glm::dot(axis, p) * axis;
}

const Vec3 kShift(0.3, -0.1, 0.7);

TwistedSet untouched(LatticeKind kind, Draw& draw)
{
	TwistedSet set{latticeSet(kind, draw, {0.3}, {3, 3}), 13, {kShift, turned({0, 0, 1})}};
	if (set.raw.blocks[0].kind == RawKind::cells)
		set.cell = set.raw.blocks[0].cells.size() / 2;
	return set;
}

} // namespace

int twistedPoints(LatticeKind kind)
{
	Draw draw(0);
	const TwistedSet set = untouched(kind, draw);
	return static_cast<int>(cellPointIds(set.raw.blocks[0], set.cell).size());
}

TwistedSet twistedSet(LatticeKind kind, std::uint32_t mask, unsigned seed)
{
	Draw draw(seed);
	TwistedSet set = untouched(kind, draw);
	std::vector<Vec3>& points = set.raw.blocks[0].points;
	constexpr double kClear = 0.05; // distance from the plane
	for (Vec3& p : points)
	{
		p -= Vec3(1.5);
		if (std::abs(p.z) < kClear)
			p.z = kClear;
	}
	const std::vector<std::int64_t> ids = cellPointIds(set.raw.blocks[0], set.cell);
	for (std::size_t i = 0; i < ids.size(); ++i)
		points[ids[i]].z = (mask >> i & 1 ? 1.0 : -1.0) * draw.real(kClear, 1.0);
	for (Vec3& p : points)
		p = turned(p) + kShift;
	set.raw.flat_faces = false;
	return set;
}

} // namespace vp::test
