#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_record.glsl"
#include "render_whole.glsl"
#include "render_place.glsl"

// Small polygons into a layer of values, one thread a polygon. Corners are snapped to 1/kSubpixels of a pixel and edges taken in
// whole numbers, so what lies on an edge belongs to one side of it, as the hardware's rule has it (left and upper edges). A pixel is
// inside where a ray to the right crosses the outline an odd number of times: so neighbors, who snap a shared corner alike, leave no
// hole even where snapping bends a polygon inwards. What is too large or reaches the near plane is listed for the hardware.
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

const uint kCorners = kMaxRecordVertices;
const uint kChunk = 32u; // pixels looked at together: the bits of a word

// The polygon. Corners that it lacks are the first one again: edges between them have no length. All indices are constant once loops
// are unrolled, so the arrays are registers.
uint vertices;
vec2 uv[kCorners];
float values[kCorners];
float inverse_w[kCorners];
vec2 places[kCorners];   // subpixels, from the first pixel's center
ivec2 corners[kCorners]; // the same from the first corner: less than 2^15, so products stay below 2^31
int wedges[kCorners];    // cross products of a corner and the next
int turn;                // 1 or -1: the way the polygon runs round

int cross2(ivec2 a, ivec2 b)
{
	return a.x * b.y - a.y * b.x;
}

vec3 row(float r[3])
{
	return vec3(r[0], r[1], r[2]);
}

bool loadPolygon(int record)
{
	const int texel = record * kRecordTexels;
	const uvec4 head = texelFetch(records, texel);
	vertices = head.y;
	if (vertices < 3u)
		return false;
	const vec4 uv12 = uintBitsToFloat(texelFetch(records, texel + 1));
	const vec4 uv34 = uintBitsToFloat(texelFetch(records, texel + 2));
	const vec4 low = uintBitsToFloat(texelFetch(records, texel + 3));
	const vec4 high = uintBitsToFloat(texelFetch(records, texel + 4));
	uv = vec2[](uintBitsToFloat(head.zw), uv12.xy, uv12.zw, uv34.xy, uv34.zw, low.xy);
	values = float[](low.z, low.w, high.x, high.y, high.z, high.w);
	for (uint i = 3u; i < kCorners; ++i)
	{
		uv[i] = i < vertices ? uv[i] : uv[0];
		values[i] = i < vertices ? values[i] : values[0];
	}
	return true;
}

// In subpixels.
struct Extent
{
	vec2 lo;
	vec2 hi;
	float least_w;
};

Extent placeCorners()
{
	Extent extent = Extent(vec2(1e30), vec2(-1e30), 1e30);
	for (uint i = 0u; i < kCorners; ++i)
	{
		const vec3 at = placeTimesW(uv[i], row(push.u_axis), row(push.v_axis), row(push.origin));
		inverse_w[i] = 1.0 / at.z;
		places[i] = snapped(at);
		extent.lo = min(extent.lo, places[i]);
		extent.hi = max(extent.hi, places[i]);
		extent.least_w = min(extent.least_w, at.z);
	}
	return extent;
}

void takeEdges()
{
	for (uint i = 0u; i < kCorners; ++i)
		corners[i] = ivec2(places[i] - places[0]);
	int area = 0;
	for (uint i = 0u; i < kCorners; ++i)
	{
		wedges[i] = cross2(corners[i], corners[(i + 1u) % kCorners]);
		area += wedges[i];
	}
	turn = area >= 0 ? 1 : -1;
}

// What every pixel of it has, or 0.
float wholeOfPolygon()
{
	float least = values[0];
	float largest = values[0];
	for (uint i = 1u; i < kCorners; ++i)
	{
		least = min(least, values[i]);
		largest = max(largest, values[i]);
	}
	return wholeValue(least, largest);
}

// Whether a ray to the right from p crosses the outline an odd number of times. p: from the first corner.
bool isInside(ivec2 p)
{
	bool odd = false;
	for (uint i = 0u; i < kCorners; ++i)
	{
		const uint next = (i + 1u) % kCorners;
		const int side = wedges[i] + cross2(corners[next], p) - cross2(corners[i], p);
		const bool from_above = corners[i].y <= p.y;
		const bool to_above = corners[next].y <= p.y;
		const bool crossed = from_above != to_above && (from_above ? side > 0 : side < 0);
		odd = odd != crossed;
	}
	return odd;
}

