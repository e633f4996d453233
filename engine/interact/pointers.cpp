#include "interact/pointers.h"

#include "base/angle.h"
#include "interact/handles.h"

#include <algorithm>
#include <cmath>

namespace vp::interact
{

namespace
{

bool isEdgeOn(const Vec3& arm, const Vec3& normal)
{
	return std::abs(glm::dot(arm, normal)) < kEdgeOn * glm::length(arm);
}

// Where a line of sight meets a plane, as `flat / weight` from a point of the plane. Behind the horizon the weight is
// negative, and `flat` stays smooth.
struct Meeting
{
	Vec3 flat;
	double weight;
};

Meeting meetingOf(const Vec3& arm, const Vec3& normal, const Vec3& sight)
{
	const double height = glm::dot(arm, normal);
	const double side = height < 0.0 ? -1.0 : 1.0;
	const double weight = side * glm::dot(sight, normal);
	return {std::abs(height) * sight - weight * arm, weight};
}

} // namespace

AxisPointer::AxisPointer(const View& view, const Vec3& through, const Vec3& axis, const glm::dvec2& start,
                         double farthest)
    : view_(view), axis_(axis), start_(start), farthest_(farthest)
{
	const Vec3 arm = through - view.camera.position;
	taken_ = glm::dot(arm, axis);
	const Vec3 across = arm - taken_ * axis;
	foot_ = glm::length(across);
	if (foot_ < kAtEye * glm::length(arm))
	{
		const double away = glm::dot(axis, view.camera.forward()) < 0.0 ? -1.0 : 1.0;
		per_pixel_up_ = away / pixelsPerLength(view, std::max(depthOf(view, through), view.camera.near));
	}
	if (foot_ > 0.0)
		towards_ = across / foot_;
}

double AxisPointer::place(const glm::dvec2& pixel) const
{
	const Vec3 sight = rayOf(view_, pixel).along;
	const double along = foot_ * glm::dot(sight, axis_);
	const double across = glm::dot(sight, towards_);
	// Beyond the horizon that is the axis' end on this side.
	if (std::abs(along) >= 2.0 * farthest_ * across)
		return std::copysign(2.0 * farthest_, along);
	return along / across;
}

double AxisPointer::moved(const glm::dvec2& pixel) const
{
	const double way = per_pixel_up_ != 0.0 ? (start_.y - pixel.y) * per_pixel_up_ : place(pixel) - place(start_);
	return std::clamp(way, -farthest_, farthest_);
}

double AxisPointer::under(const glm::dvec2& pixel) const
{
	return foot_ > 0.0 ? place(pixel) - taken_ : 0.0;
}

RingPointer::RingPointer(const View& view, const Vec3& center, const Vec3& axis, const glm::dvec2& start, double radius)
    : view_(view), arm_(center - view.camera.position), axis_(axis), start_(start), edge_on_(isEdgeOn(arm_, axis))
{
	if (!edge_on_)
		return;
	// The way in which the side turned to the eye goes.
	const Vec3 way = glm::cross(axis, -arm_);
	const glm::dvec2 on_screen(glm::dot(way, view.camera.right()), -glm::dot(way, view.camera.trueUp()));
	tangent_ = glm::normalize(on_screen) / (radius * kDegree);
}

double RingPointer::angle(const glm::dvec2& pixel) const
{
	const Vec3 flat = meetingOf(arm_, axis_, rayOf(view_, pixel).along).flat;
	const Vec3 x = probe::makeFrame(Vec3(0.0), axis_).up;
	return std::atan2(glm::dot(flat, glm::cross(axis_, x)), glm::dot(flat, x));
}

double RingPointer::moved(const glm::dvec2& pixel) const
{
	if (edge_on_)
		return glm::dot(pixel - start_, tangent_);
	return std::remainder((angle(pixel) - angle(start_)) / kDegree, 360.0);
}

PlanePointer::PlanePointer(const View& view, const Vec3& through, const Vec3& x, const Vec3& y, const glm::dvec2& start,
                           double farthest)
    : view_(view), arm_(through - view.camera.position), x_(x), y_(y), start_(start), farthest_(farthest),
      along_x_(view, through, x, start, farthest), along_y_(view, through, y, start, farthest),
      edge_on_(isEdgeOn(arm_, glm::cross(x, y)))
{
}

glm::dvec2 PlanePointer::place(const glm::dvec2& pixel) const
{
	const Meeting meeting = meetingOf(arm_, glm::cross(x_, y_), rayOf(view_, pixel).along);
	const glm::dvec2 flat(glm::dot(meeting.flat, x_), glm::dot(meeting.flat, y_));
	const double length = glm::length(flat);
	if (length == 0.0)
		return flat;
	// Beyond the horizon that is the plane's end on this side.
	if (meeting.weight * 2.0 * farthest_ <= length)
		return 2.0 * farthest_ * (flat / length);
	return flat / meeting.weight;
}

glm::dvec2 PlanePointer::moved(const glm::dvec2& pixel) const
{
	if (edge_on_)
		return {along_x_.moved(pixel), along_y_.moved(pixel)};
	return glm::clamp(place(pixel) - place(start_), glm::dvec2(-farthest_), glm::dvec2(farthest_));
}

} // namespace vp::interact
