// Decides the cells of a front against a plane and emits their polygons: one thread a cell, signs, case table, polygon.
//
// The CPU in double precision is the truth. A cell where the sign of a vertex, or the place of a polygon's vertex, is
// not certain here gets kCodeWalk and an empty record; the CPU then decides it. With doubles the distance is the CPU's
// own expression on the same numbers, rounded alike, so this happens only next to points that do not fit 41 bits.
//
// All that a vertex is made of is `precise`: cells that share it compute it to the same bits, whichever of their
// vertices it is.
//
// Included with VP_REAL and VP_REAL3 defined as double or float, and VP_DOUBLES as 1 or 0.
#extension GL_EXT_scalar_block_layout : require

#include "shared/classify_types.h"
#include "shared/slice_types.h"
#include "arrays.glsl"

layout(local_size_x = kClassifyGroupSize) in;

layout(constant_id = kConstantCells) const uint kCells = kCellsLattice;
layout(constant_id = kConstantPoints) const uint kPoints = kPointsFloat;
layout(constant_id = kConstantValues) const uint kValues = kValuesNone;

const uint kMaxEdges = kCells == kCellsRecord4 ? 4u : kMaxRecordVertices; // largest number of edges of a polygon

VP_ARRAY(kBindPoints, points);
VP_ARRAY(kBindCells, cells);
VP_ARRAY(kBindCases, cases);
VP_NUMBERS(kBindValues, values);
VP_ARRAY(kBindAxes, axes);
layout(binding = kBindFront, scalar) readonly buffer Front { uint front[]; };
layout(binding = kBindCodes, scalar) writeonly buffer Codes { uint codes[]; };
layout(binding = kBindRecords, scalar) writeonly buffer Records { PolygonRecord records[]; };
layout(binding = kBindSheet, scalar) uniform Sheet { ClassifyPlane sheet; };
layout(push_constant, scalar) uniform Push { ClassifyPush push; };

// The cell's vertices. These arrays are indexed by constants only. pick() makes software devices a fifth slower.
uint vertex_id[8];
float vertex_distance[8]; // the ends of a cut edge lie on both sides, so their difference is as exact as they are
vec2 vertex_uv[8];
float vertex_value[8];   // kValuesPoint
uint positive_mask = 0u; // bit v: vertex v is on the positive side
uint exact_mask = 0u;    // its distance is the CPU's
uint near_mask = 0u;     // it is so near the plane that an inexact distance leaves the sign open

void setVertex(uint v, uint id, VP_REAL distance, bool exact, vec2 uv)
{
	vertex_id[v] = id;
	vertex_distance[v] = float(distance);
	vertex_uv[v] = uv;
	if (kValues == kValuesPoint)
		vertex_value[v] = VP_NUMBER(values, id);
	positive_mask |= uint(distance >= 0.0) << v;
	exact_mask |= uint(exact) << v;
	near_mask |= uint(abs(vertex_distance[v]) <= sheet.error) << v;
}

#include "classify_common.glsl"
VP_PICK(uint)
VP_PICK(float)
VP_PICK(vec2)

#if VP_DOUBLES
double fromHalves(uint low, uint high)
{
	return packDouble2x32(uvec2(low, high));
}
#define VP_DOUBLE3(field) \
	dvec3(fromHalves(field[0], field[1]), fromHalves(field[2], field[3]), fromHalves(field[4], field[5]))
#endif

// Sets distance and uv of a vertex from its point.
void fetchPoint(uint v, uint id)
{
	const uvec4 stored = VP_WORDS(points, id);
	precise VP_REAL3 from_origin;
	bool exact = VP_DOUBLES != 0;
#if VP_DOUBLES
	if (kPoints == kPointsFloat)
		from_origin = dvec3(uintBitsToFloat(stored.xyz)) - VP_DOUBLE3(sheet.origin);
	else
	{
		const uint low_mask = (1u << kFixedLowBits) - 1u;
		const uvec3 low = (uvec3(stored.w) >> uvec3(0u, kFixedLowBits, 2u * kFixedLowBits)) & low_mask;
		const dvec3 fixed_point = dvec3(ivec3(stored.xyz)) * double(1u << kFixedLowBits) + dvec3(ivec3(low));
		precise dvec3 point = VP_DOUBLE3(sheet.center) + fixed_point * dvec3(fromArray(sheet.unit));
		from_origin = point - VP_DOUBLE3(sheet.origin);
		exact = (stored.w & sheet.inexact_mask) == 0u;
	}
	const dvec3 normal = VP_DOUBLE3(sheet.normal);
#else
	if (kPoints == kPointsFloat)
		from_origin =
			(uintBitsToFloat(stored.xyz) - fromArray(sheet.single_origin_hi)) - fromArray(sheet.single_origin_lo);
	else
	{
		const vec3 coarse_unit = fromArray(sheet.unit) * float(1u << kFixedLowBits);
		from_origin = vec3(ivec3(stored.xyz)) * coarse_unit + fromArray(sheet.single_center);
	}
	const vec3 normal = fromArray(sheet.single_normal);
#endif
	precise VP_REAL3 share = normal * from_origin;
	precise VP_REAL distance = (share.x + share.y) + share.z;
	precise vec3 x_share = fromArray(sheet.x_axis) * vec3(from_origin);
	precise vec3 y_share = fromArray(sheet.y_axis) * vec3(from_origin);
	precise vec2 uv = vec2((x_share.x + x_share.y) + x_share.z, (y_share.x + y_share.y) + y_share.z);
	setVertex(v, id, distance, exact, uv);
}

