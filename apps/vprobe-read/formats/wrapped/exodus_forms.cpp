#include "exodus_forms.h"

#include <vtkCellType.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace vp::reader::wrapped
{

namespace
{

using Nodes = std::vector<std::vector<std::uint8_t>>;

std::vector<std::uint8_t> upTo(std::uint8_t count)
{
	std::vector<std::uint8_t> numbers(count);
	std::iota(numbers.begin(), numbers.end(), std::uint8_t(0));
	return numbers;
}

Nodes nodesOf(std::uint8_t corners, std::initializer_list<std::vector<std::uint8_t>> others, bool has_inside = true)
{
	Nodes nodes;
	for (std::uint8_t c = 0; c < corners; ++c)
		nodes.push_back({c});
	nodes.insert(nodes.end(), others);
	if (has_inside)
		nodes.push_back(upTo(corners));
	return nodes;
}

// Quadratic functions and the bubbles of the faces, at the mean of the corners.
const FullCell kTetrahedron15{
    VTK_LAGRANGE_TETRAHEDRON,
    nodesOf(4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}, {0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}),
    {1 / 64.0, 1 / 64.0, 1 / 64.0, 1 / 64.0, -0.125, -0.125, -0.125, -0.125, -0.125, -0.125, 27 / 64.0, 27 / 64.0,
     27 / 64.0, 27 / 64.0}};

// Blends what is linear between the triangles with what is quadratic within the layer between them.
const FullCell kWedge21{VTK_LAGRANGE_WEDGE,
                        nodesOf(6, {{0, 1},
                                    {1, 2},
                                    {2, 0},
                                    {3, 4},
                                    {4, 5},
                                    {5, 3},
                                    {0, 3},
                                    {1, 4},
                                    {2, 5},
                                    {0, 1, 2},
                                    {3, 4, 5},
                                    {0, 1, 4, 3},
                                    {1, 2, 5, 4},
                                    {2, 0, 3, 5}}),
                        {1 / 18.0, 1 / 18.0, 1 / 18.0, 1 / 18.0, 1 / 18.0, 1 / 18.0, -2 / 9.0,
                         -2 / 9.0, -2 / 9.0, -2 / 9.0, -2 / 9.0, -2 / 9.0, -1 / 9.0, -1 / 9.0,
                         -1 / 9.0, 0.5,      0.5,      4 / 9.0,  4 / 9.0,  4 / 9.0}};

const FullCell kWedge12{
    VTK_QUADRATIC_LINEAR_WEDGE, nodesOf(6, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}}, false), {}};

// All quadratic functions, and the product of both coordinates of the base squared. The node lies at a quarter of the
// height. The middles of the triangles do not take part.
const FullCell kPyramid19{VTK_TRIQUADRATIC_PYRAMID,
                          nodesOf(5, {{0, 1},
                                      {1, 2},
                                      {2, 3},
                                      {3, 0},
                                      {0, 4},
                                      {1, 4},
                                      {2, 4},
                                      {3, 4},
                                      {0, 1, 2, 3},
                                      {0, 1, 4},
                                      {1, 2, 4},
                                      {2, 3, 4},
                                      {3, 0, 4}}),
                          {-3 / 64.0, -3 / 64.0, -3 / 64.0, -3 / 64.0, -0.125, 0, 0, 0, 0, 3 / 16.0, 3 / 16.0, 3 / 16.0,
                           3 / 16.0, 9 / 16.0, 0, 0, 0, 0}};

// The shape that the faces enclose, by the rule of Coons.
const FullCell kHexahedron27{VTK_TRIQUADRATIC_HEXAHEDRON,
                             nodesOf(8, {{0, 1},
                                         {1, 2},
                                         {2, 3},
                                         {3, 0},
                                         {4, 5},
                                         {5, 6},
                                         {6, 7},
                                         {7, 4},
                                         {0, 4},
                                         {1, 5},
                                         {2, 6},
                                         {3, 7},
                                         {0, 3, 7, 4},
                                         {1, 2, 6, 5},
                                         {0, 1, 5, 4},
                                         {3, 2, 6, 7},
                                         {0, 1, 2, 3},
                                         {4, 5, 6, 7}}),
                             {0.125, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125, -0.25, -0.25, -0.25, -0.25, -0.25,
                              -0.25, -0.25, -0.25, -0.25, -0.25, -0.25, -0.25, 0.5,   0.5,   0.5,   0.5,   0.5,   0.5}};

// Corners, edges in the manual's order, and more.
ExodusForm form(std::string_view family, const FullCell& cell, std::uint8_t corners,
                std::initializer_list<std::uint8_t> edges, std::initializer_list<std::uint8_t> others)
{
	ExodusForm made{family, &cell, upTo(corners), 0};
	made.nodes.insert(made.nodes.end(), edges);
	made.in_place = made.nodes.size();
	made.nodes.insert(made.nodes.end(), others);
	return made;
}

