// Decides the cells of a front against a curved surface: one thread a cell. Only codes are written; the CPU makes the mesh.
//
// The CPU in double precision is the truth. Values are computed with a bound on their difference from the CPU's values.
// If the bound leaves the sign of a cell's vertex open, the cell gets kCodeWalk: the CPU then decides it.
//
// The including shader defines surfaceAt().
#extension GL_EXT_scalar_block_layout : require

#include "shared/slice_types.h"
#include "shared/surface_types.h"
#include "arrays.glsl"
#include "bounded.glsl"
#include "classify_common.glsl"

layout(local_size_x = kClassifyGroupSize) in;

layout(constant_id = kConstantCells) const uint kCells = kCellsLattice;
layout(constant_id = kConstantPoints) const uint kPoints = kPointsFloat;

VP_ARRAY(kBindPoints, points);
VP_ARRAY(kBindCells, cells);
VP_ARRAY(kBindCases, cases);
VP_ARRAY(kBindAxes, axes);
layout(binding = kBindFront, scalar) readonly buffer Front { uint front[]; };
layout(binding = kBindCodes, scalar) writeonly buffer Codes { uint codes[]; };
layout(binding = kBindSheet, scalar) uniform Sheet { ClassifySurface sheet; };
layout(push_constant, scalar) uniform Push { ClassifyPush push; };

// f at a point.
Bounded surfaceAt(Bounded x, Bounded y, Bounded z);

vec3 vertex_place[8]; // places of the cell's vertices; indexed by constants only
VP_PICK(vec3)

void fetchPoint(uint v, uint id)
{
	const uvec4 stored = VP_WORDS(points, id);
	precise vec3 place;
	if (kPoints == kPointsFloat)
		place = uintBitsToFloat(stored.xyz);
	else
		place = vec3(ivec3(stored.xyz)) * (fromArray(sheet.unit) * float(1u << kFixedLowBits));
	place = place + fromArray(sheet.shift);
	vertex_place[v] = place;
}

struct AxisShare
{
	float coordinate;
};

AxisShare fetchShare(uint axis, uint index)
{
	return AxisShare(uintBitsToFloat(VP_WORDS(axes, sheet.axis_start[axis] + index).x));
}

void setCorner(uint v, uint id, AxisShare x, AxisShare y, AxisShare z)
{
	vertex_place[v] = vec3(x.coordinate, y.coordinate, z.coordinate);
}

#include "classify_cell.glsl"

Bounded along(float axis[3], Bounded x, Bounded y, Bounded z)
{
	return sumOf(sumOf(productOf(rounded(axis[0], 0.0), x), productOf(rounded(axis[1], 0.0), y)),
	             productOf(rounded(axis[2], 0.0), z));
}

Bounded valueAt(vec3 place)
{
	Bounded x = rounded(place.x, sheet.place_error[0]);
	Bounded y = rounded(place.y, sheet.place_error[1]);
	Bounded z = rounded(place.z, sheet.place_error[2]);
	if (sheet.turned != 0u)
	{
		const Bounded turned_x = along(sheet.x_axis, x, y, z);
		const Bounded turned_y = along(sheet.y_axis, x, y, z);
		z = along(sheet.z_axis, x, y, z);
		x = turned_x;
		y = turned_y;
	}
	return surfaceAt(x, y, z);
}

void main()
{
	const uint i = gl_GlobalInvocationID.x;
	if (i >= push.count)
		return;
	uint case_start;
	const uint vertices = fetchCell(front[i], case_start);
	bool certain = vertices != 0u;
	uint positive_mask = 0u;
	for (uint v = 0u; v < vertices; ++v)
	{
		unknown = false;
		const Bounded value = valueAt(pick(vertex_place, v));
		// The bound's own rounding: less than 1e-6 of it for each of some thousand operations.
		certain = certain && !unknown && abs(value.value) > 1.0625 * value.error;
		positive_mask |= uint(value.value > 0.0) << v;
	}
	const uvec4 entry = VP_WORDS(cases, case_start + positive_mask);
	const bool walk = !certain || (entry.x >> 16) != 0u;
	codes[i] = walk ? kCodeWalk
					: positive_mask | (entry.x & 0xFF00u) << (kCodeFacesShift - 8u) |
	                      ((entry.x & 0xFFu) != 0u ? kCodeCut : 0u);
}
