#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_record.glsl"
#include "render_whole.glsl"

// A vertex of a record's polygon; the indices make a fan of it.
layout(push_constant, scalar) uniform Push
{
	LayerPush push;
};
layout(constant_id = 0) const uint kFeatures = 0u;

layout(location = 0) out float value;
layout(location = 1) flat out float whole; // see render_whole.glsl
layout(location = 2) out vec2 place;      // (u, v), with a window or mesh lines
layout(location = 3) flat out ivec2 edges; // the record and its hidden edges, with mesh lines

vec4 column(float c[4])
{
	return vec4(c[0], c[1], c[2], c[3]);
}

void main()
{
	const int record = gl_VertexIndex / int(kMaxRecordVertices);
	const uint vertices = recordHead(record).y;
	// Vertices that the record does not have coincide with the first vertex.
	const uint slot = uint(gl_VertexIndex) % kMaxRecordVertices;
	const uint vertex = slot < vertices ? slot : 0u;

	const vec2 uv = recordPlace(record, vertex);
	gl_Position = uv.x * column(push.u_axis) + uv.y * column(push.v_axis) + column(push.origin);
	place = (kFeatures & (kLayerWindow | kLayerMesh)) != 0u ? uv : vec2(0.0);
	edges = ivec2(record, (kFeatures & kLayerMesh) != 0u ? int(hiddenEdges(record)) : 0);

	const vec4 low = uintBitsToFloat(texelFetch(records, record * kRecordTexels + 3));
	const vec4 high = uintBitsToFloat(texelFetch(records, record * kRecordTexels + 4));
	float values[kMaxRecordVertices] = float[](low.z, low.w, high.x, high.y, high.z, high.w);
	float least = kNanValue;
	float largest = -kNanValue;
	for (uint i = 0u; i < min(vertices, kMaxRecordVertices); ++i)
	{
		least = min(least, values[i]);
		largest = max(largest, values[i]);
	}
	whole = wholeValue(least, largest);
	value = whole == 0.0 ? values[vertex] : 0.0;
}
