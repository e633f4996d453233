#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/slice_types.h"
#include "shared/render_types.h"

// One sample of a picture: at each pixel the sheets that are there, nearest first by their planes' equations, and the lines
// between them, blended from front to back. Samples are summed by the hardware's blending.

layout(binding = 0, scalar) uniform Params
{
	ComposeParams params;
};
layout(binding = 1) uniform sampler2DArray layers;
layout(binding = 2) uniform sampler2D lines;
layout(push_constant, scalar) uniform Push
{
	ComposePush push;
};
layout(location = 0) out vec4 front; // multiplied by alpha

// Room for the layers at a pixel: the smallest of ComposePass::kSlots that takes them all.
layout(constant_id = 0) const uint kSlots = 1u;

const float kNanFrom = 0.5 * kNanValue;
const float kEmptyUpTo = 0.5 * kEmptyValue;

vec3 unpacked(uint color)
{
	return unpackUnorm4x8(color).rgb;
}

// Selections instead of branches throughout: neighbouring pixels go different ways at every edge.
vec3 colorOf(float value)
{
	const float t = clamp((value - params.range_lo) * params.range_scale + params.range_offset, 0.0, 1.0);
	const float place = 255.0 * t;
	const int low = min(int(place), 254);
	vec3 color = mix(unpacked(params.colors[low]), unpacked(params.colors[low + 1]), place - float(low));
	color = value < params.below_from ? unpacked(params.below_color) : color;
	color = value > params.above_from ? unpacked(params.above_color) : color;
	color = value >= kNanFrom ? unpacked(params.nan_color) : color;
	return params.has_values == 0u ? unpacked(params.plain_color) : color;
}

vec4 rgba(float c[4])
{
	return vec4(c[0], c[1], c[2], c[3]);
}

void under(vec3 color, float alpha)
{
	front += (1.0 - front.a) * alpha * vec4(color, 1.0);
}

void main()
{
	const ivec2 pixel = ivec2(gl_FragCoord.xy);
	const vec2 place = gl_FragCoord.xy - vec2(push.jitter[0], push.jitter[1]);

	// What is here; an empty slot is transparent. Loops and indices are constant once kSlots is, so the arrays are registers.
	float depths[kSlots];
	float values[kSlots];
	float opacities[kSlots];
	for (uint i = 0u; i < kSlots; ++i)
	{
		const uint layer = min(i, params.last_layer);
		const float value = texelFetch(layers, ivec3(pixel, int(layer)), 0).x;
		const bool here = i <= params.last_layer && value > kEmptyUpTo;
		const float depth =
			params.plane[4u * layer] * place.x + params.plane[4u * layer + 1u] * place.y + params.plane[4u * layer + 2u];
		depths[i] = here ? max(depth, 0.0) : -1.0;
		values[i] = value;
		opacities[i] = here ? params.plane[4u * layer + 3u] : 0.0;
	}
	for (uint last = kSlots - 1u; last > 0u; --last)
		for (uint i = 0u; i < last; ++i)
		{
			const bool swap = depths[i] < depths[i + 1u];
			const vec3 a = vec3(depths[i], values[i], opacities[i]);
			const vec3 b = vec3(depths[i + 1u], values[i + 1u], opacities[i + 1u]);
			const vec3 near = swap ? b : a;
			const vec3 far = swap ? a : b;
			depths[i] = near.x;
			values[i] = near.y;
			opacities[i] = near.z;
			depths[i + 1u] = far.x;
			values[i + 1u] = far.y;
			opacities[i + 1u] = far.z;
		}

	front = vec4(0.0);
	const float line_depth = texelFetch(lines, pixel, 0).x;
	const vec4 line_color = rgba(params.line_color);
	float line_left = line_depth > 0.0 ? line_color.a : 0.0;
	for (uint i = 0u; i < kSlots; ++i)
	{
		const float line_here = line_depth >= depths[i] ? line_left : 0.0;
		under(line_color.rgb, line_here);
		line_left -= line_here;
		under(colorOf(values[i]), opacities[i]);
	}
	under(line_color.rgb, line_left);
}