constexpr std::initializer_list<std::uint8_t> kNone = {};
constexpr std::initializer_list<std::uint8_t> kTetrahedronEdges = {4, 5, 6, 7, 8, 9};
constexpr std::initializer_list<std::uint8_t> kWedgeEdges = {6, 7, 8, 12, 13, 14, 9, 10, 11};
constexpr std::initializer_list<std::uint8_t> kPyramidEdges = {5, 6, 7, 8, 9, 10, 11, 12};
constexpr std::initializer_list<std::uint8_t> kHexahedronEdges = {8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15};

const std::array kForms = {
    form("TET", kTetrahedron15, 4, kNone, {14}),
    form("TET", kTetrahedron15, 4, kNone, {10, 12, 13, 11}),
    form("TET", kTetrahedron15, 4, kTetrahedronEdges, {14}),
    form("TET", kTetrahedron15, 4, kTetrahedronEdges, {10, 12, 13, 11}),
    form("TET", kTetrahedron15, 4, kTetrahedronEdges, {10, 12, 13, 11, 14}),
    form("WED", kWedge12, 6, {6, 7, 8, 9, 10, 11}, kNone),
    form("WED", kWedge21, 6, kWedgeEdges, {20}),
    form("WED", kWedge21, 6, kWedgeEdges, {15, 16, 18, 19, 17}),
    form("WED", kWedge21, 6, kWedgeEdges, {20, 15, 16, 18, 19, 17}),
    form("PYR", kPyramid19, 5, kPyramidEdges, {13}),
    form("PYR", kPyramid19, 5, kPyramidEdges, {13, 14, 15, 16, 17}),
    form("PYR", kPyramid19, 5, kPyramidEdges, {13, 14, 15, 16, 17, 18}),
    form("HEX", kHexahedron27, 8, kNone, {26}),
    form("HEX", kHexahedron27, 8, {8, 9, 10, 11, 12, 13, 14, 15}, kNone),
    form("HEX", kHexahedron27, 8, kHexahedronEdges, {26}),
};

struct Plain
{
	std::string_view family;
	std::array<std::size_t, 3> nodes;
	std::string_view names;
};
constexpr std::array<Plain, 4> kPlain = {{{"TET", {4, 10, 10}, "TETRA4, TETRA10 or TETRA15"},
                                          {"WED", {6, 15, 18}, "WEDGE6, WEDGE15 or WEDGE21"},
                                          {"PYR", {5, 13, 13}, "PYRAMID5, PYRAMID13 or PYRAMID19"},
                                          {"HEX", {8, 20, 27}, "HEX8, HEX20 or HEX27"}}};

} // namespace

std::span<const ExodusForm> exodusForms()
{
	return kForms;
}

bool isPlainExodus(std::string_view family, std::size_t nodes)
{
	const auto found = std::ranges::find(kPlain, family, &Plain::family);
	return found != kPlain.end() && std::ranges::find(found->nodes, nodes) != found->nodes.end();
}

std::optional<std::string_view> plainExodusNames(std::string_view family)
{
	const auto found = std::ranges::find(kPlain, family, &Plain::family);
	return found == kPlain.end() ? std::nullopt : std::optional(found->names);
}

std::vector<std::vector<double>> ExodusForm::weights() const
{
	std::vector<std::vector<double>> all(cell->nodes.size());
	for (std::size_t n = 0; n < nodes.size(); ++n)
	{
		all[nodes[n]].assign(nodes.size(), 0.0);
		all[nodes[n]][n] = 1.0;
	}
	// Edges come before faces, and those before the inside.
	for (std::size_t node = 0; node < all.size(); ++node)
	{
		if (!all[node].empty())
			continue;
		std::vector<double>& sum = all[node];
		sum.assign(nodes.size(), 0.0);
		const auto add = [&](std::size_t other, double factor)
		{
			for (std::size_t n = 0; n < sum.size(); ++n)
				sum[n] += factor * all[other][n];
		};
		const std::vector<std::uint8_t>& corners = cell->nodes[node];
		if (corners.size() > 4 || node + 1 == all.size())
		{
			for (std::size_t other = 0; other < cell->inside.size(); ++other)
				add(other, cell->inside[other]);
			continue;
		}
		// Half of an edge; quadratic functions of a triangle or of a quadrilateral without a node of its own.
		const double of_corner = corners.size() == 2 ? 0.5 : corners.size() == 3 ? -1.0 / 9.0 : -0.25;
		const double of_edge = corners.size() == 3 ? 4.0 / 9.0 : 0.5;
		const auto isIn = [&](std::uint8_t corner) { return std::ranges::find(corners, corner) != corners.end(); };
		for (const std::uint8_t corner : corners)
			add(corner, of_corner);
		for (std::size_t other = 0; other < node && corners.size() > 2; ++other)
			if (const auto& ends = cell->nodes[other]; ends.size() == 2 && isIn(ends[0]) && isIn(ends[1]))
				add(other, of_edge);
	}
	return all;
}

} // namespace vp::reader::wrapped
