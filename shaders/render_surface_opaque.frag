#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"
#include "render_mesh_lines.glsl"
#include "render_surface_color.glsl"

// The nearest fragment of the opaque surfaces at a pixel: its color, and the number of its surface. Its depth is in the depth buffer.
layout(location = 0) out uvec2 nearest;

void main()
{
	nearest = uvec2(packedColor(fragmentColor().rgb), push.surface);
}
