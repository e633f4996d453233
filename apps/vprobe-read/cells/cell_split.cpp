#include "cell_split.h"

#include "read/cell_types.h"

#include <cmath>
#include <utility>

namespace vp::reader::cells
{

namespace
{

// A lattice of nodes over a cell.
class NodeLattice
{
public:
	explicit NodeLattice(std::array<int, 3> intervals) : intervals_(intervals) {}

	std::size_t place(int i, int j, int k) const
	{
		return (std::size_t(k) * std::size_t(intervals_[1] + 1) + std::size_t(j)) * std::size_t(intervals_[0] + 1) +
		       std::size_t(i);
	}

	// Returns the cell's point at each place of the lattice, or -1 if it has none there.
	std::vector<int> pointsAt(std::span<const Vec3> at) const
	{
		std::vector<int> points(place(intervals_[0], intervals_[1], intervals_[2]) + 1, -1);
		for (std::size_t p = 0; p < at.size(); ++p)
		{
			const auto near = [&](int axis) { return static_cast<int>(std::lround(at[p][axis] * intervals_[axis])); };
			points[place(near(0), near(1), near(2))] = static_cast<int>(p);
		}
		return points;
	}

private:
	std::array<int, 3> intervals_;
};

CellSplit::Node middleOf(std::initializer_list<int> corners)
{
	CellSplit::Node node;
	for (const int corner : corners)
	{
		const auto* end = node.corners.begin() + node.corner_count;
		if (std::find(node.corners.cbegin(), static_cast<const std::uint8_t*>(end), corner) == end)
			node.corners[static_cast<std::size_t>(node.corner_count++)] = static_cast<std::uint8_t>(corner);
	}
	return node;
}

CellSplit::Part part(std::uint8_t type, std::initializer_list<std::size_t> nodes)
{
	CellSplit::Part made{type};
	std::transform(nodes.begin(), nodes.end(), made.nodes.begin(),
	               [](std::size_t node) { return static_cast<std::uint16_t>(node); });
	return made;
}

void ownPoints(CellSplit& split, int count)
{
	for (int p = 0; p < count; ++p)
		split.nodes.push_back({p});
}

void addWedges(CellSplit& split, std::initializer_list<std::array<std::size_t, 6>> wedges)
{
	for (const auto& w : wedges)
		split.parts.push_back(part(read::kWedge, {w[0], w[1], w[2], w[3], w[4], w[5]}));
}

} // namespace

CellSplit splitHexahedron(std::array<int, 3> intervals, std::span<const Vec3> at)
{
	const NodeLattice lattice(intervals);
	const std::vector<int> points = lattice.pointsAt(at);
	CellSplit split;
	for (int k = 0; k <= intervals[2]; ++k)
		for (int j = 0; j <= intervals[1]; ++j)
			for (int i = 0; i <= intervals[0]; ++i)
			{
				if (const int point = points[lattice.place(i, j, k)]; point >= 0)
				{
					split.nodes.push_back({point});
					continue;
				}
				const auto corner = [&](int x, int y, int z)
				{ return points[lattice.place(i == 1 ? x : i, j == 1 ? y : j, k == 1 ? z : k)]; };
				split.nodes.push_back(middleOf({corner(0, 0, 0), corner(2, 0, 0), corner(0, 2, 0), corner(2, 2, 0),
				                                corner(0, 0, 2), corner(2, 0, 2), corner(0, 2, 2), corner(2, 2, 2)}));
			}
	for (int k = 0; k < intervals[2]; ++k)
		for (int j = 0; j < intervals[1]; ++j)
			for (int i = 0; i < intervals[0]; ++i)
				split.parts.push_back(
				    part(read::kHexahedron,
				         {lattice.place(i, j, k), lattice.place(i + 1, j, k), lattice.place(i + 1, j + 1, k),
				          lattice.place(i, j + 1, k), lattice.place(i, j, k + 1), lattice.place(i + 1, j, k + 1),
				          lattice.place(i + 1, j + 1, k + 1), lattice.place(i, j + 1, k + 1)}));
	return split;
}

CellSplit splitWedge(int across, int along, std::span<const Vec3> at)
{
	const NodeLattice lattice({across, across, along});
	const std::vector<int> points = lattice.pointsAt(at);
	std::vector<std::size_t> number(points.size());
	CellSplit split;
	for (int k = 0; k <= along; ++k)
		for (int j = 0; j <= across; ++j)
			for (int i = 0; i + j <= across; ++i)
			{
				number[lattice.place(i, j, k)] = split.nodes.size();
				if (const int point = points[lattice.place(i, j, k)]; point >= 0)
				{
					split.nodes.push_back({point});
					continue;
				}
				// This place is the middle of an edge of the triangle. corner() returns the ends: (1, 1) lies between
				// (2, 0) and (0, 2).
				const auto corner = [&](bool end, int z)
				{
					const int x = i == 1 ? (end ? 2 : 0) : i;
					const int y = j == 1 ? (end == (i == 1) ? 0 : 2) : j;
					return points[lattice.place(x, y, k == 1 && along == 2 ? z : k)];
				};
				split.nodes.push_back(middleOf({corner(false, 0), corner(true, 0), corner(false, 2), corner(true, 2)}));
			}
	const auto n = [&](int i, int j, int k) { return number[lattice.place(i, j, k)]; };
	for (int k = 0; k < along; ++k)
		for (int j = 0; j < across; ++j)
			for (int i = 0; i + j < across; ++i)
			{
				addWedges(split, {{n(i, j, k), n(i + 1, j, k), n(i, j + 1, k), n(i, j, k + 1), n(i + 1, j, k + 1),
				                   n(i, j + 1, k + 1)}});
				if (i + j + 2 <= across)
					addWedges(split, {{n(i + 1, j + 1, k), n(i, j + 1, k), n(i + 1, j, k), n(i + 1, j + 1, k + 1),
					                   n(i, j + 1, k + 1), n(i + 1, j, k + 1)}});
			}
	return split;
}

CellSplit splitTetrahedron(int intervals, std::span<const Vec3> at)
{
	const NodeLattice lattice({intervals, intervals, intervals});
	const std::vector<int> points = lattice.pointsAt(at);
	std::vector<std::size_t> number(points.size());
	CellSplit split;
	for (int k = 0; k <= intervals; ++k)
		for (int j = 0; j + k <= intervals; ++j)
			for (int i = 0; i + j + k <= intervals; ++i)
			{
				number[lattice.place(i, j, k)] = split.nodes.size();
				if (const int point = points[lattice.place(i, j, k)]; point >= 0)
				{
					split.nodes.push_back({point});
					continue;
				}
				// For the middle of an edge, each odd coordinate becomes 0 at one end and 2 at the other, so that the
				// sums are equal.
				const bool at_zero = i + j + k == 1;
				const std::array<int, 3> here = {i, j, k};
				std::array<int, 3> low = here;
				std::array<int, 3> high = here;
				bool first = true;
				for (std::size_t axis = 0; axis < 3; ++axis)
					if (here[axis] == 1)
					{
						low[axis] = at_zero || !first ? 0 : 2;
						high[axis] = at_zero || !first ? 2 : 0;
						first = false;
					}
				split.nodes.push_back(middleOf(
				    {points[lattice.place(low[0], low[1], low[2])], points[lattice.place(high[0], high[1], high[2])]}));
			}
	const auto n = [&](int i, int j, int k) { return number[lattice.place(i, j, k)]; };
	for (int k = 0; k < intervals; ++k)
		for (int j = 0; j + k < intervals; ++j)
			for (int i = 0; i + j + k < intervals; ++i)
			{
				split.parts.push_back(part(read::kTetra, {n(i, j, k), n(i + 1, j, k), n(i, j + 1, k), n(i, j, k + 1)}));
				const int room = intervals - i - j - k;
				if (room >= 2)
					split.parts.push_back(part(kOctahedron, {n(i + 1, j, k), n(i + 1, j + 1, k), n(i, j + 1, k),
					                                         n(i, j, k + 1), n(i + 1, j, k + 1), n(i, j + 1, k + 1)}));
				if (room >= 3)
					split.parts.push_back(part(read::kTetra, {n(i + 1, j + 1, k + 1), n(i + 1, j, k + 1),
					                                          n(i, j + 1, k + 1), n(i + 1, j + 1, k)}));
			}
	return split;
}

CellSplit splitWedge21()
{
	CellSplit split;
	ownPoints(split, 21);
	// Points 15, 16 and 20 lie in the middle of the three triangles.
	addWedges(split, {{0, 6, 15, 12, 17, 20},
	                  {6, 1, 15, 17, 13, 20},
	                  {1, 7, 15, 13, 18, 20},
	                  {7, 2, 15, 18, 14, 20},
	                  {2, 8, 15, 14, 19, 20},
	                  {8, 0, 15, 19, 12, 20},
	                  {12, 17, 20, 3, 9, 16},
	                  {17, 13, 20, 9, 4, 16},
	                  {13, 18, 20, 4, 10, 16},
	                  {18, 14, 20, 10, 5, 16},
	                  {14, 19, 20, 5, 11, 16},
	                  {19, 12, 20, 11, 3, 16}});
	return split;
}

CellSplit splitTetrahedron15()
{
	CellSplit split;
	ownPoints(split, 15);
	// For each face, clockwise seen from outside: its corners and edge points in turn, then its middle.
	constexpr std::array<std::array<std::size_t, 7>, 4> faces = {
	    {{0, 4, 1, 5, 2, 6, 10}, {0, 7, 3, 8, 1, 4, 11}, {1, 8, 3, 9, 2, 5, 12}, {0, 6, 2, 9, 3, 7, 13}}};
	for (const auto& face : faces)
		for (std::size_t i = 0; i < 6; ++i)
			split.parts.push_back(part(read::kTetra, {face[i], face[(i + 1) % 6], face[6], 14}));
	return split;
}

CellSplit splitPyramid19()
{
	CellSplit split;
	ownPoints(split, 19);
	constexpr std::array<std::array<std::size_t, 4>, 4> sides = {
	    {{5, 9, 10, 14}, {6, 10, 11, 15}, {7, 11, 12, 16}, {8, 12, 9, 17}}}; // base edge, both slant edges, middle
	for (const auto& base : std::initializer_list<std::array<std::size_t, 5>>{{0, 5, 13, 8, 9},
	                                                                          {5, 1, 6, 13, 10},
	                                                                          {8, 13, 7, 3, 12},
	                                                                          {13, 6, 2, 7, 11},
	                                                                          {9, 10, 11, 12, 4},
	                                                                          {9, 12, 11, 10, 18}})
		split.parts.push_back(part(read::kPyramid, {base[0], base[1], base[2], base[3], base[4]}));
	for (const auto& [edge, left, right, middle] : sides)
	{
		split.parts.push_back(part(read::kTetra, {edge, middle, 13, left}));
		split.parts.push_back(part(read::kTetra, {edge, 13, middle, right}));
		split.parts.push_back(part(read::kTetra, {13, left, middle, 18}));
		split.parts.push_back(part(read::kTetra, {13, middle, right, 18}));
		split.parts.push_back(part(read::kTetra, {left, right, middle, 18}));
	}
	return split;
}

CellSplit splitPyramid(int points)
{
	CellSplit split;
	ownPoints(split, points);
	if (points < 13)
		for (const auto& [a, b] :
		     std::initializer_list<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}})
			split.nodes.push_back(middleOf({a, b}));
	split.nodes.push_back(middleOf({0, 1, 2, 3}));
	for (const auto& p : std::initializer_list<std::array<std::size_t, 5>>{{0, 5, 13, 8, 9},
	                                                                       {5, 1, 6, 13, 10},
	                                                                       {8, 13, 7, 3, 12},
	                                                                       {13, 6, 2, 7, 11},
	                                                                       {9, 10, 11, 12, 4},
	                                                                       {9, 12, 11, 10, 13}})
		split.parts.push_back(part(read::kPyramid, {p[0], p[1], p[2], p[3], p[4]}));
	for (const auto& t : std::initializer_list<std::array<std::size_t, 4>>{
	         {5, 13, 9, 10}, {6, 13, 10, 11}, {7, 13, 11, 12}, {8, 13, 12, 9}})
		split.parts.push_back(part(read::kTetra, {t[0], t[1], t[2], t[3]}));
	return split;
}

