#pragma once

#include "render/annotate/canvas.h"

#include <array>
#include <optional>

namespace vp::render
{

// The edge of a box along x, y or z that gets numbers, in pixels.
struct AxisEdge
{
	Vec3 from; // at the axis' low end
	Vec3 to;
	glm::dvec2 outward; // unit, away from the box
};

// Returns for each axis the edge on the outline of the box that lies farthest to the left and below. Returns nothing
// for an axis that is seen end on, or if a part of the box is behind the eye.
std::array<std::optional<AxisEdge>, 3> axisEdges(const Box& box, const Camera& camera, const Frame& frame);

// Returns true if the eye sees the outside of the box face at the low or high end of an axis.
bool facesEye(const Box& box, const Vec3& eye, int axis, bool high);

// Writes round numbers along these edges, the names of the axes with units and, for long numbers, their power of ten.
// Numbers that would cover each other or other text are left out.
void writeBoxAxes(const Box& box, const Camera& camera, const Layout& layout, const std::string& units, Canvas& pen);

} // namespace vp::render
