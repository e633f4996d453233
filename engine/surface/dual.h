#pragma once

#include "base/vec.h"
#include "surface/expression_tree.h"

namespace vp::surface
{

// A value and its derivatives by x, y and z: forward automatic differentiation (Griewank and Walther 2008, chapter 3).
struct Dual
{
	double value = 0.0;
	Vec3 slope{0.0};
};

// At a place without a derivative it is that of one side (abs, min, max), or not finite (the root of 0).
Dual applied(Operation operation, int exponent, const Dual& a, const Dual& b);

} // namespace vp::surface