const CellSplit& halvedSplit(std::uint8_t type)
{
	static const std::array<Vec3, 8> cube = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0),
	                                         Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)};
	static const std::array<Vec3, 6> prism = {cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]};
	static const std::array<Vec3, 4> simplex = {cube[0], cube[1], cube[3], cube[4]};
	static const CellSplit hexahedron = splitHexahedron({2, 2, 2}, cube);
	static const CellSplit wedge = splitWedge(2, 2, prism);
	static const CellSplit tetrahedron = splitTetrahedron(2, simplex);
	static const CellSplit pyramid = splitPyramid(5);
	return type == read::kHexahedron ? hexahedron
	       : type == read::kWedge    ? wedge
	       : type == read::kPyramid  ? pyramid
	                                 : tetrahedron;
}

int pointsOf(std::uint8_t part_type)
{
	return part_type == kOctahedron ? 6 : read::slicedCellSize(part_type);
}

const OctahedronCut& octahedronCut(int diagonal)
{
	// Cuts in the order of kOctahedronDiagonals. The tetrahedra of each cut run about its diagonal in the same sense.
	static constexpr std::array<OctahedronCut, 3> cuts = {{{{{0, 5, 1, 2}, {0, 5, 2, 3}, {0, 5, 3, 4}, {0, 5, 4, 1}}},
	                                                       {{{1, 3, 0, 4}, {1, 3, 4, 5}, {1, 3, 5, 2}, {1, 3, 2, 0}}},
	                                                       {{{2, 4, 0, 1}, {2, 4, 1, 5}, {2, 4, 5, 3}, {2, 4, 3, 0}}}}};
	return cuts[static_cast<std::size_t>(diagonal)];
}

} // namespace vp::reader::cells
