#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_record.glsl"
#include "render_whole.glsl"
#include "render_place.glsl"

// Small polygons into a layer of values, one thread a polygon. Corners are snapped to 1/kSubpixels of a pixel and edges taken in whole
// numbers, so what lies on an edge belongs to one side of it, as the hardware's rule has it (left and upper edges). A pixel is inside where
// a ray to the right crosses the outline an odd number of times: between neighbours, who snap a shared corner alike, no hole is left even
// where snapping bends a polygon inwards. What is too large or reaches the near plane is listed for the hardware's rasterizer.
layout(local_size_x = kRasterGroupSize) in;
layout(binding = 1, r32f) uniform writeonly image2D layer;
layout(binding = 2, scalar) writeonly buffer Listed
{
	uint listed[];
};
layout(binding = 3, scalar) buffer Draws
{
	RasterDraw draws[];
};
layout(push_constant, scalar) uniform Push
{
	RasterPush push;
};
layout(constant_id = 0) const uint kFeatures = 0u;

const uint kChunk = 32u; // pixels looked at together: the bits of a word

vec3 row(float r[3])
{
	return vec3(r[0], r[1], r[2]);
}

int cross2(ivec2 a, ivec2 b)
{
	return a.x * b.y - a.y * b.x;
}

// Whether a ray to the right from a pixel crosses the edge that the pixel is `side` of; from_above, to_above: its ends are not below the pixel.
bool crosses(bool from_above, bool to_above, int side)
{
	return from_above != to_above && (from_above ? side > 0 : side < 0);
}

// (u, v) seen at a pixel.
bool inWindow(ivec2 pixel)
{
	const vec3 at = vec3(pixel, 1.0);
	const vec2 uv = vec2(dot(row(push.u_of_pixel), at), dot(row(push.v_of_pixel), at)) / dot(row(push.w_of_pixel), at);
	return uv.x >= push.window[0] && uv.x <= push.window[1] && uv.y >= push.window[2] && uv.y <= push.window[3];
}

