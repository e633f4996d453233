#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_record.glsl"
#include "render_whole.glsl"

// Draws polygons into a layer of values. Corners are snapped to 1/kSubpixels of a pixel, and what follows is done in whole numbers.
// A pixel is inside where a ray to the right crosses the outline an odd number of times. So neighbors, who snap a shared corner alike,
// leave no hole and share no pixel, even if snapping bends a polygon inwards. A pixel on an edge belongs to one side of
// it, by the hardware's rule (left and upper edges).
//
// There are three stages (kStage). First one thread takes each polygon. It draws a small polygon and lists any other.
// Then one row of threads takes each large polygon. Polygons that are huge, or reach the near plane or far outside the
// picture, come last: they are clipped, and then many rows of threads take each one.
//
// In a picture's later samples only the surroundings of edges are drawn. A separate stage (kRasterKeep) lists the
// polygons there. The first stage then takes those (kRasterKept).
layout(local_size_x = kRasterGroupSize) in;
layout(binding = 1, r32f) uniform writeonly image2D layer;
layout(binding = 2, scalar) buffer Listed
{
	uint listed[];
};
layout(binding = 3, scalar) buffer Lists
{
	RasterList lists[];
};
layout(binding = 4) uniform usamplerBuffer tiles; // squares of pixels, not 0 where an edge is near
layout(push_constant, scalar) uniform Push
{
	RasterPush push;
};
layout(constant_id = 0) const uint kFeatures = 0u;
layout(constant_id = 1) const uint kStage = kRasterSmall;
const bool kIsFirst = kStage != kRasterLarge && kStage != kRasterHuge; // a thread takes a polygon

const uint kCorners = kMaxRecordVertices;
const uint kClipPlanes = 5u;
const uint kMaxClipped = kCorners + kClipPlanes; // each plane may add a corner
const uint kOutline = kStage == kRasterHuge ? kMaxClipped : kCorners;
const uint kChunk = 32u; // pixels looked at together: the bits of a word

// The polygon. Corners that it lacks are the first one again: edges between them have no length. All indices are constant once loops
// are unrolled, so the arrays are registers.
uint vertices;
vec2 uv[kCorners];
float values[kCorners];
float inverse_w[kCorners];
vec2 places[kOutline];   // subpixels, from the first pixel's center
ivec2 corners[kOutline]; // the same from the first corner; of a small polygon less than 2^15, so products stay below 2^31
float wedges[kCorners];  // cross products of a corner and the next
float turn;              // 1 or -1: the way the polygon runs round

// The outline's edges, from the upper end.
ivec2 tops[kOutline];
ivec2 downs[kOutline]; // to the lower end
float inverse_downs[kOutline]; // inverse of `downs` in pixels

vec3 row(float r[3])
{
	return vec3(r[0], r[1], r[2]);
}

// x and y in subpixels from the first pixel's center, times w, and w. All stages must put a corner at the same place, so no step may be
// joined with another.
vec3 placeTimesW(vec2 uv)
{
	precise const vec3 at = uv.x * row(push.u_axis) + (uv.y * row(push.v_axis) + row(push.origin));
	return at;
}

vec2 snapped(vec3 at)
{
	precise const vec2 place = at.xy * (1.0 / at.z);
	return roundEven(place);
}

bool loadPolygon(int record)
{
	const int texel = record * kRecordTexels;
	const uvec4 head = texelFetch(records, texel);
	vertices = head.y & kRecordVertices;
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
		const vec3 at = placeTimesW(uv[i]);
		inverse_w[i] = 1.0 / at.z;
		places[i] = snapped(at);
		extent.lo = min(extent.lo, places[i]);
		extent.hi = max(extent.hi, places[i]);
		extent.least_w = min(extent.least_w, at.z);
	}
	return extent;
}

// Returns how far a corner is inside of a plane that clips.
float distanceInside(vec3 at, uint plane)
{
	const float far = kFarOutside * at.z;
	precise const float distances[kClipPlanes] =
		float[](at.z - push.near_w, far - at.x, far + at.x, far - at.y, far + at.y);
	return distances[plane];
}

