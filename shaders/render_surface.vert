#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_whole.glsl"

// A corner of a triangle of a surface. It is found by its number, without an index buffer.
layout(binding = 0) uniform usamplerBuffer triangles;
layout(binding = 1) uniform samplerBuffer vertices;
layout(binding = 7) uniform samplerBuffer across_edges; // values across edges; with kSurfacePolygonValues
layout(push_constant, scalar) uniform Push
{
	SurfacePush push;
};
layout(constant_id = 0) const uint kFeatures = 0u;

const uint kLinesBetween = kSurfacePolygonValues | kComposeLines;

layout(location = 0) out float value;
layout(location = 1) flat out float whole; // see render_whole.glsl
layout(location = 2) out vec3 to_eye;
layout(location = 3) out vec3 normal;
layout(location = 4) out vec2 place;       // (0, 0), (1, 0), (0, 1) at the corners
layout(location = 5) flat out uint hidden; // bit k: the edge from corner k on is none of the polygon's
layout(location = 6) flat out float width;
layout(location = 7) flat out vec3 across; // values beyond the edges, with contour lines between polygons

vec4 column(uint i)
{
	return vec4(push.clip[4u * i], push.clip[4u * i + 1u], push.clip[4u * i + 2u], push.clip[4u * i + 3u]);
}

// Meyer et al., "On Floating-Point Normal Vectors" (2010).
vec3 octahedral(uint packed)
{
	const vec2 p = unpackSnorm2x16(packed);
	vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
	const float below = max(-n.z, 0.0);
	n.xy += vec2(n.x >= 0.0 ? -below : below, n.y >= 0.0 ? -below : below);
	return normalize(n);
}

void main()
{
	const int triangle = gl_VertexIndex / 3;
	const int corner = gl_VertexIndex - 3 * triangle;
	const uvec4 head = texelFetch(triangles, triangle * int(kSurfaceTexels));
	const uvec4 tail = texelFetch(triangles, triangle * int(kSurfaceTexels) + 1);
	const vec4 vertex = texelFetch(vertices, int(head[corner] & ~kHiddenEdge));

	gl_Position = vertex.x * column(0u) + vertex.y * column(1u) + vertex.z * column(2u) + column(3u);
	gl_Position.z = push.near_w;
	const float of_polygon = uintBitsToFloat(head.w);
	whole = wholeValue(of_polygon, of_polygon);
	value = whole != 0.0 ? 0.0 : (kFeatures & kSurfacePolygonValues) != 0u ? of_polygon : vertex.w;
	to_eye = vec3(push.eye[0], push.eye[1], push.eye[2]) - vertex.xyz;
	normal = octahedral(tail[corner]);
	place = vec2(corner == 1, corner == 2);
	hidden = (head.x >> 31) | (head.y >> 31) << 1 | (head.z >> 31) << 2;
	width = uintBitsToFloat(tail.w);
	across = (kFeatures & kLinesBetween) == kLinesBetween ? texelFetch(across_edges, triangle).xyz : vec3(0.0);
}
