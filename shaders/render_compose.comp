#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"

// One sample of a picture: at each pixel the sheets that are there, nearest first by their planes' equations, and the lines
// between them, blended from front to back. The last sample adds the background and stores the mean.
layout(local_size_x = kComposeGroupSize, local_size_y = kComposeGroupSize) in;

layout(binding = 0, scalar) readonly buffer Params
{
	ComposeParams params;
};
layout(binding = 1) uniform sampler2DArray layers;
layout(binding = 2) uniform sampler2D lines;
layout(binding = 3, rgba32f) uniform image2D sum;
layout(binding = 4, rgba8) uniform writeonly image2D picture;
layout(push_constant, scalar) uniform Push
{
	ComposePush push;
};

const float kNanFrom = 0.5 * kNanValue;
const float kEmptyUpTo = 0.5 * kEmptyValue;

// The interpolation's rounding must not take the range's own ends out of it.
const float kRangeSlack = 1e-5;

vec3 colorOf(float value)
{
	if (params.has_values == 0u)
		return unpackUnorm4x8(params.plain_color).rgb;
	if (value >= kNanFrom)
		return unpackUnorm4x8(params.nan_color).rgb;
	if (params.clipped != 0u)
	{
		const float slack = kRangeSlack * (params.range_hi - params.range_lo);
		if (value < params.range_lo - slack)
			return unpackUnorm4x8(params.below_color).rgb;
		if (value > params.range_hi + slack)
			return unpackUnorm4x8(params.above_color).rgb;
	}
	const float t = clamp((value - params.range_lo) * params.range_scale + params.range_offset, 0.0, 1.0);
	const float place = 255.0 * t;
	const int low = min(int(place), 254);
	return mix(unpackUnorm4x8(params.colors[low]).rgb, unpackUnorm4x8(params.colors[low + 1]).rgb, place - float(low));
}

vec4 rgba(float c[4])
{
	return vec4(c[0], c[1], c[2], c[3]);
}

void under(inout vec4 front, vec3 color, float alpha)
{
	front += (1.0 - front.a) * alpha * vec4(color, 1.0);
}

void main()
{
	const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
	if (pixel.x >= int(params.width) || pixel.y >= int(params.height))
		return;
	const vec2 place = vec2(pixel) + 0.5 - vec2(push.jitter[0], push.jitter[1]);

	// What is here, sorted by falling near / w.
	float depths[kMaxLayers];
	float values[kMaxLayers];
	float opacities[kMaxLayers];
	uint count = 0u;
	for (uint i = 0u; i < params.layers; ++i)
	{
		const float value = texelFetch(layers, ivec3(pixel, int(i)), 0).x;
		if (value <= kEmptyUpTo)
			continue;
		const float depth = params.plane[4u * i] * place.x + params.plane[4u * i + 1u] * place.y + params.plane[4u * i + 2u];
		uint slot = count++;
		for (; slot > 0u && depths[slot - 1u] < depth; --slot)
		{
			depths[slot] = depths[slot - 1u];
			values[slot] = values[slot - 1u];
			opacities[slot] = opacities[slot - 1u];
		}
		depths[slot] = depth;
		values[slot] = value;
		opacities[slot] = params.plane[4u * i + 3u];
	}

	vec4 front = vec4(0.0);
	const float line_depth = texelFetch(lines, pixel, 0).x;
	bool line_left = line_depth > 0.0;
	const vec4 line_color = rgba(params.line_color);
	for (uint i = 0u; i < count; ++i)
	{
		if (line_left && line_depth >= depths[i])
		{
			under(front, line_color.rgb, line_color.a);
			line_left = false;
		}
		under(front, colorOf(values[i]), opacities[i]);
	}
	if (line_left)
		under(front, line_color.rgb, line_color.a);

	if (push.sample_index > 0u)
		front += imageLoad(sum, pixel);
	if (push.sample_index + 1u < push.sample_count)
	{
		imageStore(sum, pixel, front);
		return;
	}
	front /= float(push.sample_count);
	const float down = (float(pixel.y) + 0.5) / float(params.height);
	const vec4 background = mix(rgba(params.top_color), rgba(params.bottom_color), down);
	under(front, background.rgb, background.a);
	imageStore(picture, pixel, front);
}
