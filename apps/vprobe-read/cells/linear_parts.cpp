#include "linear_parts.h"

#include "new_nodes.h"
#include "read/cell_types.h"
#include "source_cell.h"

#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <limits>

namespace vp::reader::cells
{

// Returns the number of linear cells that a cell's parts become after so many halvings.
double countParts(const CellSplit& split, int level)
{
	double pyramids = 0.0;
	double others = 0.0;
	for (const CellSplit::Part& part : split.parts)
		(part.type == read::kPyramid ? pyramids : others) += part.type == kOctahedron ? 4.0 : 1.0;
	for (; level > 0; --level)
	{
		others = 8.0 * others + 4.0 * pyramids;
		pyramids *= 6.0;
	}
	return pyramids + others;
}

const std::vector<LinearCell>& PartCutter::parts(const CellSplit& split, std::span<const Corner> points, int level)
{
	parts_.clear();
	cut(split, points, parts_);
	for (; level > 0; --level)
	{
		finer_.clear();
		for (const LinearCell& part : parts_)
			cut(halvedSplit(part.type), {part.corners.data(), static_cast<std::size_t>(pointsOf(part.type))}, finer_);
		parts_.swap(finer_);
	}
	return parts_;
}

void PartCutter::cut(const CellSplit& split, std::span<const Corner> points, std::vector<LinearCell>& parts)
{
	cut_nodes_.clear();
	for (const CellSplit::Node& node : split.nodes)
		cut_nodes_.push_back(node.point >= 0 ? points[static_cast<std::size_t>(node.point)] : middleOf(node, points));
	for (const CellSplit::Part& part : split.parts)
	{
		LinearCell cell = {part.type, {}};
		for (int i = 0; i < pointsOf(part.type); ++i)
			cell.corners[static_cast<std::size_t>(i)] = cut_nodes_[part.nodes[static_cast<std::size_t>(i)]];
		if (part.type == kOctahedron)
			cutOctahedron(cell, parts);
		else
			parts.push_back(cell);
	}
}

Corner PartCutter::middleOf(const CellSplit::Node& node, std::span<const Corner> points)
{
	// A face that has collapsed to an edge has the edge's middle, as the cells about that edge know it: each id
	// counts once.
	std::array<vtkIdType, 8> ids;
	std::size_t count = 0;
	Vec3 at(0.0);
	for (int i = 0; i < node.corner_count; ++i)
	{
		const Corner& corner = points[node.corners[static_cast<std::size_t>(i)]];
		std::size_t place = count;
		while (place > 0 && ids[place - 1] > corner.point)
			--place;
		if (place == 0 || ids[place - 1] != corner.point)
		{
			std::copy_backward(ids.begin() + place, ids.begin() + count, ids.begin() + count + 1);
			ids[place] = corner.point;
			++count;
		}
		at += corner.at / static_cast<double>(node.corner_count);
	}
	if (count == 1)
		return {ids[0], at};
	return {nodes_.between(std::span(ids).first(count), [&] { return source_.weights(at); }), at};
}

// Cuts along the shortest diagonal. If several are equally short, cuts along the first.
void PartCutter::cutOctahedron(const LinearCell& octahedron, std::vector<LinearCell>& parts)
{
	int best = 0;
	double shortest = std::numeric_limits<double>::infinity();
	for (int d = 0; d < 3; ++d)
	{
		const auto [a, b] = kOctahedronDiagonals[static_cast<std::size_t>(d)];
		const double length =
		    glm::distance(nodes_.at(octahedron.corners[a].point), nodes_.at(octahedron.corners[b].point));
		if (length < shortest * (1.0 - 1e-6))
		{
			shortest = length;
			best = d;
		}
	}
	for (const auto& four : octahedronCut(best))
	{
		LinearCell tetrahedron = {read::kTetra, {}};
		for (std::size_t i = 0; i < 4; ++i)
			tetrahedron.corners[i] = octahedron.corners[four[i]];
		parts.push_back(tetrahedron);
	}
}

} // namespace vp::reader::cells
