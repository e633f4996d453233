#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

// The mean of the samples over the background. A picture of one sample has no mask, and any weight is 1.
layout(binding = 0, scalar) uniform Params
{
	ComposeParams params;
};
layout(binding = 1) uniform sampler2D sum;
layout(binding = 2) uniform sampler2D mask; // 0 where all samples are in the sum, else the first is
layout(push_constant, scalar) uniform Push
{
	ResolvePush push;
};
layout(location = 0) out vec4 pixel; // multiplied by alpha

#include "render_background.glsl"

void main()
{
	const ivec2 at = ivec2(gl_FragCoord.xy) - ivec2(0, push.first_row);
	const float weight = texelFetch(mask, at, 0).x < 0.5 ? params.sample_weight : 1.0;
	const vec4 front = texelFetch(sum, at, 0) * weight;
	pixel = overBackground(front, gl_FragCoord.y);
}
