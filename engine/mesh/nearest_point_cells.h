#pragma once

#include "base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::mesh
{

/// A point of a cell, with what it stands for.
struct ValuedPoint
{
	Vec3 place;
	double value;
};

/// Parts polygons between points, one polygon after the other. The parts are those of the points' Voronoi diagram;
/// parts of one value are joined.
class NearestPointCells
{
public:
	/// A corner of a part.
	struct Corner
	{
		Vec3 place;
		int vertex;   // the polygon's corner at this place, or -1
		int sides[2]; // the polygon's sides that it lies on, or -1: side i goes from corner i to the next one
	};
	struct Part
	{
		std::vector<std::uint32_t> corners; // into corners(), in the polygon's sense
		double value;
	};

	/// Parts a polygon. If two points are as near, the one with the lesser value is preferred. A polygon that is not
	/// convex is parted as the triangles about its mean.
	void part(std::span<const Vec3> polygon, std::span<const ValuedPoint> points);

	const std::vector<Corner>& corners() const { return corners_; }
	const std::vector<Part>& parts() const { return parts_; }

	/// Returns the side of the polygon that the way between two corners lies on, or -1 if it lies within.
	static int sharedSide(const Corner& a, const Corner& b);

private:
	using Loop = std::vector<std::uint32_t>;

	void addRegion(const Loop& whole, std::span<const ValuedPoint> points, std::size_t nearest);
	bool clip(Loop& loop, const ValuedPoint& kept, const ValuedPoint& other, bool prefers_kept);
	std::uint32_t cornerBetween(std::uint32_t a, std::uint32_t b, double part);
	Vec3 doubleArea(const Loop& loop) const;
	void dropNeedlessCorners(Loop& loop) const;
	void join();

	std::vector<Corner> corners_;
	std::vector<Part> parts_;
	std::vector<double> along_; // per corner of a loop: how far it lies beyond the middle between two points
	Loop clipped_;
	double tolerance_ = 0.0; // lengths below it are rounding
	double least_area_ = 0.0;
};

} // namespace vp::mesh
