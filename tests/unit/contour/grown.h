#pragma once

#include "contour/box_contour.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <cmath>
#include <functional>
#include <string>

namespace vp::test
{

const inline grid::FieldChoice kHills{"hills", grid::Association::point, 0};

// The block with a point field "hills" besides, a function of the place.
inline grid::Block withHills(grid::Block block, const std::function<double(const Vec3&)>& height)
{
	std::vector<double> hills;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          hills.resize(grid.pointCount());
		          for (PointId p = 0; p < hills.size(); ++p)
			          hills[grid.sourcePoint(p)] = height(grid.point(p));
	          });
	block.fields.push_back(grid::makeField("hills", grid::Association::point, 1, std::move(hills)));
	return block;
}

// Several hills and valleys over a block's bounds.
inline grid::Block withHills(const grid::Block& block)
{
	const Box bounds = visitGrid(block,
	                             [](const auto& grid)
	                             {
		                             Box box;
		                             for (PointId p = 0; p < grid.pointCount(); ++p)
			                             box.include(grid.point(p));
		                             return box;
	                             });
	return withHills(block,
	                 [bounds](const Vec3& p)
	                 {
		                 const Vec3 u = (p - bounds.lo) / bounds.size();
		                 return std::sin(7.0 * u.x) * std::cos(6.0 * u.y) + 0.6 * std::sin(5.0 * u.z + 2.0 * u.x);
	                 });
}

// A sheet, its cut, and what grows from it.
struct SheetOfHills
{
	SheetOfHills(cut::Cutter& cutter, const TestPlane& plane, const std::optional<probe::Window>& window,
	             std::optional<double> depth)
	    : cut(test::cut(cutter, plane, {}, Search::fastest, window)),
	      contourer(
	          [&]
	          {
		          cut.slice.field = kHills;
		          return contour::BoxContourer(cutter, cut.slice, cut.mesh, depth);
	          }())
	{
	}
	SheetOfHills(const SheetOfHills&) = delete;

	SlicedSheet cut;
	contour::BoxContourer contourer;
};

} // namespace vp::test
