#include "collapsed_cells.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vp::reader::cells
{

namespace
{

using Corners = std::vector<std::uint8_t>;
using Edge = std::array<std::uint8_t, 2>;

// A shape: its linear type, the quadratic type with a node on each edge, and those edges in the order of the nodes.
struct EdgedShape
{
	std::uint8_t linear;
	std::uint8_t quadratic;
	std::uint8_t corners;
	std::vector<Edge> edges;
};

const EdgedShape kEdgedTetrahedron{VTK_TETRA, VTK_QUADRATIC_TETRA, 4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
const EdgedShape kEdgedPyramid{
    VTK_PYRAMID, VTK_QUADRATIC_PYRAMID, 5, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};
const EdgedShape kEdgedWedge{
    VTK_WEDGE, VTK_QUADRATIC_WEDGE, 6, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
const EdgedShape kEdgedHexahedron{
    VTK_HEXAHEDRON,
    VTK_QUADRATIC_HEXAHEDRON,
    8,
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

// Says what a shape becomes if these corners coincide: the corners of the smaller cell, which has the same orientation.
struct Collapse
{
	const EdgedShape* to;
	std::vector<Corners> equal;
	Corners corners;
};

// A shape, the turns that map it onto itself, and what it can collapse to.
struct Collapsible
{
	const EdgedShape* shape;
	std::vector<Corners> turns; // what generates all of them
	std::vector<Collapse> collapses;
};

const std::array<Collapsible, 3> kCollapsible = {
    {{&kEdgedHexahedron,
      {{1, 2, 3, 0, 5, 6, 7, 4}, {1, 5, 6, 2, 0, 4, 7, 3}},
      {{&kEdgedTetrahedron, {{2, 3}, {4, 5, 6, 7}}, {0, 1, 2, 4}},
       {&kEdgedPyramid, {{4, 5, 6, 7}}, {0, 1, 2, 3, 4}},
       {&kEdgedWedge, {{2, 3}, {6, 7}}, {4, 5, 6, 0, 1, 2}}}},
     {&kEdgedWedge,
      {{1, 2, 0, 4, 5, 3}, {3, 5, 4, 0, 2, 1}},
      {{&kEdgedTetrahedron, {{3, 4, 5}}, {0, 2, 1, 3}},
       {&kEdgedTetrahedron, {{1, 4}, {2, 5}}, {0, 2, 1, 3}},
       {&kEdgedPyramid, {{2, 5}}, {3, 0, 1, 4, 2}}}},
     {&kEdgedPyramid, {{1, 2, 3, 0, 4}}, {{&kEdgedTetrahedron, {{2, 3}}, {0, 1, 2, 4}}}}}};

std::vector<Corners> allTurns(const Collapsible& of)
{
	Corners same;
	for (std::uint8_t c = 0; c < of.shape->corners; ++c)
		same.push_back(c);
	std::vector<Corners> turns{same};
	for (std::size_t t = 0; t < turns.size(); ++t)
		for (const Corners& turn : of.turns)
		{
			Corners next;
			for (const std::uint8_t c : turns[t])
				next.push_back(turn[c]);
			if (std::ranges::find(turns, next) == turns.end())
				turns.push_back(next);
		}
	return turns;
}

using Ids = std::vector<vtkIdType>;

// Returns true if exactly those corners coincide that the collapse says.
bool fits(const Collapse& collapse, const Corners& turn, std::span<const vtkIdType> ids)
{
	std::array<std::uint8_t, 8> first; // the first of the corners that are one
	for (std::uint8_t c = 0; c < turn.size(); ++c)
		first[c] = c;
	for (const Corners& equal : collapse.equal)
		for (const std::uint8_t c : equal)
			first[c] = equal[0];
	for (std::size_t a = 0; a < turn.size(); ++a)
		for (std::size_t b = a + 1; b < turn.size(); ++b)
			if ((ids[turn[a]] == ids[turn[b]]) != (first[a] == first[b]))
				return false;
	return true;
}

// Returns the nodes of the smaller cell. Returns nothing if edges that have become one list different nodes.
std::optional<Ids> nodesOf(const EdgedShape& from, const Collapse& collapse, const Corners& turn,
                           std::span<const vtkIdType> ids)
{
	Ids nodes;
	for (const std::uint8_t c : collapse.corners)
		nodes.push_back(ids[turn[c]]);
	if (ids.size() == from.corners)
		return nodes;
	for (const Edge& edge : collapse.to->edges)
	{
		const std::array<vtkIdType, 2> ends{nodes[edge[0]], nodes[edge[1]]};
		vtkIdType found = -1;
		for (std::size_t e = 0; e < from.edges.size(); ++e)
		{
			const std::array<vtkIdType, 2> own{ids[from.edges[e][0]], ids[from.edges[e][1]]};
			if (own != ends && own != std::array{ends[1], ends[0]})
				continue;
			const vtkIdType node = ids[from.corners + e];
			if (found >= 0 && node != found)
				return std::nullopt;
			found = node;
		}
		if (found < 0)
			return std::nullopt;
		nodes.push_back(found);
	}
	return nodes;
}

struct SmallerCell
{
	std::uint8_t type;
	Ids nodes;
};

std::optional<SmallerCell> smallerCell(const Collapsible& of, bool is_quadratic, std::span<const vtkIdType> ids)
{
	for (const Corners& turn : allTurns(of))
		for (const Collapse& collapse : of.collapses)
			if (fits(collapse, turn, ids))
				if (auto nodes = nodesOf(*of.shape, collapse, turn, ids))
					return SmallerCell{is_quadratic ? collapse.to->quadratic : collapse.to->linear, *std::move(nodes)};
	return std::nullopt;
}

bool hasEqual(std::span<const vtkIdType> corners)
{
	for (std::size_t c = 1; c < corners.size(); ++c)
		if (std::ranges::find(corners.first(c), corners[c]) != corners.begin() + static_cast<std::ptrdiff_t>(c))
			return true;
	return false;
}

} // namespace

void uncollapse(vtkUnstructuredGrid* grid, bool linear_too)
{
	vtkUnsignedCharArray* types = grid->GetCellTypesArray();
	vtkCellArray* cells = grid->GetCells();
	vtkNew<vtkIdList> list;
	vtkNew<vtkUnsignedCharArray> new_types;
	vtkNew<vtkCellArray> new_cells;
	bool any = false;
	const auto startNew = [&](vtkIdType before)
	{
		any = true;
		new_types->DeepCopy(types);
		for (vtkIdType c = 0; c < before; ++c)
		{
			cells->GetCellAtId(c, list);
			new_cells->InsertNextCell(list);
		}
	};
	const vtkIdType count = grid->GetNumberOfCells();
	for (vtkIdType c = 0; c < count; ++c)
	{
		const std::uint8_t type = types->GetValue(c);
		std::optional<SmallerCell> smaller;
		bool is_loaded = false;
		for (const Collapsible& of : kCollapsible)
		{
			const bool is_quadratic = type == of.shape->quadratic;
			if (!is_quadratic && !(linear_too && type == of.shape->linear))
				continue;
			const std::size_t nodes = of.shape->corners + (is_quadratic ? of.shape->edges.size() : 0);
			if (cells->GetCellSize(c) < static_cast<vtkIdType>(nodes))
				break;
			cells->GetCellAtId(c, list);
			is_loaded = true;
			const std::span<const vtkIdType> ids(list->GetPointer(0), nodes);
			if (hasEqual(ids.first(of.shape->corners)))
				smaller = smallerCell(of, is_quadratic, ids);
		}
		if (smaller && !any)
			startNew(c);
		if (!any)
			continue;
		if (smaller)
		{
			new_types->SetValue(c, smaller->type);
			new_cells->InsertNextCell(static_cast<vtkIdType>(smaller->nodes.size()), smaller->nodes.data());
			continue;
		}
		if (!is_loaded)
			cells->GetCellAtId(c, list);
		new_cells->InsertNextCell(list);
	}
	if (!any)
		return;
	if (grid->GetFaces())
		grid->SetCells(new_types, new_cells, grid->GetFaceLocations(), grid->GetFaces());
	else
		grid->SetCells(new_types, new_cells);
}

} // namespace vp::reader::cells
