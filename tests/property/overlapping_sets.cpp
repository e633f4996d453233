#include "overlapping_sets.h"

#include "lattice_cells.h"

#include <map>
#include <tuple>

namespace vp::test
{

namespace
{

// Cells whose points are known by their places, or are each cell's own.
class Cells
{
public:
	explicit Cells(bool shares_points) : shares_points_(shares_points) {}

	void addBox(const Vec3& lo, const Vec3& size) { addHexahedron(block_, cornersOf(lo, size)); }
	void addBoxOfFaces(const Vec3& lo, const Vec3& size) { addPolyhedron(block_, facesOf(cornersOf(lo, size))); }
	void addTetrahedra(const Vec3& lo, const Vec3& size) { vp::test::addTetrahedra(block_, cornersOf(lo, size)); }

	// A box with its eight parts beside it, and with theirs in every other one.
	void addWithChildren(const Vec3& lo, double size, int levels)
	{
		addBox(lo, Vec3(size));
		for (int part = 0; part < 8 && levels > 0; ++part)
			if (levels == 1 || part % 2 == 0)
				addWithChildren(lo + 0.5 * size * Vec3(part & 1, part >> 1 & 1, part >> 2), 0.5 * size, levels - 1);
	}
	const RawBlock& block() const { return block_; }

private:
	Ids cornersOf(const Vec3& lo, const Vec3& size)
	{
		Ids ids;
		for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1),
		                           Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)})
			ids.push_back(idOf(lo + corner * size));
		return ids;
	}
	std::int64_t idOf(const Vec3& place)
	{
		const auto next = static_cast<std::int64_t>(block_.points.size());
		if (shares_points_)
			if (const auto [at, is_new] = ids_.emplace(std::tuple(place.x, place.y, place.z), next); !is_new)
				return at->second;
		block_.points.push_back(place);
		return next;
	}

	bool shares_points_;
	RawBlock block_;
	std::map<std::tuple<double, double, double>, std::int64_t> ids_;
};

template <class Add>
void forBoxes(int along, Add&& add)
{
	for (int k = 0; k < along; ++k)
		for (int j = 0; j < along; ++j)
			for (int i = 0; i < along; ++i)
				add(Vec3(i, j, k));
}

RawSet octree(bool shares_points)
{
	Cells cells(shares_points);
	forBoxes(2, [&](const Vec3& at) { cells.addWithChildren(2.0 * at, 2.0, at.x + at.y > 1.0 ? 2 : at.z > 0.0); });
	return {"parents beside children", {cells.block()}, false};
}

RawSet cellsTwice(bool shares_points)
{
	Cells cells(shares_points);
	for (int time = 0; time < 2; ++time)
		forBoxes(3, [&](const Vec3& at) { cells.addBox(at, Vec3(1.0)); });
	return {"cells twice", {cells.block()}, false};
}

// Boxes over boxes of half and of two thirds of their width, and beside boxes that are shifted by a part of it.
RawSet facesOnFaces(bool shares_points, bool several_blocks)
{
	std::vector<Cells> parts(several_blocks ? 4 : 1, Cells(shares_points));
	const auto part = [&](std::size_t n) -> Cells& { return parts[several_blocks ? n : 0]; };
	for (const Vec3& at : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(2, 2, 0)})
		part(0).addBox(at, Vec3(2.0));
	for (int j = 0; j < 4; ++j)
		for (int i = 0; i < 4; ++i)
			part(1).addBox(Vec3(i, j, 2.0), Vec3(1.0));
	for (int j = 0; j < 3; ++j)
		for (int i = 0; i < 3; ++i)
			part(2).addBox(Vec3(1.25 * i, 1.25 * j, 3.0), Vec3(1.25, 1.25, 1.0));
	part(3).addBox(Vec3(-1.0, 0.5, 0.5), Vec3(1.0, 2.0, 2.0));
	RawSet set{"faces on faces", {}, false};
	for (const Cells& cells : parts)
		set.blocks.push_back(cells.block());
	return set;
}

RawBlock box(RawKind kind, const Vec3& lo, double step, std::uint32_t cells)
{
	RawBlock block;
	block.kind = kind;
	block.points_along = {cells + 1, cells + 1, cells + 1};
	for (std::uint32_t k = 0; k <= cells; ++k)
		for (std::uint32_t j = 0; j <= cells; ++j)
			for (std::uint32_t i = 0; i <= cells; ++i)
				block.points.push_back(lo + step * Vec3(i, j, k));
	return block;
}

RawSet fineInCoarse(RawKind coarse, RawKind fine)
{
	RawSet set{"fine in coarse", {box(coarse, Vec3(0.0), 1.0, 4), box(fine, Vec3(1.0), 0.5, 4)}, false};
	for (RawBlock& block : set.blocks)
		if (block.kind == RawKind::cells)
			block = asHexahedra(block);
	return set;
}

RawSet shapesInEachOther(bool shares_points)
{
	Cells cells(shares_points);
	cells.addBoxOfFaces(Vec3(0.0), Vec3(4.0, 2.0, 2.0));
	cells.addBox(Vec3(0.0), Vec3(2.0));
	cells.addTetrahedra(Vec3(2.0, 0.0, 0.0), Vec3(2.0));
	cells.addBoxOfFaces(Vec3(0.0, 2.0, 0.0), Vec3(4.0, 2.0, 4.0));
	cells.addTetrahedra(Vec3(0.0, 0.0, 2.0), Vec3(4.0, 2.0, 2.0));
	return {"shapes in each other", {cells.block()}, false};
}

} // namespace

std::vector<RawSet> overlappingSets()
{
	std::vector<RawSet> sets;
	for (const bool shares_points : {true, false})
	{
		sets.push_back(octree(shares_points));
		sets.push_back(cellsTwice(shares_points));
		sets.push_back(facesOnFaces(shares_points, false));
		sets.push_back(shapesInEachOther(shares_points));
	}
	sets.push_back(facesOnFaces(true, true));
	for (const auto& [coarse, fine] :
	     {std::pair(RawKind::image, RawKind::image), std::pair(RawKind::image, RawKind::rectilinear),
	      std::pair(RawKind::curvilinear, RawKind::curvilinear), std::pair(RawKind::curvilinear, RawKind::cells),
	      std::pair(RawKind::cells, RawKind::cells)})
		sets.push_back(fineInCoarse(coarse, fine));
	return sets;
}

std::vector<TestPlane> planesOfOverlappingSets()
{
	std::vector<TestPlane> planes;
	for (int axis = 0; axis < 3; ++axis)
		for (const double at : {0.0, 0.25, 0.5, 1.0, 1.25, 1.75, 2.0, 2.5, 3.0, 3.75, 4.0})
			for (const double side : {1.0, -1.0})
			{
				Vec3 normal(0.0);
				normal[axis] = side;
				planes.push_back({Vec3(at), normal});
			}
	const std::vector<TestPlane> others = randomPlanes({Vec3(0.0), Vec3(4.0)}, 10, 39);
	planes.insert(planes.end(), others.begin(), others.end());
	return planes;
}

} // namespace vp::test