// The share of a coordinate of an axis in the distance and in uv.
struct AxisShare
{
	VP_REAL distance;
	vec2 uv;
};

AxisShare fetchShare(uint axis, uint index)
{
	const uvec4 stored = VP_WORDS(axes, sheet.axis_start[axis] + index);
	AxisShare share;
#if VP_DOUBLES
	share.distance = packDouble2x32(stored.xy);
#else
	share.distance = uintBitsToFloat(stored.x);
#endif
	share.uv = uintBitsToFloat(stored.zw);
	return share;
}

void setCorner(uint v, uint id, AxisShare x, AxisShare y, AxisShare z)
{
	precise VP_REAL distance = (x.distance + y.distance) + z.distance;
	precise vec2 uv = (x.uv + y.uv) + z.uv;
	setVertex(v, id, distance, VP_DOUBLES != 0, uv);
}

#include "classify_cell.glsl"

// Data linear along the edge; an end that has no part in the vertex does not bring its NaN to it.
float alongEdge(float from, float to, float t)
{
	if (sheet.nearest != 0u)
		return t < 0.5 ? from : t > 0.5 ? to : min(from, to);
	precise float between = max(from, to) >= kNanValue ? kNanValue : from + t * (to - from);
	return t == 0.0 ? from : t == 1.0 ? to : between;
}

// The length of the interpolated tuple.
float tupleAlongEdge(uint from, uint to, float t)
{
	precise float sum = 0.0;
	float largest = 0.0;
	for (uint c = 0u; c < sheet.tuple_texels; ++c)
	{
		const vec4 a = VP_FOUR(values, from * sheet.tuple_texels + c);
		const vec4 b = VP_FOUR(values, to * sheet.tuple_texels + c);
		const vec4 value =
			vec4(alongEdge(a.x, b.x, t), alongEdge(a.y, b.y, t), alongEdge(a.z, b.z, t), alongEdge(a.w, b.w, t));
		largest = max(largest, max(max(value.x, value.y), max(value.z, value.w)));
		sum += dot(value, value);
	}
	return largest >= kNanValue ? kNanValue : sqrt(sum);
}

float cellValue(uint cell)
{
	if (kValues == kValuesCell)
		return VP_NUMBER(values, cell);
	if (kValues == kValuesCellTuple)
		return tupleAlongEdge(cell, cell, 0.0);
	return sheet.no_value;
}

void leaveEmpty(uint i, uint cell)
{
	records[i].cell = cell;
	records[i].vertices = 0u;
}

void main()
{
	const uint i = gl_GlobalInvocationID.x;
	if (i >= push.count)
	{
		if (i < push.padded)
			leaveEmpty(i, 0xFFFFFFFFu);
		return;
	}
	const uint cell = front[i];

	uint case_start;
	const uint vertices = fetchCell(cell, case_start);
	const bool certain = vertices != 0u && (near_mask & ~exact_mask) == 0u;
	if (!certain)
	{
		codes[i] = kCodeWalk;
		leaveEmpty(i, cell);
		return;
	}

	const uvec4 entry = VP_WORDS(cases, case_start + positive_mask);
	const uint edges = entry.x & 0xFFu;
	bool walk = (entry.x >> 16) != 0u;

	const float cell_value = cellValue(cell);
	for (uint e = 0u; e < kMaxEdges; ++e)
	{
		if (e >= edges)
			continue;
		const uint turned = sheet.flipped != 0u ? edges - 1u - e : e;
		const uint pair = turned < 2u ? entry.y : turned < 4u ? entry.z : entry.w;
		const uint ends = pair >> (16u * (turned & 1u));
		// From the positive end: all cells about an edge, in all blocks, agree which that is and compute one vertex.
		const uint positive = ends & 0xFFu;
		const uint negative = (ends >> 8) & 0xFFu;
		const float distance = pick(vertex_distance, positive);
		precise float difference = distance - pick(vertex_distance, negative);
		const bool exact = (exact_mask >> positive & exact_mask >> negative & 1u) != 0u;
		walk = walk || (!exact && difference < sheet.least_difference);
		// Not a number only where floats take both ends for zero, some 1e-38 from the plane.
		precise float t = difference > 0.0 ? distance / difference : 0.0;
		const vec2 positive_uv = pick(vertex_uv, positive);
		precise vec2 uv = positive_uv + t * (pick(vertex_uv, negative) - positive_uv);
		records[i].uv[2u * e] = uv.x;
		records[i].uv[2u * e + 1u] = uv.y;
		float value = cell_value;
		if (kValues == kValuesPoint)
			value = alongEdge(pick(vertex_value, positive), pick(vertex_value, negative), t);
		if (kValues == kValuesPointTuple)
			value = tupleAlongEdge(pick(vertex_id, positive), pick(vertex_id, negative), t);
		records[i].value[e] = value;
	}
	records[i].cell = cell;
	records[i].vertices = walk ? 0u : edges;
	codes[i] = walk ? kCodeWalk
					: positive_mask | (entry.x & 0xFF00u) << (kCodeFacesShift - 8u) | (edges != 0u ? kCodeCut : 0u);
}
