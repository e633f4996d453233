#pragma once

#include "base/ids.h"
#include "grid/field.h"
#include "grid/shown_value.h"
#include "surface/placed_expression.h"
#include "surface/plane.h"
#include "surface/quadric.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

namespace vp::surface
{

class LeafValues;

// A cutting surface that is not a plane and has a place in the world.
using Curved = std::variant<Quadric, PlacedExpression>;

// The surface where an array of a block has one value.
struct BlockValues
{
	const grid::Field* field; // a point array; it must outlive this
	int component;            // 0.. or grid::kMagnitude
	double value;
	std::shared_ptr<const LeafValues> leaves; // values of the leaves of the block's tree; or null

	template <class G>
	double height(const G& grid, PointId p) const
	{
		return grid::shownValue(*field, grid.sourcePoint(p), component) - value;
	}
};

// A cutting surface that is not a plane, for one block. S = 1 at a point if the height is not negative. NaN counts as
// negative. The height of a point is one expression in double, the same for every cell around it.
class BlockSurface
{
public:
	using Kind = std::variant<Quadric, PlacedExpression, BlockValues>;

	explicit BlockSurface(Kind kind) : kind_(std::move(kind)) {}

	template <class G>
	double height(const G& grid, PointId p) const
	{
		if (const auto* values = std::get_if<BlockValues>(&kind_))
			return values->height(grid, p);
		if (const auto* quadric = std::get_if<Quadric>(&kind_))
			return quadric->height(grid.point(p));
		return std::get<PlacedExpression>(kind_).height(grid.point(p));
	}
	// Writes the height of each point, of at most kMaxPoints. `heights` must have room for them.
	static constexpr std::size_t kMaxPoints = 64;
	template <class G>
	void heights(const G& grid, std::span<const PointId> points, double* heights) const
	{
		if (const BlockValues* of_values = values())
		{
			for (std::size_t i = 0; i < points.size(); ++i)
				heights[i] = of_values->height(grid, points[i]);
			return;
		}
		std::array<Vec3, kMaxPoints> places;
		for (std::size_t i = 0; i < points.size(); ++i)
			places[i] = grid.point(points[i]);
		if (const Quadric* form = quadric())
			for (std::size_t i = 0; i < points.size(); ++i)
				heights[i] = form->height(places[i]);
		else
			expression()->heightsAt({places.data(), points.size()}, heights);
	}
	// Returns the place of the surface on the way from a to b, 0 to 1. It is the root for a surface with a place, and
	// is found by linear interpolation for values. The place from b to a is 1 minus this one, to the last bit. The
	// heights must have different signs.
	double crossing(const Vec3& a, const Vec3& b, double height_a, double height_b) const;
	// Returns true if the surface may pass through the box, its rim included. Always true for values.
	bool meets(const Box& box) const;

	// Returns the height of any place, nothing for values.
	std::optional<double> heightAt(const Vec3& place) const;

	const BlockValues* values() const { return std::get_if<BlockValues>(&kind_); }
	const Quadric* quadric() const { return std::get_if<Quadric>(&kind_); }
	const PlacedExpression* expression() const { return std::get_if<PlacedExpression>(&kind_); }

private:
	Kind kind_;
};

// The height of a point over a cutting surface of any kind, and the place where an edge from a to b meets the surface.
template <class G>
double heightAt(const G& grid, const Plane& plane, PointId p)
{
	return plane.signedDistance(grid.point(p));
}
template <class G>
double heightAt(const G& grid, const BlockSurface& surface, PointId p)
{
	return surface.height(grid, p);
}

inline double crossingOf(const Plane&, const Vec3&, const Vec3&, double height_a, double height_b)
{
	return Plane::crossing(height_a, height_b);
}
inline double crossingOf(const BlockSurface& surface, const Vec3& a, const Vec3& b, double height_a, double height_b)
{
	return surface.crossing(a, b, height_a, height_b);
}

// True if polygons in the surface may be bent.
template <class Surface>
constexpr bool kIsCurved = !std::is_same_v<Surface, Plane>;

} // namespace vp::surface
