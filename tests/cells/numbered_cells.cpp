#include "numbered_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

using vp::Vec3;

namespace
{

// VTK's types.
constexpr std::uint8_t kTetrahedronTypes[] = {71, 78};
constexpr std::uint8_t kHexahedronTypes[] = {72, 79};
constexpr std::uint8_t kWedgeTypes[] = {73, 80};

using Spot = std::array<double, 2>;

// Within a triangle whose edges are `degree` long: corners, edges, and what is left as a triangle of its own.
std::vector<Spot> ringed(int degree)
{
	if (degree == 0)
		return {{0, 0}};
	const double d = degree;
	std::vector<Spot> spots = {{0, 0}, {d, 0}, {0, d}};
	for (double i = 1; i < d; ++i)
		spots.push_back({i, 0});
	for (double i = 1; i < d; ++i)
		spots.push_back({d - i, i});
	for (double i = 1; i < d; ++i)
		spots.push_back({0, d - i});
	for (const Spot& inner : degree >= 3 ? ringed(degree - 3) : std::vector<Spot>())
		spots.push_back({inner[0] + 1, inner[1] + 1});
	return spots;
}

std::vector<Spot> insideOf(int degree, bool rings)
{
	std::vector<Spot> spots;
	if (degree < 3)
		return spots;
	if (rings)
		for (const Spot& inner : ringed(degree - 3))
			spots.push_back({inner[0] + 1, inner[1] + 1});
	else
		for (int j = 1; j < degree; ++j)
			for (int i = 1; i + j < degree; ++i)
				spots.push_back({double(i), double(j)});
	return spots;
}

class Nodes
{
public:
	std::vector<Vec3> list;

	void corners(std::initializer_list<Vec3> points) { list.insert(list.end(), points); }
	void edge(int a, int b, int degree)
	{
		const Vec3 from = list[a];
		const Vec3 to = list[b];
		for (int i = 1; i < degree; ++i)
			list.push_back(from + (to - from) * (double(i) / degree));
	}
	void triangle(int a, int b, int c, int degree, bool rings)
	{
		const Vec3 p = list[a], q = list[b], r = list[c];
		for (const Spot& spot : insideOf(degree, rings))
			list.push_back(p + (q - p) * (spot[0] / degree) + (r - p) * (spot[1] / degree));
	}
	// From a towards b, row by row towards c.
	void quadrilateral(int a, int b, int c, std::array<int, 2> degrees)
	{
		const Vec3 p = list[a], q = list[b], r = list[c];
		for (int j = 1; j < degrees[1]; ++j)
			for (int i = 1; i < degrees[0]; ++i)
				list.push_back(p + (q - p) * (double(i) / degrees[0]) + (r - p) * (double(j) / degrees[1]));
	}
};

// Corners, edges, faces and then the inside, as a tetrahedron of its own.
std::vector<Vec3> tetrahedronNodes(int degree, const std::array<Vec3, 4>& corners)
{
	if (degree == 0)
		return {corners[0]};
	Nodes nodes;
	nodes.corners({corners[0], corners[1], corners[2], corners[3]});
	for (const auto& [a, b] : std::initializer_list<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}})
		nodes.edge(a, b, degree);
	for (const auto& [a, b, c] : std::initializer_list<std::array<int, 3>>{{0, 1, 3}, {2, 3, 1}, {0, 3, 2}, {0, 2, 1}})
		nodes.triangle(a, b, c, degree, true);
	if (degree >= 4)
	{
		std::array<Vec3, 4> inner;
		for (int i = 0; i < 4; ++i)
		{
			inner[i] = Vec3(0.0);
			for (int j = 0; j < 4; ++j)
				inner[i] += corners[j] * ((i == j ? degree - 3.0 : 1.0) / degree);
		}
		const std::vector<Vec3> inside = tetrahedronNodes(degree - 4, inner);
		nodes.list.insert(nodes.list.end(), inside.begin(), inside.end());
	}
	return nodes.list;
}