void main()
{
	const uint record = gl_GlobalInvocationID.x;
	if (record >= push.count)
		return;
	const int texel = int(record) * kRecordTexels;
	const uvec4 head = texelFetch(records, texel);
	const uint vertices = head.y;
	if (vertices < 3u)
		return;
	const vec4 uv12 = uintBitsToFloat(texelFetch(records, texel + 1));
	const vec4 uv34 = uintBitsToFloat(texelFetch(records, texel + 2));
	const vec4 low = uintBitsToFloat(texelFetch(records, texel + 3));
	const vec4 high = uintBitsToFloat(texelFetch(records, texel + 4));
	const vec2 uv0 = uintBitsToFloat(head.zw);
	const vec2 uv[kMaxRecordVertices] = vec2[](uv0, uv12.xy, uv12.zw, vertices > 3u ? uv34.xy : uv0,
											   vertices > 4u ? uv34.zw : uv0, vertices > 5u ? low.xy : uv0);
	const float values[kMaxRecordVertices] =
		float[](low.z, low.w, high.x, vertices > 3u ? high.y : low.z, vertices > 4u ? high.z : low.z, vertices > 5u ? high.w : low.z);

	// Corners in subpixels from the first pixel's centre, and 1 / w.
	vec2 places[kMaxRecordVertices];
	float inverse_w[kMaxRecordVertices];
	vec2 lo = vec2(1e30);
	vec2 hi = vec2(-1e30);
	float least_w = 1e30;
	for (uint i = 0u; i < kMaxRecordVertices; ++i)
	{
		const vec3 at = placeTimesW(uv[i], row(push.u_axis), row(push.v_axis), row(push.origin));
		inverse_w[i] = 1.0 / at.z;
		places[i] = snapped(at);
		lo = min(lo, places[i]);
		hi = max(hi, places[i]);
		least_w = min(least_w, at.z);
	}
	const vec2 size = hi - lo;
	const bool small = max(size.x, size.y) <= push.largest && least_w > push.near_w;
	if (!small)
	{
		const uint corners = atomicAdd(draws[push.draw].corners, kRecordCorners);
		listed[push.listed_from + corners / kRecordCorners] = record;
		return;
	}
	const ivec2 first = ivec2(max(ceil(lo / float(kSubpixels)), vec2(0.0)));
	const ivec2 last = ivec2(min(floor(hi / float(kSubpixels)), vec2(push.last_pixel[0], push.last_pixel[1])));
	if (first.x > last.x || first.y > last.y)
		return;

	// Everything from the first corner: within 2^15 in subpixels, so products stay within 2^31.
	const ivec2 b = ivec2(places[1] - places[0]);
	const ivec2 c = ivec2(places[2] - places[0]);
	const ivec2 d = ivec2(places[3] - places[0]);
	const ivec2 e = ivec2(places[4] - places[0]);
	const ivec2 f = ivec2(places[5] - places[0]);
	const int abc = cross2(b, c);
	const int acd = cross2(c, d);
	const int ade = cross2(d, e);
	const int aef = cross2(e, f);
	const int turn = abc + acd + ade + aef >= 0 ? 1 : -1;

	float least = min(min(values[0], values[1]), values[2]);
	float largest = max(max(values[0], values[1]), values[2]);
	for (uint i = 3u; i < kMaxRecordVertices; ++i)
	{
		least = min(least, values[i]);
		largest = max(largest, values[i]);
	}
	const float whole = wholeValue(least, largest);

	const ivec2 origin = first * int(kSubpixels) - ivec2(places[0]);
	const uint width = uint(last.x - first.x + 1);
	const uint pixels = width * uint(last.y - first.y + 1);
	const float per_row = 1.0 / float(width);
	for (uint base = 0u; base < pixels; base += kChunk)
	{
		uint inside = 0u;
		const uint count = min(kChunk, pixels - base);
		uint y = uint((float(base) + 0.5) * per_row);
		uint x = base - y * width;
		for (uint i = 0u; i < count; ++i)
		{
			const ivec2 p = origin + ivec2(x, y) * int(kSubpixels);
			const int kb = cross2(b, p);
			const int kc = cross2(c, p);
			const int kd = cross2(d, p);
			const int ke = cross2(e, p);
			const int kf = cross2(f, p);
			const bool a_above = 0 <= p.y;
			const bool b_above = b.y <= p.y;
			const bool c_above = c.y <= p.y;
			const bool d_above = d.y <= p.y;
			const bool e_above = e.y <= p.y;
			const bool f_above = f.y <= p.y;
			const bool odd = crosses(a_above, b_above, kb) != crosses(b_above, c_above, abc + kc - kb);
			const bool odd2 = crosses(c_above, d_above, acd + kd - kc) != crosses(d_above, e_above, ade + ke - kd);
			const bool odd3 = crosses(e_above, f_above, aef + kf - ke) != crosses(f_above, a_above, -kf);
			inside |= (odd != odd2) != odd3 ? 1u << i : 0u;
			++x;
			if (x == width)
			{
				x = 0u;
				++y;
			}
		}
		while (inside != 0u)
		{
			const uint place = base + uint(findLSB(inside));
			inside &= inside - 1u;
			const uint row_of = uint((float(place) + 0.5) * per_row);
			const ivec2 offset = ivec2(place - row_of * width, row_of);
			const ivec2 p = origin + offset * int(kSubpixels);
			const int kb = turn * cross2(b, p);
			const int kc = turn * cross2(c, p);
			const int kd = turn * cross2(d, p);
			const int ke = turn * cross2(e, p);
			const int kf = turn * cross2(f, p);
			// The triangle of the fan, and its corners' weights.
			int wa = turn * abc + kc - kb;
			int wi = -kc;
			int wj = kb;
			float vi = values[1];
			float vj = values[2];
			float zi = inverse_w[1];
			float zj = inverse_w[2];
			const bool to_d = kc > 0 && vertices > 3u;
			wa = to_d ? turn * acd + kd - kc : wa;
			wi = to_d ? -kd : wi;
			wj = to_d ? kc : wj;
			vi = to_d ? values[2] : vi;
			vj = to_d ? values[3] : vj;
			zi = to_d ? inverse_w[2] : zi;
			zj = to_d ? inverse_w[3] : zj;
			const bool to_e = kd > 0 && vertices > 4u;
			wa = to_e ? turn * ade + ke - kd : wa;
			wi = to_e ? -ke : wi;
			wj = to_e ? kd : wj;
			vi = to_e ? values[3] : vi;
			vj = to_e ? values[4] : vj;
			zi = to_e ? inverse_w[3] : zi;
			zj = to_e ? inverse_w[4] : zj;
			const bool to_f = ke > 0 && vertices > 5u;
			wa = to_f ? turn * aef + kf - ke : wa;
			wi = to_f ? -kf : wi;
			wj = to_f ? ke : wj;
			vi = to_f ? values[4] : vi;
			vj = to_f ? values[5] : vj;
			zi = to_f ? inverse_w[4] : zi;
			zj = to_f ? inverse_w[5] : zj;
			const float part_a = float(max(wa, 0)) * inverse_w[0];
			const float part_i = float(max(wi, 0)) * zi;
			const float part_j = float(max(wj, 0)) * zj;
			const float all = part_a + part_i + part_j;
			const float value =
				all > 0.0 ? values[0] + (part_i * (vi - values[0]) + part_j * (vj - values[0])) / all : values[0];
			const ivec2 pixel = first + offset;
			if ((kFeatures & kLayerWindow) == 0u || inWindow(pixel))
				imageStore(layer, pixel, vec4(whole != 0.0 ? whole : value));
		}
	}
}
