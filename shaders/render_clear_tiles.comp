#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"

// Empties a layer of values in the listed squares of pixels, a group each.
layout(local_size_x = kEdgeTile) in;
layout(binding = 0, r32f) uniform writeonly image2D layer;
layout(binding = 1, scalar) readonly buffer Listed
{
	TileList list;
	uint listed[];
};
layout(push_constant, scalar) uniform Push
{
	EdgePush push;
};

void main()
{
	const uint tile = listed[gl_WorkGroupID.x];
	const ivec2 corner = ivec2(tile % push.tiles_across, tile / push.tiles_across) * int(kEdgeTile);
	const ivec2 end = min(corner + int(kEdgeTile), imageSize(layer));
	const int x = corner.x + int(gl_LocalInvocationID.x);
	for (int y = corner.y; y < end.y; ++y)
		if (x < end.x)
			imageStore(layer, ivec2(x, y), vec4(kEmptyValue));
}