std::string nameOf(Family family, const std::string& shape, std::initializer_list<int> degrees)
{
	std::string name = (family == Family::bezier ? "Bezier" : "Lagrange") + shape;
	for (const int degree : degrees)
		name += fmt::format("{}", degree);
	return name;
}

} // namespace

std::ostream& operator<<(std::ostream& out, const NumberedCell& cell)
{
	return out << cell.name;
}

NumberedCell tetrahedronOf(Family family, int degree)
{
	const std::array<Vec3, 4> corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
	return {nameOf(family, "Tetrahedron", {degree}),
	        kTetrahedronTypes[int(family)],
	        ParentShape::tetrahedron,
	        tetrahedronNodes(degree, corners),
	        {degree, degree, degree},
	        degree,
	        family == Family::bezier};
}

NumberedCell wedgeOf(Family family, int across, int along, const Habit& habit)
{
	Nodes nodes;
	nodes.corners({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
	for (const int end : {0, 3})
	{
		nodes.edge(end, end + 1, across);
		nodes.edge(end + 1, end + 2, across);
		nodes.edge(end + 2, end, across);
	}
	for (const int corner : {0, 1, 2})
		nodes.edge(corner, corner + 3, along);
	for (const int end : {0, 3})
		nodes.triangle(end, end + 1, end + 2, across, habit.rings);
	nodes.quadrilateral(0, 1, 3, {across, along});
	nodes.quadrilateral(1, 2, 4, {across, along});
	if (habit.upward)
		nodes.quadrilateral(0, 2, 3, {across, along});
	else
		nodes.quadrilateral(2, 0, 5, {across, along});
	for (int k = 1; k < along; ++k)
		for (const Spot& spot : insideOf(across, habit.rings))
			nodes.list.emplace_back(spot[0] / across, spot[1] / across, double(k) / along);
	return {nameOf(family, "Wedge", {across, along}),
	        kWedgeTypes[int(family)],
	        ParentShape::wedge,
	        nodes.list,
	        {across, across, along},
	        std::max(across, along),
	        family == Family::bezier};
}

NumberedCell hexahedronOf(Family family, std::array<int, 3> degrees, const Habit& habit)
{
	const auto [p, q, r] = degrees;
	Nodes nodes;
	nodes.corners({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
	for (const int end : {0, 4})
	{
		nodes.edge(end, end + 1, p);
		nodes.edge(end + 1, end + 2, q);
		nodes.edge(end + 3, end + 2, p);
		nodes.edge(end, end + 3, q);
	}
	for (const int corner : habit.swaps_edges ? std::array{0, 1, 3, 2} : std::array{0, 1, 2, 3})
		nodes.edge(corner, corner + 4, r);
	nodes.quadrilateral(0, 3, 4, {q, r});
	nodes.quadrilateral(1, 2, 5, {q, r});
	nodes.quadrilateral(0, 1, 4, {p, r});
	nodes.quadrilateral(3, 2, 7, {p, r});
	nodes.quadrilateral(0, 1, 3, {p, q});
	nodes.quadrilateral(4, 5, 7, {p, q});
	for (int k = 1; k < r; ++k)
		for (int j = 1; j < q; ++j)
			for (int i = 1; i < p; ++i)
				nodes.list.emplace_back(double(i) / p, double(j) / q, double(k) / r);
	return {nameOf(family, "Hexahedron", {p, q, r}),
	        kHexahedronTypes[int(family)],
	        ParentShape::hexahedron,
	        nodes.list,
	        degrees,
	        std::max({p, q, r}),
	        family == Family::bezier};
}

std::vector<NumberedCell> quadraticCells()
{
	const auto first = [](const NumberedCell& cell, std::size_t count)
	{ return std::vector<Vec3>(cell.nodes.begin(), cell.nodes.begin() + count); };
	const NumberedCell tetrahedron = tetrahedronOf(Family::lagrange, 2);
	const NumberedCell wedge = wedgeOf(Family::lagrange, 2, 2);
	const NumberedCell hexahedron = hexahedronOf(Family::lagrange, {2, 2, 2});
	Nodes pyramid;
	pyramid.corners({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}});
	for (const auto& [a, b] :
	     std::initializer_list<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}})
		pyramid.edge(a, b, 2);
	Nodes full_pyramid = pyramid;
	const std::vector<Vec3>& at = pyramid.list;
	full_pyramid.corners({(at[0] + at[2]) / 2.0,
	                      (at[0] + at[1] + at[4]) / 3.0,
	                      (at[1] + at[2] + at[4]) / 3.0,
	                      (at[2] + at[3] + at[4]) / 3.0,
	                      (at[3] + at[0] + at[4]) / 3.0,
	                      {0.5, 0.5, 0.25}});
	return {{"QuadraticTetra", 24, ParentShape::tetrahedron, tetrahedron.nodes, {}, 2},
	        {"QuadraticHexahedron", 25, ParentShape::hexahedron, first(hexahedron, 20), {}, 2},
	        {"QuadraticWedge", 26, ParentShape::wedge, first(wedge, 15), {}, 2},
	        {"QuadraticPyramid", 27, ParentShape::pyramid, pyramid.list, {}, 2},
	        {"TriQuadraticHexahedron", 29, ParentShape::hexahedron, hexahedron.nodes, {}, 2},
	        {"QuadraticLinearWedge", 31, ParentShape::wedge, first(wedge, 12), {}, 2},
	        {"BiQuadraticQuadraticWedge", 32, ParentShape::wedge, wedge.nodes, {}, 2},
	        {"BiQuadraticQuadraticHexahedron", 33, ParentShape::hexahedron, first(hexahedron, 24), {}, 2},
	        {"TriQuadraticPyramid", 37, ParentShape::pyramid, full_pyramid.list, {}, 2}};
}

std::vector<NumberedCell> linearCells()
{
	const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), zero(0, 0, 0);
	return {{"Tetrahedron", 10, ParentShape::tetrahedron, {zero, x, y, z}},
	        {"Voxel", 11, ParentShape::hexahedron, {zero, x, y, x + y, z, x + z, y + z, x + y + z}},
	        {"Hexahedron", 12, ParentShape::hexahedron, {zero, x, x + y, y, z, x + z, x + y + z, y + z}},
	        {"Wedge", 13, ParentShape::wedge, {zero, x, y, z, x + z, y + z}},
	        {"Pyramid", 14, ParentShape::pyramid, {zero, x, x + y, y, {0.5, 0.5, 1}}}};
}

