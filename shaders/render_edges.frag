#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"

// Finds the pixels at which the first sample of a picture does not stand for all: their color departs from the line between those on
// both sides. A straight edge through a pixel always has the middle of a neighbor on its other side.
layout(binding = 0) uniform sampler2D sum; // the first sample, multiplied by alpha

vec4 departure(vec4 here, ivec2 pixel, ivec2 step)
{
	const ivec2 last = textureSize(sum, 0) - 1;
	return abs(texelFetch(sum, max(pixel - step, ivec2(0)), 0) + texelFetch(sum, min(pixel + step, last), 0) - 2.0 * here);
}

void main()
{
	const ivec2 pixel = ivec2(gl_FragCoord.xy);
	const vec4 here = texelFetch(sum, pixel, 0);
	const vec4 most = max(departure(here, pixel, ivec2(1, 0)), departure(here, pixel, ivec2(0, 1)));
	const float edge = max(max(most.r, most.g), max(most.b, most.a)) > kEdgeFrom ? 1.0 : 0.0;
	// And the pixels beside it that the device colors together with it: edges that are thinner than a pixel may be missed by a sample.
	gl_FragDepth = edge + fwidth(edge) > 0.0 ? 0.0 : 1.0;
}
