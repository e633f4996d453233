#pragma once

#include "surface/expression.h"

#include <string>

namespace vp::surface
{

// The definition of surfaceAt() for shaders/classify_surface.glsl: f with a bound on its error, in the words of
// shaders/bounded.glsl. It is written from the tree that was parsed, never from the text: only known operations, places
// of nodes and the bits of numbers get into it.
std::string glslOf(const Expression& expression);

// How long what glslOf() gives takes a driver to compile, about: sums and products count 1.
int shaderCost(const Expression& expression);

} // namespace vp::surface
