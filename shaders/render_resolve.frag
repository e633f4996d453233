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

void main()
{
	const vec4 front = texelFetch(sum, ivec2(gl_FragCoord.xy), 0) * params.sample_weight;
	vec4 background;
	for (int i = 0; i < 4; ++i)
		background[i] = mix(params.top_color[i], params.bottom_color[i], gl_FragCoord.y / params.height);
	background.rgb *= background.a;
	pixel = front + (1.0 - front.a) * background;
}
