#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_record.glsl"
#include "render_whole.glsl"
#include "render_place.glsl"

// A vertex of a record's polygon; the indices make a fan of it.
layout(push_constant, scalar) uniform Push
{
	LayerPush push;
};
layout(constant_id = 0) const uint kFeatures = 0u;

layout(binding = 1, scalar) readonly buffer Listed
{
	uint listed[];
};

layout(location = 0) out float value;
layout(location = 1) flat out float whole; // see render_whole.glsl
layout(location = 2) out vec2 place;      // (u, v), with a window or mesh lines
layout(location = 3) flat out ivec2 edges; // the record and its hidden edges, with mesh lines

const float kFarOutside = 4194304.0; // subpixels: beyond them single precision has too few digits for what follows

vec4 column(float c[4])
{
	return vec4(c[0], c[1], c[2], c[3]);
}

// Where the compute rasterizer would put it, in clip space; behind the near plane or far outside of the picture where it is.
vec4 listedPlace(vec2 uv)
{
	const vec3 at = placeTimesW(uv, column(push.u_axis).xyw, column(push.v_axis).xyw, column(push.origin).xyw);
	const vec2 size = vec2(push.size[0], push.size[1]);
	const vec2 place = snapped(at);
	const bool snaps = at.z > push.origin[2] && max(abs(place.x), abs(place.y)) < kFarOutside;
	const vec2 shown = (snaps ? place * at.z : at.xy) / float(kSubpixels) + 0.5 * at.z;
	return vec4(2.0 * shown / size - at.z, push.origin[2], at.z);
}

// A polygon of many corners comes as several records, cut along diagonals from its first corner, which are no edges of it. Bit 0:
// the record's first edge is such a diagonal, bit 1: its last one.
int diagonals(int record, uint vertices)
{
	const uvec2 head = recordHead(record);
	const vec2 first = recordPlace(record, 0u);
	int found = 0;
	if (record > 0)
	{
		const uvec2 before = recordHead(record - 1);
		if (before.x == head.x && before.y > 2u && recordPlace(record - 1, 0u) == first &&
			recordPlace(record - 1, before.y - 1u) == recordPlace(record, 1u))
			found |= 1;
	}
	const uvec2 after = recordHead(record + 1);
	if (after.x == head.x && after.y > 2u && recordPlace(record + 1, 0u) == first &&
		recordPlace(record + 1, 1u) == recordPlace(record, vertices - 1u))
		found |= 2;
	return found;
}

void main()
{
	int record = gl_VertexIndex / int(kMaxRecordVertices);
	if ((kFeatures & kLayerListed) != 0u)
		record = int(listed[push.listed_from + uint(record)]);
	const uint vertices = recordHead(record).y;
	// What is not there falls together with the first vertex.
	const uint slot = uint(gl_VertexIndex) % kMaxRecordVertices;
	const uint vertex = slot < vertices ? slot : 0u;

	const vec2 uv = recordPlace(record, vertex);
	gl_Position = (kFeatures & kLayerListed) != 0u
					  ? listedPlace(uv)
					  : uv.x * column(push.u_axis) + uv.y * column(push.v_axis) + column(push.origin);
	place = (kFeatures & (kLayerWindow | kLayerMesh)) != 0u ? uv : vec2(0.0);
	edges = ivec2(record, 0);
	if ((kFeatures & kLayerMesh) != 0u && vertices > 2u)
		edges.y = diagonals(record, vertices);

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