CubeMesh cubeOf(const NumberedCell& cell, int count)
{
	CubeMesh mesh{{}, {}, {}, {}, cell.type, cell.degrees};
	std::map<std::array<long, 3>, std::size_t> known;
	for (int k = 0; k < count; ++k)
		for (int j = 0; j < count; ++j)
			for (int i = 0; i < count; ++i)
				for (const CellFrame& frame : unitCubeCells(cell.shape))
				{
					std::vector<std::size_t> ids;
					for (const Vec3& r : cell.nodes)
					{
						const Vec3 at = Vec3(i, j, k) + frame[0] + r.x * frame[1] + r.y * frame[2] + r.z * frame[3];
						// Degrees up to 8 lie on this lattice.
						const std::array<long, 3> place = {std::lround(at.x * 1680), std::lround(at.y * 1680),
						                                   std::lround(at.z * 1680)};
						const auto [found, is_new] = known.try_emplace(place, mesh.points.size());
						if (is_new)
							mesh.points.push_back(at / double(count));
						ids.push_back(found->second);
					}
					mesh.cells.push_back(std::move(ids));
				}
	mesh.values.resize(mesh.points.size());
	return mesh;
}

void movePoints(CubeMesh& mesh, const std::function<Vec3(Vec3)>& map)
{
	for (Vec3& point : mesh.points)
		point = map(point);
}

void setValues(CubeMesh& mesh, const std::function<double(Vec3)>& value)
{
	std::ranges::transform(mesh.points, mesh.values.begin(), value);
}
