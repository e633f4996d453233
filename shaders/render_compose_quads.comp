#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#define QUADS
#include "render_compose.glsl"

// A later sample of a picture without surfaces, at the pixels where it may differ from the first. The last sample puts the mean into the
// picture, which holds the first.
layout(local_size_x = kQuadGroupSize) in;
layout(binding = 5, scalar) readonly buffer Quads
{
	QuadList list;
	uint quads[];
};
layout(binding = 6, scalar) buffer Sums
{
	uvec2 sums[]; // sums of weighted samples, 16 bits a channel; four pixels a quad
};
layout(binding = 7, rgba8) uniform image2D picture;

void main()
{
	const uint group = gl_WorkGroupID.y * kQuadGroupsAcross + gl_WorkGroupID.x;
	const uint at = group * kQuadGroupSize + gl_LocalInvocationID.x;
	if (at >= 4u * list.count)
		return;
	const uint quad = quads[at >> 2];
	const ivec2 pixel = 2 * ivec2(quad & 0xFFFFu, quad >> 16) + ivec2(at & 1u, (at >> 1) & 1u);
	if (any(greaterThanEqual(pixel, imageSize(picture)))) // true only if the picture's size is odd
		return;
	compose(pixel);
	vec4 sum = params.sample_weight * front;
	if (push.number > 1u)
		sum += vec4(unpackUnorm2x16(sums[at].x), unpackUnorm2x16(sums[at].y));
	if (push.number == push.last_number)
		imageStore(picture, pixel, sum + params.sample_weight * imageLoad(picture, pixel));
	else
		sums[at] = uvec2(packUnorm2x16(sum.rg), packUnorm2x16(sum.ba));
}
