#pragma once

#include "render/annotate/canvas.h"

#include <array>
#include <optional>

namespace vp::render
{

// The edge of a box along x, y or z that carries the numbers, in pixels.
struct AxisEdge
{
	Vec3 from; // at the axis' low end
	Vec3 to;
	glm::dvec2 outward; // unit, away from the box
};

// For each axis the edge on the box' contour in the picture that lies farthest to the left and below; none where the
// axis is seen end on, or the box is not all in front of the eye.
std::array<std::optional<AxisEdge>, 3> axisEdges(const Box& box, const Camera& camera, const Frame& frame);

// Whether the eye sees the outside of the face of the box at the low or high end of an axis.
bool facesEye(const Box& box, const Vec3& eye, int axis, bool high);

// Round numbers along these edges, the axes' names with their units and, where numbers are long, their power of ten.
// Numbers that would lie on each other or on what else is written are left out.
void writeBoxAxes(const Box& box, const Camera& camera, const Layout& layout, const std::string& units, Canvas& pen);

} // namespace vp::render