// In the triangle of the fan about the first corner that p lies in, linear on the sheet.
float valueAt(ivec2 p)
{
	int weight_a = 0;
	int weight_i = 0;
	int weight_j = 0;
	vec2 of_i = vec2(0.0); // value, and 1 / w
	vec2 of_j = vec2(0.0);
	for (uint i = 1u; i + 1u < kCorners; ++i)
	{
		const int from = turn * cross2(corners[i], p);
		const int to = turn * cross2(corners[i + 1u], p);
		const bool reached = i == 1u || (from > 0 && i + 1u < vertices);
		weight_a = reached ? turn * wedges[i] + to - from : weight_a;
		weight_i = reached ? -to : weight_i;
		weight_j = reached ? from : weight_j;
		of_i = reached ? vec2(values[i], inverse_w[i]) : of_i;
		of_j = reached ? vec2(values[i + 1u], inverse_w[i + 1u]) : of_j;
	}
	const float part_i = float(max(weight_i, 0)) * of_i.y;
	const float part_j = float(max(weight_j, 0)) * of_j.y;
	const float all = float(max(weight_a, 0)) * inverse_w[0] + part_i + part_j;
	// As differences: what has one value keeps it to the last bit.
	const float change = part_i * (of_i.x - values[0]) + part_j * (of_j.x - values[0]);
	return values[0] + (all > 0.0 ? change / all : 0.0);
}

bool inWindow(ivec2 pixel)
{
	const vec3 at = vec3(pixel, 1.0);
	const vec2 seen = vec2(dot(row(push.u_of_pixel), at), dot(row(push.v_of_pixel), at)) / dot(row(push.w_of_pixel), at);
	return seen.x >= push.window[0] && seen.x <= push.window[1] && seen.y >= push.window[2] && seen.y <= push.window[3];
}

void drawPixels(ivec2 first, ivec2 last)
{
	const float whole = wholeOfPolygon();
	const ivec2 origin = first * int(kSubpixels) - ivec2(places[0]);
	const uint width = uint(last.x - first.x + 1);
	const uint pixels = width * uint(last.y - first.y + 1);
	const float per_row = 1.0 / float(width);
	for (uint base = 0u; base < pixels; base += kChunk)
	{
		// Found first and drawn then: threads that run in step, as software's do, all have something to draw.
		uint inside = 0u;
		const uint count = min(kChunk, pixels - base);
		uint y = uint((float(base) + 0.5) * per_row);
		uint x = base - y * width;
		for (uint i = 0u; i < count; ++i)
		{
			inside |= isInside(origin + ivec2(x, y) * int(kSubpixels)) ? 1u << i : 0u;
			++x;
			y = x == width ? y + 1u : y;
			x = x == width ? 0u : x;
		}
		while (inside != 0u)
		{
			const uint place = base + uint(findLSB(inside));
			inside &= inside - 1u;
			const uint down = uint((float(place) + 0.5) * per_row);
			const ivec2 offset = ivec2(place - down * width, down);
			const float value = valueAt(origin + offset * int(kSubpixels));
			if ((kFeatures & kLayerWindow) == 0u || inWindow(first + offset))
				imageStore(layer, first + offset, vec4(whole != 0.0 ? whole : value));
		}
	}
}

void main()
{
	const uint record = push.first + gl_GlobalInvocationID.x;
	if (gl_GlobalInvocationID.x >= push.count || !loadPolygon(int(record)))
		return;
	const Extent extent = placeCorners();
	const vec2 size = extent.hi - extent.lo;
	const bool small = max(size.x, size.y) <= push.largest && extent.least_w > push.near_w;
	if (!small)
	{
		const uint before = atomicAdd(draws[push.draw].corners, kRecordCorners);
		listed[push.listed_from + before / kRecordCorners] = record;
		return;
	}
	const ivec2 first = ivec2(max(ceil(extent.lo / float(kSubpixels)), vec2(0.0)));
	const ivec2 last =
		ivec2(min(floor(extent.hi / float(kSubpixels)), vec2(push.last_pixel[0], push.last_pixel[1])));
	if (first.x > last.x || first.y > last.y)
		return;
	takeEdges();
	drawPixels(first, last);
}
