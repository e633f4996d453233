#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

// Lists the squares of pixels that the color of a pixel at an edge may depend on.
layout(local_size_x = kEdgeGroupSize) in;
layout(binding = 0) uniform sampler2D mask;
layout(binding = 1, scalar) writeonly buffer Tiles
{
	uint tiles[];
};
layout(binding = 2, scalar) buffer Listed
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
	const uint tile = gl_GlobalInvocationID.x;
	if (tile >= push.tiles_across * push.tiles_down)
		return;
	const ivec2 corner = ivec2(tile % push.tiles_across, tile / push.tiles_across) * int(kEdgeTile);
	const ivec2 end = textureSize(mask, 0);
	const ivec2 first = max(corner - int(push.reach), ivec2(0));
	const ivec2 last = min(corner + int(kEdgeTile + push.reach), end) - 1;
	bool found = false;
	int y = first.y;
	do
	{
		int x = first.x;
		do
		{
			found = found || texelFetch(mask, ivec2(x, y), 0).x < 0.5;
			++x;
		} while (x <= last.x && !found);
		++y;
	} while (y <= last.y && !found);
	tiles[tile] = uint(found);
	if (found)
	{
		listed[atomicAdd(list.groups[0], 1u)] = tile;
		atomicAdd(list.corners, kTileCorners);
	}
}