// Returns the point at which an edge is cut. It depends on the edge alone, and not on its direction, so neighbors cut a
// shared edge at the same point.
vec3 cutEdge(vec3 in_at, float in_side, vec3 out_at, float out_side)
{
	precise const vec3 at = in_at + (in_side / (in_side - out_side)) * (out_at - in_at);
	return at;
}

Extent clipCorners()
{
	vec3 ring[kMaxClipped];
	uint count = vertices;
	for (uint i = 0u; i < kCorners; ++i)
		ring[i] = placeTimesW(uv[i]);
	// Unrolled, these loops make so much code that lavapipe compiles it for seconds.
	[[dont_unroll]] for (uint plane = 0u; plane < kClipPlanes; ++plane)
	{
		vec3 kept[kMaxClipped];
		uint kept_count = 0u;
		[[dont_unroll]] for (uint i = 0u; i < count; ++i)
		{
			const vec3 a = ring[i];
			const vec3 b = ring[i + 1u < count ? i + 1u : 0u];
			const float side_a = distanceInside(a, plane);
			const float side_b = distanceInside(b, plane);
			if (side_a >= 0.0)
				kept[min(kept_count++, kMaxClipped - 1u)] = a;
			if (side_a >= 0.0 != side_b >= 0.0)
				kept[min(kept_count++, kMaxClipped - 1u)] =
					side_a >= 0.0 ? cutEdge(a, side_a, b, side_b) : cutEdge(b, side_b, a, side_a);
		}
		count = min(kept_count, kMaxClipped);
		ring = kept;
	}
	Extent extent = Extent(vec2(1e30), vec2(-1e30), push.near_w);
	for (uint i = 0u; i < kOutline && count > 0u; ++i)
	{
		places[i] = snapped(ring[i < count ? i : 0u]);
		extent.lo = min(extent.lo, places[i]);
		extent.hi = max(extent.hi, places[i]);
	}
	return extent;
}

// Returns true if a * b > c * d, in 64 bits.
bool isGreater(int a, int b, int c, int d)
{
	int high_ab;
	int low_ab;
	int high_cd;
	int low_cd;
	imulExtended(a, b, high_ab, low_ab);
	imulExtended(c, d, high_cd, low_cd);
	return high_ab > high_cd || (high_ab == high_cd && uint(low_ab) > uint(low_cd));
}

// Exact but for one rounding.
float cross2(ivec2 a, ivec2 b)
{
	if (kIsFirst)
		return float(a.x * b.y - a.y * b.x);
	int high_x;
	int low_x;
	int high_y;
	int low_y;
	imulExtended(a.x, b.y, high_x, low_x);
	imulExtended(a.y, b.x, high_y, low_y);
	uint low = uint(low_x) - uint(low_y);
	int high = high_x - high_y - (uint(low_x) < uint(low_y) ? 1 : 0);
	const bool negative = high < 0;
	high = negative ? ~high + (low == 0u ? 1 : 0) : high;
	low = negative ? 0u - low : low;
	const float size = float(high) * 4294967296.0 + float(low);
	return negative ? -size : size;
}

float cross2(vec2 a, vec2 b)
{
	return a.x * b.y - a.y * b.x;
}

void takeEdges()
{
	for (uint i = 0u; i < kOutline; ++i)
		corners[i] = ivec2(places[i] - places[0]);
	for (uint i = 0u; i < kOutline; ++i)
	{
		const ivec2 a = corners[i];
		const ivec2 b = corners[(i + 1u) % kOutline];
		tops[i] = a.y <= b.y ? a : b;
		downs[i] = a.y <= b.y ? b - a : a - b;
		inverse_downs[i] = 1.0 / float(max(downs[i].y, 1) * int(kSubpixels));
	}
}

// Prepares the interpolation of values between corners. For a huge polygon it works on the sheet itself, else in the
// picture.
void takeWedges()
{
	float area = 0.0;
	for (uint i = 0u; i < kCorners; ++i)
	{
		const uint next = (i + 1u) % kCorners;
		wedges[i] = kStage == kRasterHuge ? cross2(uv[i] - uv[0], uv[next] - uv[0]) : cross2(corners[i], corners[next]);
		area += wedges[i];
	}
	turn = area >= 0.0 ? 1.0 : -1.0;
}

