#include "render/scene/outline.h"

#include "render/scene/farthest_points.h"
#include "render/scene/feature_edges.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::render
{

namespace
{

void addSegment(const Vec3& a, const Vec3& b, std::vector<Segment>& segments)
{
	if (a != b)
		segments.push_back({a, b});
}

void addBox(const Box& box, std::vector<Segment>& segments)
{
	if (box.empty())
		return;
	for (int i = 0; i < 8; ++i)
		for (const int bit : {1, 2, 4})
			if (!(i & bit))
				addSegment(corner(box, i), corner(box, i | bit), segments);
}

void addIndexBox(const grid::CurvilinearGrid& grid, std::vector<Segment>& segments)
{
	for (const std::vector<Vec3>& curve : edgeCurves(grid))
		for (std::size_t i = 1; i < curve.size(); ++i)
			addSegment(curve[i - 1], curve[i], segments);
}

// Up to so many faces their points are taken; of more, the boxes of their patches are close enough and far fewer.
constexpr std::size_t kFacesAsPoints = 100'000;

template <class G>
void addBoundaryPoints(const G& grid, const grid::BoundaryIndex& boundary, std::vector<Vec3>& points)
{
	std::vector<PointId> ids;
	grid::CellFaces faces;
	for (const auto& face : boundary.faces)
	{
		grid.cellFaces(face.cell, faces);
		const auto of_face = faces[static_cast<int>(face.face)];
		ids.insert(ids.end(), of_face.begin(), of_face.end());
	}
	std::sort(ids.begin(), ids.end());
	ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
	for (const PointId p : ids)
		points.push_back(grid.point(p));
}

} // namespace

Vec3 corner(const Box& box, int i)
{
	return {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z};
}

EdgeCurves edgeCurves(const grid::CurvilinearGrid& grid)
{
	EdgeCurves curves;
	const auto points = grid.points();
	if (grid.cellCount() == 0)
		return curves;
	for (int axis = 0; axis < 3; ++axis)
	{
		const int other = (axis + 1) % 3;
		const int third = (axis + 2) % 3;
		for (int side = 0; side < 4; ++side)
		{
			std::array<std::uint32_t, 3> at{};
			at[other] = side & 1 ? points[other] - 1 : 0;
			at[third] = side & 2 ? points[third] - 1 : 0;
			for (; at[axis] < points[axis]; ++at[axis])
				curves[static_cast<std::size_t>(4 * axis + side)].push_back(
				    grid.point(grid.pointId(at[0], at[1], at[2])));
		}
	}
	return curves;
}

std::vector<Segment> outlineOf(const grid::BlockSet& blocks, Outline outline)
{
	std::vector<Segment> segments;
	for (const grid::Block& block : blocks.blocks)
	{
		if (outline == Outline::edges)
			addFeatureEdges(block, segments);
		else if (outline == Outline::box)
		{
			if (const auto* curved = std::get_if<grid::CurvilinearGrid>(&block.grid))
				addIndexBox(*curved, segments);
			else
				addBox(block.bounds, segments);
		}
	}
	if (outline == Outline::edges)
		putInOrder(segments);
	return segments;
}

std::vector<Vec3> extentOf(const grid::BlockSet& blocks)
{
	std::vector<Vec3> points = farthestPoints(blocks);
	const auto addCorners = [&points](const Box& box)
	{
		if (!box.empty())
			for (int i = 0; i < 8; ++i)
				points.push_back(corner(box, i));
	};
	for (const grid::Block& block : blocks.blocks)
	{
		if (std::holds_alternative<grid::UnstructuredGrid>(block.grid))
			continue;
		// A box is its corners; anything else is inside its boundary.
		const bool is_box = std::holds_alternative<grid::UniformGrid>(block.grid) ||
		                    std::holds_alternative<grid::RectilinearGrid>(block.grid) || block.boundary.patches.empty();
		if (is_box)
			addCorners(block.bounds);
		else if (block.boundary.faces.size() <= kFacesAsPoints)
			std::visit([&](const auto& grid) { addBoundaryPoints(grid, block.boundary, points); }, block.grid);
		else
			for (const auto& patch : block.boundary.patches)
				addCorners(patch.box);
	}
	return points;
}

} // namespace vp::render
