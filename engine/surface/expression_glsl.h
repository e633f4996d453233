#pragma once

#include "surface/expression.h"

#include <string>

namespace vp::surface
{

// Returns the definition of surfaceAt() for shaders/classify_surface.glsl. It computes f and a bound on its error, with
// the types of shaders/bounded.glsl. It is written from the parsed tree, never from the text: only known operations,
// node indices and the bits of numbers get into it.
std::string glslOf(const Expression& expression);

// Estimates how long a driver takes to compile the result of glslOf(). Sums and products count 1.
int shaderCost(const Expression& expression);

} // namespace vp::surface