// Returns the value that every pixel of the polygon has, or 0.
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

// Returns how many of `count` pixels from p to the right lie left of edge i; 0 if p's row does not cross it. A float
// gives the pixel nearest to the crossing, and integers decide on which side of the edge it lies. p: from the first
// corner.
int pixelsLeftOf(uint i, ivec2 p, int count)
{
	const int down = p.y - tops[i].y;
	const bool crossed = uint(down) < uint(downs[i].y);
	int near;
	bool beyond;
	if (kIsFirst)
	{
		const int across = down * downs[i].x - (p.x - tops[i].x) * downs[i].y;
		near = int(roundEven(float(across) * inverse_downs[i]));
		beyond = across > near * downs[i].y * int(kSubpixels);
	}
	else
	{
		const float crossing =
			float(tops[i].x - p.x) / float(kSubpixels) + float(down) * (float(downs[i].x) * inverse_downs[i]);
		near = int(roundEven(clamp(crossing, -1.0, float(count))));
		beyond = isGreater(down, downs[i].x, p.x + near * int(kSubpixels) - tops[i].x, downs[i].y);
	}
	return crossed ? clamp(near + (beyond ? 1 : 0), 0, count) : 0;
}

// Each edge that a row crosses turns over all pixels on its left: these, of a word.
uint turnedOver(int left)
{
	return left >= int(kChunk) ? 0xFFFFFFFFu : (1u << max(left, 0)) - 1u;
}

// Which of `count` pixels from p to the right are inside, p the lowest bit.
uint insideOfRow(ivec2 p, int count)
{
	uint odd = 0u;
	for (uint i = 0u; i < kOutline; ++i)
		odd ^= turnedOver(pixelsLeftOf(i, p, count));
	return odd;
}

// The fan's triangle that p lies in is found, and the value is linear in it: on the sheet, so that 1 / w counts in the picture.
float valueIn(float from_first, ivec2 p, vec2 seen)
{
	float weight_a = 0.0;
	float weight_i = 0.0;
	float weight_j = 0.0;
	vec2 of_i = vec2(0.0); // value, and 1 / w
	vec2 of_j = vec2(0.0);
	for (uint i = 1u; i + 1u < kCorners; ++i)
	{
		const float from = turn * (kStage == kRasterHuge ? cross2(uv[i] - uv[0], seen) : cross2(corners[i], p));
		const float to = turn * (kStage == kRasterHuge ? cross2(uv[i + 1u] - uv[0], seen) : cross2(corners[i + 1u], p));
		const bool reached = i == 1u || (from > 0.0 && i + 1u < vertices);
		weight_a = reached ? turn * wedges[i] + to - from : weight_a;
		weight_i = reached ? -to : weight_i;
		weight_j = reached ? from : weight_j;
		of_i = reached ? vec2(values[i], inverse_w[i]) : of_i;
		of_j = reached ? vec2(values[i + 1u], inverse_w[i + 1u]) : of_j;
	}
	const float part_i = max(weight_i, 0.0) * (kStage == kRasterHuge ? 1.0 : of_i.y);
	const float part_j = max(weight_j, 0.0) * (kStage == kRasterHuge ? 1.0 : of_j.y);
	const float all = max(weight_a, 0.0) * from_first + part_i + part_j;
	// As differences: what has one value keeps it to the last bit.
	const float change = part_i * (of_i.x - values[0]) + part_j * (of_j.x - values[0]);
	return values[0] + (all > 0.0 ? change / all : 0.0);
}

vec2 onSheet(ivec2 pixel)
{
	const vec3 at = vec3(pixel, 1.0);
	return vec2(dot(row(push.u_of_pixel), at), dot(row(push.v_of_pixel), at)) / dot(row(push.w_of_pixel), at);
}

bool inWindow(vec2 seen)
{
	return seen.x >= push.window[0] && seen.x <= push.window[1] && seen.y >= push.window[2] && seen.y <= push.window[3];
}

