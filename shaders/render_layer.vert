#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"

// A record's polygon as a fan about its first vertex. Records are read as texels: five of four words each.
layout(binding = 0) uniform usamplerBuffer records;
layout(push_constant, scalar) uniform Push
{
	LayerPush push;
};

layout(location = 0) out float value;
layout(location = 1) flat out uint is_nan;

const int kTexels = 5;
const float kNanFrom = 0.5 * kNanValue;

uint word(int record, uint index)
{
	return texelFetch(records, record * kTexels + int(index >> 2))[index & 3u];
}

vec4 column(float c[4])
{
	return vec4(c[0], c[1], c[2], c[3]);
}

void main()
{
	const int record = gl_VertexIndex / int(kRecordCorners);
	const uint corner = uint(gl_VertexIndex) % kRecordCorners;
	const uint triangle = corner / 3u;
	const uvec4 head = texelFetch(records, record * kTexels);
	const uint vertices = head.y;
	value = 0.0;
	is_nan = 0u;
	if (triangle + 2u >= vertices)
	{
		gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
		return;
	}
	const uint in_triangle = corner % 3u;
	const uint vertex = in_triangle == 0u ? 0u : triangle + in_triangle;

	const uvec4 uv_texel = texelFetch(records, record * kTexels + int((vertex + 1u) >> 1));
	const vec2 uv = uintBitsToFloat((vertex & 1u) == 0u ? uv_texel.zw : uv_texel.xy);
	gl_Position = uv.x * column(push.u_axis) + uv.y * column(push.v_axis) + column(push.origin);

	// A polygon with a NaN has no value anywhere: nothing could be interpolated towards that vertex.
	const vec4 low = uintBitsToFloat(texelFetch(records, record * kTexels + 3));
	const vec4 high = uintBitsToFloat(texelFetch(records, record * kTexels + 4));
	float values[kMaxRecordVertices] = float[](low.z, low.w, high.x, high.y, high.z, high.w);
	for (uint i = 0u; i < kMaxRecordVertices; ++i)
		if (i < vertices && values[i] >= kNanFrom)
			is_nan = 1u;
	value = is_nan == 0u ? values[vertex] : 0.0;
}
