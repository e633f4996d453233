#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"

// A vertex of a record's polygon; the indices make a fan of it. Records are read as texels, five of four words each: software
// reads those faster than a storage buffer.
layout(binding = 0) uniform usamplerBuffer records;
layout(push_constant, scalar) uniform Push
{
	LayerPush push;
};

layout(location = 0) out float value;
layout(location = 1) flat out uint is_nan;

const int kTexels = 5;
const float kNanFrom = 0.5 * kNanValue;

vec4 column(float c[4])
{
	return vec4(c[0], c[1], c[2], c[3]);
}

void main()
{
	const int record = gl_VertexIndex / int(kMaxRecordVertices);
	const uint vertices = texelFetch(records, record * kTexels).y;
	// What is not there falls together with the first vertex.
	const uint slot = uint(gl_VertexIndex) % kMaxRecordVertices;
	const uint vertex = slot < vertices ? slot : 0u;

	const uvec4 uv_texel = texelFetch(records, record * kTexels + int((vertex + 1u) >> 1));
	const vec2 uv = uintBitsToFloat((vertex & 1u) == 0u ? uv_texel.zw : uv_texel.xy);
	gl_Position = uv.x * column(push.u_axis) + uv.y * column(push.v_axis) + column(push.origin);

	// A polygon with a NaN (or an infinity) has no value anywhere: nothing could be interpolated towards that vertex.
	const vec4 low = uintBitsToFloat(texelFetch(records, record * kTexels + 3));
	const vec4 high = uintBitsToFloat(texelFetch(records, record * kTexels + 4));
	is_nan = 0u;
	float values[kMaxRecordVertices] = float[](low.z, low.w, high.x, high.y, high.z, high.w);
	for (uint i = 0u; i < kMaxRecordVertices; ++i)
		if (i < vertices && !(abs(values[i]) < kNanFrom))
			is_nan = 1u;
	value = is_nan == 0u ? values[vertex] : 0.0;
}