void drawPixel(ivec2 pixel, ivec2 origin, float whole)
{
	const bool has_window = (kFeatures & kLayerWindow) != 0u;
	const vec2 seen = has_window || kStage == kRasterHuge ? onSheet(pixel) : vec2(0.0);
	const float value = kStage == kRasterHuge ? valueIn(1.0, ivec2(0), seen - uv[0])
											  : valueIn(inverse_w[0], origin + pixel * int(kSubpixels), vec2(0.0));
	if (!has_window || inWindow(seen))
		imageStore(layer, pixel, vec4(whole != 0.0 ? whole : value));
}

// Software goes once more round a loop that tests at its begin, so all loops here test at their end. And pixels are found first and
// drawn then: threads that run in step, as software's do, all have something to draw.

// As many rows of a small polygon are looked at together as fit into a word.
void drawSmall(ivec2 first, ivec2 last)
{
	const float whole = wholeOfPolygon();
	const ivec2 origin = -ivec2(places[0]);
	const int width = min(last.x - first.x + 1, int(kChunk));
	const int together = int((float(kChunk) + 0.5) / float(width));
	const float per_row = 1.0 / float(width);
	int y = first.y;
	do
	{
		int x = first.x;
		do
		{
			uint inside = 0u;
			int i = 0;
			do
			{
				inside |= insideOfRow(origin + ivec2(x, y + i) * int(kSubpixels), min(width, last.x - x + 1)) << (i * width);
				++i;
			} while (i < together && y + i <= last.y);
			do
			{
				const int place = findLSB(inside);
				const int down = int((float(place) + 0.5) * per_row);
				if (inside != 0u)
					drawPixel(ivec2(x + place - down * width, y + down), origin, whole);
				inside &= inside - 1u;
			} while (inside != 0u);
			x += width;
		} while (x <= last.x);
		y += together;
	} while (y <= last.y);
}

// The rows from the first one of a thread on, so many apart.
struct Rows
{
	uint first;
	uint step;
};

// Visits only the pixels between a row's first and last crossing, since long thin polygons have wide bounds.
void drawRows(ivec2 first, ivec2 last, Rows rows)
{
	const float whole = wholeOfPolygon();
	const ivec2 origin = -ivec2(places[0]);
	const int width = last.x - first.x + 1;
	int y = first.y + int(rows.first);
	do
	{
		int lefts[kOutline];
		int from = width;
		int to = 0;
		for (uint i = 0u; i < kOutline; ++i)
		{
			lefts[i] = y <= last.y ? pixelsLeftOf(i, origin + ivec2(first.x, y) * int(kSubpixels), width) : 0;
			from = lefts[i] > 0 ? min(from, lefts[i]) : from;
			to = max(to, lefts[i]);
		}
		// A pixel left of all crossings is inside if their number is odd. Then other crossings were cut off at the
		// left.
		uint crossings = 0u;
		for (uint i = 0u; i < kOutline; ++i)
			crossings += uint(lefts[i] > 0);
		int x = (crossings & 1u) != 0u ? 0 : from;
		do
		{
			uint inside = 0u;
			for (uint i = 0u; i < kOutline; ++i)
				inside ^= turnedOver(lefts[i] - x);
			do
			{
				if (inside != 0u)
					drawPixel(ivec2(first.x + x + findLSB(inside), y), origin, whole);
				inside &= inside - 1u;
			} while (inside != 0u);
			x += int(kChunk);
		} while (x < to);
		y += int(rows.step);
	} while (y <= last.y);
}

// Half of the sum of cross products, in square pixels.
float areaInPicture()
{
	float twice = 0.0;
	for (uint i = 0u; i < kCorners; ++i)
		twice += cross2(places[i] - places[0], places[(i + 1u) % kCorners] - places[0]);
	return 0.5 * abs(twice) / float(kSubpixels * kSubpixels);
}

uint stageFor(Extent extent, bool seen)
{
	const bool fits = extent.least_w >= push.near_w && all(greaterThan(extent.lo, vec2(-kFarOutside))) &&
					  all(lessThan(extent.hi, vec2(kFarOutside)));
	const vec2 size = extent.hi - extent.lo;
	const uint stage = max(size.x, size.y) <= push.largest || !seen ? kRasterSmall
					   : areaInPicture() > kHugeArea				 ? kRasterHuge
																	 : kRasterLarge;
	return fits ? stage : kRasterHuge;
}

