#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

// A segment as a quad of constant width in pixels. Its depth is near / w, linear in the picture, as the sheets' is.
layout(binding = 0, scalar) readonly buffer Segments
{
	LineSegment segments[];
};
layout(push_constant, scalar) uniform Push
{
	LinePush push;
};

vec4 clipped(float p[3])
{
	const mat4 clip = mat4(push.clip[0], push.clip[1], push.clip[2], push.clip[3], push.clip[4], push.clip[5], push.clip[6],
						   push.clip[7], push.clip[8], push.clip[9], push.clip[10], push.clip[11], push.clip[12],
						   push.clip[13], push.clip[14], push.clip[15]);
	return clip * vec4(p[0], p[1], p[2], 1.0);
}

// Moves an end that lies before the near plane onto it.
vec4 inFront(vec4 end, vec4 other)
{
	if (end.w >= push.near_w || other.w <= push.near_w)
		return end;
	return mix(end, other, (push.near_w - end.w) / (other.w - end.w));
}

void main()
{
	const uint corner = uint(gl_VertexIndex) % kSegmentCorners;
	const LineSegment segment = segments[uint(gl_VertexIndex) / kSegmentCorners];
	const vec4 clip_a = clipped(segment.a);
	const vec4 clip_b = clipped(segment.b);
	const vec4 a = inFront(clip_a, clip_b);
	const vec4 b = inFront(clip_b, clip_a);
	if (max(clip_a.w, clip_b.w) <= push.near_w)
	{
		gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
		return;
	}
	const vec2 half_size = vec2(push.half_size[0], push.half_size[1]);
	const vec2 pixel_a = a.xy / a.w * half_size;
	const vec2 pixel_b = b.xy / b.w * half_size;
	const vec2 way = pixel_b - pixel_a;
	const float way_length = length(way);
	const vec2 along = way_length > 1e-6 ? way / way_length : vec2(1.0, 0.0);
	const vec2 across = vec2(-along.y, along.x);

	// Corners 0 1 2, 2 1 3: a left, a right, b left, b right. The ends reach on by half a width, which joins curves.
	const uint quad = corner < 3u ? corner : (corner == 3u ? 2u : (corner == 4u ? 1u : 3u));
	const bool at_b = quad >= 2u;
	const float side = (quad & 1u) == 0u ? -1.0 : 1.0;
	const vec4 end = at_b ? b : a;
	const vec2 offset = push.half_width * (side * across + (at_b ? along : -along));
	gl_Position = vec4(end.xy + offset / half_size * end.w, push.near_w * push.depth_bias, end.w);
}
