#pragma once

#include "interact/view.h"

namespace vp::interact
{

// These classes turn the way of a pointer over the picture into a move along an axis, about an axis, or in a plane.
// Each begins at a pixel, and tells how far another pixel is from there. Nothing depends on the pixels between, so
// nothing drifts. `farthest` bounds the move: on screen, a plane and an axis end at their horizon, which a pointer can
// reach and cross.

class AxisPointer
{
public:
	// through: the point that was taken. axis: unit.
	AxisPointer(const View& view, const Vec3& through, const Vec3& axis, const glm::dvec2& start, double farthest);

	// Along the axis. A pixel beside the axis counts as the one on it that is seen in the same plane across the eye and
	// the axis. Where the axis points at the eye (kAtEye), up is away from the eye, at the scale of the point taken.
	double moved(const glm::dvec2& pixel) const;

	// The place under a pixel, from the point that was taken, however the axis lies; 0 where it runs through the eye.
	double under(const glm::dvec2& pixel) const;

private:
	double place(const glm::dvec2& pixel) const; // along the axis from the foot of the eye's perpendicular

	View view_;
	Vec3 axis_;
	glm::dvec2 start_;
	double farthest_;
	double taken_;              // the place of the point taken
	double foot_ = 0.0;         // from the eye to the axis
	Vec3 towards_{0.0};         // unit, that way
	double per_pixel_up_ = 0.0; // where the axis points at the eye, else 0
};

class RingPointer
{
public:
	// center: in front of the eye. axis: unit. radius: of the ring on screen, in pixels.
	RingPointer(const View& view, const Vec3& center, const Vec3& axis, const glm::dvec2& start, double radius);

	// Degrees about the axis, -180 to 180, as seen in the ring's plane. Where that is seen edge on (kEdgeOn), along the
	// tangent of the ring's near side.
	double moved(const glm::dvec2& pixel) const;

private:
	double angle(const glm::dvec2& pixel) const; // radians

	View view_;
	Vec3 arm_; // from the eye to the center
	Vec3 axis_;
	glm::dvec2 start_;
	glm::dvec2 tangent_{0.0}; // where seen edge on: degrees per pixel along it
	bool edge_on_;
};

class PlanePointer
{
public:
	// through: the point that was taken, in front of the eye. x, y: unit, at right angles, in the plane.
	PlanePointer(const View& view, const Vec3& through, const Vec3& x, const Vec3& y, const glm::dvec2& start,
	             double farthest);

	// Along x and y. Where the plane is seen edge on (kEdgeOn), as two axes.
	glm::dvec2 moved(const glm::dvec2& pixel) const;

private:
	glm::dvec2 place(const glm::dvec2& pixel) const; // from the point taken

	View view_;
	Vec3 arm_; // from the eye to the point taken
	Vec3 x_;
	Vec3 y_;
	glm::dvec2 start_;
	double farthest_;
	AxisPointer along_x_;
	AxisPointer along_y_;
	bool edge_on_;
};

} // namespace vp::interact
