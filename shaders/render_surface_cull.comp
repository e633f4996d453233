#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

// Marks the triangles of an opaque surface that later samples of a picture may show: those that touch a pixel at an edge, and are not
// behind what the first sample has found at all pixels that it reaches. A bit stands for a triangle.
layout(local_size_x = kCullGroupSize) in;
layout(binding = 0) uniform usamplerBuffer triangles;
layout(binding = 1) uniform samplerBuffer vertices;
layout(binding = 2) uniform sampler2D mask;   // below 0.5 at an edge
layout(binding = 3) uniform sampler2D depths; // near / w of the first sample
layout(binding = 4, scalar) buffer Kept
{
	uint kept[];
};
layout(push_constant, scalar) uniform Push
{
	SurfaceCullPush push;
};

// Larger triangles are drawn without a look at their pixels.
const int kMaxPixels = 64;
// Pixels by which corners may be elsewhere once they are snapped.
const float kSlack = 1.0 / 64.0;
// A factor on depths, for rounding.
const float kNearer = 1.0001;

vec4 column(uint i)
{
	return vec4(push.clip[4u * i], push.clip[4u * i + 1u], push.clip[4u * i + 2u], push.clip[4u * i + 3u]);
}

// Place in pixels, and w.
vec3 placed(uint corner)
{
	const vec4 vertex = texelFetch(vertices, int(corner & ~kHiddenEdge));
	const vec4 at = vertex.x * column(0u) + vertex.y * column(1u) + vertex.z * column(2u) + column(3u);
	return vec3((0.5 * at.xy / at.w + 0.5) * vec2(push.width, push.height), at.w);
}

bool isNeeded(uvec4 head)
{
	const vec3 a = placed(head.x);
	const vec3 b = placed(head.y);
	const vec3 c = placed(head.z);
	const float nearest_w = min(a.z, min(b.z, c.z));
	const ivec2 end = ivec2(push.width, push.height) - 1;
	// Beyond the picture all numbers will do.
	const vec2 far = vec2(end) + 2.0;
	const ivec2 first = ivec2(floor(clamp(min(a.xy, min(b.xy, c.xy)) - kSlack, vec2(-1.0), far)));
	const ivec2 last = ivec2(floor(clamp(max(a.xy, max(b.xy, c.xy)) + kSlack, vec2(-1.0), far)));
	const bool in_front = nearest_w > push.near_w * kNearer;
	const ivec2 from = max(first, ivec2(0));
	const ivec2 to = min(last, end);
	const ivec2 size = to - from + 1;
	const bool seen = all(greaterThan(size, ivec2(0)));
	const bool large = size.x > kMaxPixels || size.y > kMaxPixels || size.x * size.y > kMaxPixels;
	if (!in_front || (seen && large))
		return true;
	ivec2 at = from;
	bool edge = false;
	float farthest = 1.0;
	const int rounds = seen ? size.x * size.y : 0;
	for (int i = 0; i < rounds; ++i)
	{
		const ivec2 pixel = min(at, end);
		farthest = min(farthest, texelFetch(depths, pixel, 0).x);
		edge = edge || texelFetch(mask, pixel, 0).x < 0.5;
		at = at.x >= to.x ? ivec2(from.x, at.y + 1) : ivec2(at.x + 1, at.y);
	}
	return edge && push.near_w * kNearer >= farthest * nearest_w;
}

void main()
{
	const uint triangle = gl_GlobalInvocationID.x;
	if (triangle >= push.count)
		return;
	if (isNeeded(texelFetch(triangles, int(triangle * kSurfaceTexels))))
		atomicOr(kept[push.first_word + triangle / 32u], 1u << (triangle & 31u));
}
