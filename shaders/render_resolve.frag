#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

// The mean of the samples over the background.
layout(binding = 0, scalar) uniform Params
{
	ComposeParams params;
};
layout(binding = 1) uniform sampler2D sum;
layout(location = 0) out vec4 pixel; // multiplied by alpha

#include "render_background.glsl"

void main()
{
	const vec4 front = texelFetch(sum, ivec2(gl_FragCoord.xy), 0) * params.sample_weight;
	pixel = overBackground(front, gl_FragCoord.y);
}
