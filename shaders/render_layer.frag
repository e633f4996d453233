#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_record.glsl"
#include "render_mesh_lines.glsl"

// The window is tested here and not by clip distances: what is inside keeps its pixels to the last bit, and neighboring polygons
// cut by the rim leave no crack.
layout(push_constant, scalar) uniform Push
{
	LayerPush push;
};
layout(constant_id = 0) const uint kFeatures = 0u;

layout(location = 0) in float value;
layout(location = 1) flat in float whole;
layout(location = 2) in vec2 place;
layout(location = 3) flat in ivec2 edges;
layout(location = 0) out vec2 pixel; // value, and how much of a mesh line is here; layers without mesh lines hold the first only

// Returns how much of a line along the polygon's edges covers this pixel. Over a few pixels (u, v) is linear enough to
// use its derivatives. Each polygon draws its own half of a line.
float meshLine()
{
	const int record = edges.x;
	const uint vertices = recordHead(record).y;
	const mat2 to_pixels = toPixels(mat2(dFdx(place), dFdy(place)));
	if (to_pixels == mat2(0.0))
		return 0.0;
	vec2 a = to_pixels * (recordPlace(record, vertices - 1u) - place);
	float nearest = 1e9;
	float twice_area = 0.0;
	float around = 0.0;
	for (uint i = 0u; i < vertices; ++i)
	{
		const vec2 b = to_pixels * (recordPlace(record, i) - place);
		if ((uint(edges.y) & kHiddenRecordEdge << (i > 0u ? i - 1u : vertices - 1u)) == 0u)
			nearest = min(nearest, distanceToEdge(a, b));
		twice_area += a.x * b.y - a.y * b.x;
		around += length(b - a);
		a = b;
	}
	const float width = around > 0.0 ? 2.0 * abs(twice_area) / around : 0.0; // about right for a square or a long strip
	const float of_cell = exp2(float(uint(edges.y) >> kRecordWidthShift) / kRecordWidthSteps);
	return lineCoverage(nearest, of_cell * width, push.mesh_half_width);
}

void main()
{
	pixel = vec2(whole != 0.0 ? whole : value, 0.0);
	if ((kFeatures & kLayerMesh) != 0u)
		pixel.y = meshLine();
	if ((kFeatures & kLayerWindow) != 0u &&
		(place.x < push.window[0] || place.x > push.window[1] || place.y < push.window[2] || place.y > push.window[3]))
		discard;
}
