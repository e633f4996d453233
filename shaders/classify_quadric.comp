#version 460
#extension GL_GOOGLE_include_directive : require
#include "classify_surface.glsl"

Bounded coefficient(uint which)
{
	return Bounded(sheet.coefficient[which], sheet.coefficient_error[which]);
}

Bounded surfaceAt(Bounded x, Bounded y, Bounded z)
{
	const Bounded by_x = sumOf(sumOf(coefficient(6u), productOf(coefficient(0u), x)),
	                           sumOf(productOf(coefficient(3u), y), productOf(coefficient(4u), z)));
	const Bounded by_y =
		sumOf(sumOf(coefficient(7u), productOf(coefficient(1u), y)), productOf(coefficient(5u), z));
	const Bounded by_z = sumOf(coefficient(8u), productOf(coefficient(2u), z));
	return sumOf(sumOf(coefficient(9u), productOf(by_x, x)), sumOf(productOf(by_y, y), productOf(by_z, z)));
}
