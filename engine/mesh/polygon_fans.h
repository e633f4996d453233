#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vp::mesh
{

// Polygons are drawn as fans of triangles about their first corner. Here a polygon is its corners' places in its plane,
// counter-clockwise, in any unit.

// Returns true if the fan covers the polygon and nothing else: no triangle of it turns clockwise. A convex polygon has
// such a fan from any corner. A corner that turns by less than 1e-9 of its sides' product counts as straight.
bool isFan(std::span<const glm::dvec2> polygon);

// Parts a polygon that is none into fans, as corner numbers: into one where some corner sees all others, else by ear
// clipping (Meisters, "Polygons have ears", 1975), where ears about the same corner make one fan. What crosses itself,
// as the section of a folded cell may, has no ears in the end; the rest of it, and a polygon of more than
// kMaxEarCorners, is fanned as it is.
std::vector<std::vector<std::uint32_t>> cutIntoFans(std::span<const glm::dvec2> polygon);

// The work grows with the cube of the corners: here it is some 0.1 s.
constexpr std::size_t kMaxEarCorners = 500;

} // namespace vp::mesh
