// The composing pass, with or without surfaces (SURFACES).
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
layout(binding = 3) uniform usamplerBuffer tables; // of colours, and of the values where they change
#ifdef SURFACES
layout(binding = 4, r32ui) uniform readonly uimage2D heads; // of the lists of surface fragments
layout(binding = 5) uniform usamplerBuffer fragments; // SurfaceFragment each, which software reads faster as texels
#endif
layout(push_constant, scalar) uniform Push
{
	ComposePush push;
};
layout(location = 0) out vec4 front; // multiplied by alpha

// Room for the layers at a pixel: the smallest of ComposePass::kSlots that takes them all.
layout(constant_id = 0) const uint kSlots = 1u;
layout(constant_id = 1) const uint kFeatures = 0u;

#include "render_colors.glsl"
#include "render_layer_colors.glsl"

const float kBehindAll = -1.0; // as the depth of an empty slot

vec4 rgba(float c[4])
{
	return vec4(c[0], c[1], c[2], c[3]);
}

void under(vec3 color, float alpha)
{
	front += (1.0 - front.a) * alpha * vec4(color, 1.0);
}

// The outline, one line a pixel at most.
float line_depth;
float line_left; // alpha that is not blended yet

void lineDownTo(float depth)
{
	const float here = line_depth >= depth ? line_left : 0.0;
	under(rgba(params.line_color).rgb, here);
	line_left -= here;
}

#ifdef SURFACES
#include "render_surface_list.glsl"
#endif

void main()
{
	const ivec2 pixel = ivec2(gl_FragCoord.xy);
	const vec2 place = gl_FragCoord.xy - vec2(push.jitter[0], push.jitter[1]);

	// What is here; an empty slot is transparent. Loops and indices are constant once kSlots is, so the arrays are registers.
	float depths[kSlots];
	uvec2 colors[kSlots];
	for (uint i = 0u; i < kSlots; ++i)
	{
		const uint layer = min(i, params.last_layer);
		const vec2 texel = texelFetch(layers, ivec3(pixel, int(layer)), 0).xy;
		const bool here = i <= params.last_layer && texel.x > kEmptyUpTo;
		const float depth = params.sheets[layer].plane[0] * place.x + params.sheets[layer].plane[1] * place.y +
							params.sheets[layer].plane[2];
		const vec4 color = here ? colorOf(texel, layer, pixel) : vec4(0.0);
		depths[i] = here ? max(depth, 0.0) : kBehindAll;
		colors[i] = uvec2(packUnorm2x16(color.rg), packUnorm2x16(color.ba));
	}
	// Equal depths keep their order: of sheets in one plane the first is in front.
	for (uint last = kSlots - 1u; last > 0u; --last)
		for (uint i = 0u; i < last; ++i)
		{
			const bool swap = depths[i] < depths[i + 1u];
			const float near = swap ? depths[i + 1u] : depths[i];
			const float far = swap ? depths[i] : depths[i + 1u];
			const uvec2 near_color = swap ? colors[i + 1u] : colors[i];
			const uvec2 far_color = swap ? colors[i] : colors[i + 1u];
			depths[i] = near;
			colors[i] = near_color;
			depths[i + 1u] = far;
			colors[i + 1u] = far_color;
		}

	front = vec4(0.0);
	line_depth = texelFetch(lines, pixel, 0).x;
	line_left = line_depth > 0.0 ? params.line_color[3] : 0.0;
#ifdef SURFACES
	beginList(pixel);
#endif
	for (uint i = 0u; i < kSlots; ++i)
	{
#ifdef SURFACES
		surfacesDownTo(depths[i]);
#endif
		lineDownTo(depths[i]);
		const vec2 blue_alpha = unpackUnorm2x16(colors[i].y);
		under(vec3(unpackUnorm2x16(colors[i].x), blue_alpha.x), blue_alpha.y);
	}
#ifdef SURFACES
	surfacesDownTo(kBehindAll);
#endif
	lineDownTo(kBehindAll);
}
