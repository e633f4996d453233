#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

// Finds the pixels of a picture at which its first sample does not stand for all, as render_edges.frag does, and lists them two by two.
// A thread takes two columns of a square, and keeps a row's colors for the next.
layout(local_size_x = kEdgeGroupSize) in;
layout(binding = 0) uniform sampler2D picture; // multiplied by alpha
layout(binding = 1, scalar) buffer Tiles
{
	uint tiles[]; // not 0: the color of a pixel at an edge may depend on this square
};
layout(binding = 2, scalar) buffer ListedTiles
{
	TileList tile_list;
	uint listed_tiles[];
};
layout(binding = 3, scalar) buffer ListedQuads
{
	QuadList quad_list;
	uint listed_quads[];
};
layout(push_constant, scalar) uniform Push
{
	EdgePush push;
};

const uint kColumns = kEdgeTile / 2u; // columns of quads in a tile

void listQuad(uvec2 quad)
{
	const uint place = atomicAdd(quad_list.count, 1u);
	const uint group = place / (kQuadGroupSize / 4u);
	atomicMax(quad_list.groups[0], min(group + 1u, kQuadGroupsAcross));
	atomicMax(quad_list.groups[1], group / kQuadGroupsAcross + 1u);
	listed_quads[place] = quad.x | quad.y << 16;
}

void listTile(uint tile)
{
	if (atomicExchange(tiles[tile], 1u) != 0u)
		return;
	listed_tiles[atomicAdd(tile_list.groups[0], 1u)] = tile;
	atomicAdd(tile_list.corners, kTileCorners);
}

// The squares that pixels from `first` to `last` depend on.
void listTiles(ivec2 first, ivec2 last)
{
	const int reach = int(push.reach);
	const ivec2 end = ivec2(push.tiles_across, push.tiles_down) - 1;
	const ivec2 from = max(first - reach, ivec2(0)) / int(kEdgeTile);
	const ivec2 to = min((last + reach) / int(kEdgeTile), end);
	ivec2 tile = from;
	do
	{
		listTile(uint(tile.y) * push.tiles_across + uint(tile.x));
		const bool at_end = tile.x >= to.x;
		tile = at_end ? ivec2(from.x, tile.y + 1) : ivec2(tile.x + 1, tile.y);
	} while (tile.y <= to.y);
}

vec4 departure(vec4 before, vec4 here, vec4 after)
{
	return abs(before + after - 2.0 * here);
}

void main()
{
	const uint column = gl_GlobalInvocationID.x;
	if (column >= push.tiles_across * kColumns)
		return;
	const ivec2 last = textureSize(picture, 0) - 1;
	const int x = 2 * int(column);
	const int top = int(gl_WorkGroupID.y * kEdgeTile);
	const ivec4 across = clamp(ivec4(x - 1, x, x + 1, x + 2), 0, last.x);
	vec4 above_a = texelFetch(picture, ivec2(across.y, max(top - 1, 0)), 0);
	vec4 above_b = texelFetch(picture, ivec2(across.z, max(top - 1, 0)), 0);
	vec4 a = texelFetch(picture, ivec2(across.y, top), 0);
	vec4 b = texelFetch(picture, ivec2(across.z, top), 0);
	uint found = 0u; // a bit for each quad
	int y = 0;
	do
	{
		const int row = min(top + y, last.y);
		const int next = min(top + y + 1, last.y);
		const vec4 left = texelFetch(picture, ivec2(across.x, row), 0);
		const vec4 right = texelFetch(picture, ivec2(across.w, row), 0);
		const vec4 below_a = texelFetch(picture, ivec2(across.y, next), 0);
		const vec4 below_b = texelFetch(picture, ivec2(across.z, next), 0);
		const vec4 most = max(max(departure(left, a, b), departure(above_a, a, below_a)),
							  max(departure(a, b, right), departure(above_b, b, below_b)));
		const bool edge = max(max(most.r, most.g), max(most.b, most.a)) > kPictureEdgeFrom;
		found |= uint(edge) << (y >> 1);
		above_a = a;
		above_b = b;
		a = below_a;
		b = below_b;
		++y;
	} while (y < int(kEdgeTile) && top + y <= last.y);
	found = x <= last.x ? found : 0u;
	if (found != 0u)
		listTiles(ivec2(x, top + 2 * findLSB(found)), ivec2(x + 1, top + 2 * findMSB(found) + 1));
	while (found != 0u)
	{
		listQuad(uvec2(column, top / 2 + findLSB(found)));
		found &= found - 1u;
	}
}
