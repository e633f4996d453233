#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_mesh_lines.glsl"

// A fragment of a translucent surface goes into the list of its pixel. All are counted, also those for which there is no room: the
// picture is drawn again then (FragmentLists). Nothing behind an opaque surface is listed.
layout(early_fragment_tests) in;
layout(binding = 2, r32ui) uniform uimage2D heads;
layout(binding = 3, scalar) writeonly buffer Fragments
{
	SurfaceFragment fragments[];
};
layout(binding = 4, scalar) buffer Counters
{
	uint counters[];
};
#include "render_surface_color.glsl"

void main()
{
	const vec4 color = fragmentColor();
	const uint alpha = uint(clamp(color.a, 0.0, 1.0) * 65535.0 + 0.5);
	// The count must not come round to zero.
	if (alpha == 0u || counters[push.counter] >= 0x80000000u)
		return;
	const uint at = atomicAdd(counters[push.counter], 1u);
	if (at >= push.capacity)
		return;
	fragments[at].next = imageAtomicExchange(heads, ivec2(gl_FragCoord.xy), at + 1u);
	fragments[at].depth = gl_FragCoord.z;
	fragments[at].color = packedColor(color.rgb);
	fragments[at].order = push.surface << 16 | alpha;
}
