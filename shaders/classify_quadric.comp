#version 460
#extension GL_GOOGLE_include_directive : require
#include "classify_surface.glsl"

Bounded coefficient(uint which)
{
	return Bounded(lane.coefficient[which], lane.coefficient_error[which]);
}

// By powers of x, each with what stands beside it.
Bounded surfaceAt(Bounded x, Bounded y, Bounded z)
{
	const Bounded by_x = sumOf(sumOf(coefficient(1u), productOf(coefficient(4u), x)),
	                           sumOf(productOf(coefficient(7u), y), productOf(coefficient(9u), z)));
	const Bounded by_y =
		sumOf(sumOf(coefficient(2u), productOf(coefficient(5u), y)), productOf(coefficient(8u), z));
	const Bounded by_z = sumOf(coefficient(3u), productOf(coefficient(6u), z));
	return sumOf(sumOf(coefficient(0u), productOf(by_x, x)), sumOf(productOf(by_y, y), productOf(by_z, z)));
}
