#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

// The listed squares of pixels, at depth 0.
layout(binding = 0, scalar) readonly buffer Listed
{
	TileList list;
	uint listed[];
};
layout(push_constant, scalar) uniform Push
{
	TilesPush push;
};

void main()
{
	const uint tile = listed[uint(gl_VertexIndex) / kTileCorners];
	const uint corner = uint(gl_VertexIndex) % kTileCorners;
	const uvec2 side = uvec2(corner == 1u || corner >= 4u, corner == 2u || corner == 3u || corner == 5u);
	const uvec2 place = (uvec2(tile % push.across, tile / push.across) + side) * kEdgeTile;
	gl_Position = vec4(vec2(place) * vec2(push.to_clip[0], push.to_clip[1]) - 1.0, 0.0, 1.0);
}
