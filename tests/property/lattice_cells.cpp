#include "lattice_cells.h"

namespace vp::test
{

namespace
{

enum VtkType : std::uint8_t
{
	kTetra = 10,
	kHexahedron = 12,
	kWedge = 13,
	kPyramid = 14,
	kPolyhedron = 42
};

std::int64_t addCenter(RawBlock& block, const Ids& c)
{
	Vec3 sum(0.0);
	for (const std::int64_t id : c)
		sum += block.points[id] / 8.0;
	block.points.push_back(sum);
	return static_cast<std::int64_t>(block.points.size() - 1);
}

} // namespace

RawBlock lattice(Draw& draw, const Disorder& disorder, const LatticeSize& size)
{
	RawBlock block;
	block.kind = RawKind::curvilinear;
	for (std::uint32_t& n : block.points_along)
		n = static_cast<std::uint32_t>(draw.whole(size.least, size.most)) + 1;
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

void addHexahedron(RawBlock& block, const Ids& c)
{
	block.cells.push_back({kHexahedron, c, {}});
}

void addWedges(RawBlock& block, const Ids& c)
{
	block.cells.push_back({kWedge, {c[0], c[2], c[1], c[4], c[6], c[5]}, {}});
	block.cells.push_back({kWedge, {c[0], c[3], c[2], c[4], c[7], c[6]}, {}});
}

void addTetrahedra(RawBlock& block, const Ids& c)
{
	for (const auto& [a, b] : {std::pair(1, 2), {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
		block.cells.push_back({kTetra, {c[0], c[a], c[b], c[6]}, {}});
}

void addPyramids(RawBlock& block, const Ids& c)
{
	const std::int64_t tip = addCenter(block, c);
	for (const Ids& face : facesOf(c))
		block.cells.push_back({kPyramid, {face[3], face[2], face[1], face[0], tip}, {}});
}

void addPolyhedron(RawBlock& block, const Ids& c, Draw& draw)
{
	std::vector<Ids> faces = facesOf(c);
	for (Ids& face : faces)
		if (draw.chance(0.3))
			std::ranges::reverse(face); // files list faces either way round
	addPolyhedron(block, std::move(faces));
}

void addPolyhedron(RawBlock& block, std::vector<Ids> faces)
{
	block.cells.push_back({kPolyhedron, {}, std::move(faces)});
}

} // namespace vp::test
