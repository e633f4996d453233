#pragma once

#include "base/vec.h"

#include <array>
#include <span>

// Bernstein's polynomials of each node of a Bezier cell. `simplex`: so many of its axes span a triangle or a
// tetrahedron, 0 of a hexahedron. `nodes`: their places, from 0 to 1. VTK's functions take seconds for some cells of
// degree 8.
void weighBezier(int simplex, const std::array<int, 3>& degrees, std::span<const vp::Vec3> nodes, const vp::Vec3& at,
                 std::span<double> weights);