// Leaves a polygon to one of the stages that follow.
void leaveTo(uint stage, uint record)
{
	const uint list = push.lists + stage - 1u;
	const uint before = atomicAdd(lists[list].count, 1u);
	atomicMax(lists[list].groups[0], before / (kRasterGroupSize / kRasterRows) + 1u);
	// One list grows from the front of the stretch, and one from its end.
	const uint place = stage == kRasterLarge ? before : push.count - 1u - before;
	listed[push.listed_from + place] = record;
}

// The polygon that this thread works on, with others. False: none.
bool findListed(out uint record, out Rows rows)
{
	const uint place = gl_GlobalInvocationID.x / kRasterRows;
	rows = Rows(gl_GlobalInvocationID.x % kRasterRows + kRasterRows * gl_WorkGroupID.y, kRasterRows * gl_NumWorkGroups.y);
	const uint count = lists[push.lists + kStage - 1u].count;
	if (place >= count)
		return false;
	record = listed[push.listed_from + (kStage == kRasterLarge ? place : push.count - 1u - place)];
	return true;
}

// Returns true if an edge of the first or a later sample is near. Samples lie less than a pixel apart.
bool isNearEdge(Extent extent)
{
	if (extent.least_w < push.near_w)
		return true;
	const vec2 end = vec2(push.last_pixel[0], push.last_pixel[1]);
	const ivec2 first = ivec2(clamp(floor(extent.lo / float(kSubpixels)) - 1.0, vec2(0.0), end)) / int(kEdgeTile);
	const ivec2 last = ivec2(clamp(ceil(extent.hi / float(kSubpixels)) + 1.0, vec2(0.0), end)) / int(kEdgeTile);
	const int across = int(push.last_pixel[0]) / int(kEdgeTile) + 1;
	uint found = 0u;
	ivec2 tile = first;
	do
	{
		found |= texelFetch(tiles, tile.y * across + tile.x).x;
		const bool at_end = tile.x == last.x;
		tile = at_end ? ivec2(first.x, tile.y + 1) : ivec2(tile.x + 1, tile.y);
	} while (tile.y <= last.y && found == 0u);
	return found != 0u;
}

void keep(uint record)
{
	const uint before = atomicAdd(lists[push.kept_list].count, 1u);
	atomicMax(lists[push.kept_list].groups[0], before / kRasterGroupSize + 1u);
	listed[push.kept_from + before] = record;
}

// False: no polygon is left for this thread.
bool findRecord(out uint record, out Rows rows)
{
	rows = Rows(0u, 1u);
	const uint place = gl_GlobalInvocationID.x;
	if (kStage == kRasterLarge || kStage == kRasterHuge)
		return findListed(record, rows);
	if (kStage == kRasterKept)
	{
		record = place < lists[push.kept_list].count ? listed[push.kept_from + place] : 0u;
		return place < lists[push.kept_list].count;
	}
	record = push.first + place;
	return place < push.count;
}

void main()
{
	uint record;
	Rows rows;
	if (!findRecord(record, rows))
		return;
	if (!loadPolygon(int(record)))
		return;
	Extent extent;
	if (kStage == kRasterHuge)
		extent = clipCorners();
	else
		extent = placeCorners();
	if (kStage == kRasterKeep)
	{
		if (isNearEdge(extent))
			keep(record);
		return;
	}
	const vec2 end = vec2(push.last_pixel[0], push.last_pixel[1]);
	const ivec2 first = ivec2(clamp(ceil(extent.lo / float(kSubpixels)), vec2(0.0), end + 1.0));
	const ivec2 last = ivec2(clamp(floor(extent.hi / float(kSubpixels)), vec2(-1.0), end));
	const bool seen = first.x <= last.x && first.y <= last.y;
	if (kIsFirst)
	{
		const uint stage = stageFor(extent, seen);
		if (stage != kRasterSmall)
		{
			leaveTo(stage, record);
			return;
		}
	}
	if (!seen)
		return;
	takeEdges();
	takeWedges();
	if (kIsFirst)
		drawSmall(first, last);
	else
		drawRows(first, last, rows);
}
