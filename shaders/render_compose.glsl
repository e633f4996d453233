// The composing pass: of all pixels or those at edges (QUADS), with or without surfaces (SURFACES).
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
layout(binding = 3) uniform usamplerBuffer tables; // values at which colors change, and levels
layout(binding = 4) uniform usamplerBuffer colors; // colors of layers, 16 bits a channel
#ifdef SURFACES
layout(binding = 5, r32ui) uniform readonly uimage2D heads; // first entries of the lists of surface fragments
layout(binding = 6) uniform usamplerBuffer fragments; // SurfaceFragment each, which software reads faster as texels
layout(binding = 7) uniform usampler2D opaque; // the nearest fragment of opaque surfaces (render_surface_opaque.frag)
layout(binding = 8) uniform sampler2D opaque_depths;
#endif
layout(push_constant, scalar) uniform Push
{
	ComposePush push;
};
// Multiplied by alpha.
#ifdef QUADS
vec4 front;
#else
layout(location = 0) out vec4 front;
#endif

// Room for the layers at a pixel: the smallest of ComposePass::kSlots that takes them all.
layout(constant_id = 0) const uint kSlots = 1u;
layout(constant_id = 1) const uint kFeatures = 0u;

#include "render_colors.glsl"
#include "render_layer_colors.glsl"
#include "render_background.glsl"

const float kBehindAll = -1.0; // as the depth of an empty slot
const float kBeforeAll = 1e30;

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

// Returns the layer in a slot. Each layer that may be here has a slot. Slots after the last one repeat the first layer.
uint layerIn(uint slot)
{
	const uint shown = slot < push.layers ? slot : 0u;
	return (push.slots[shown >> 3] >> (4u * (shown & 7u))) & 0xFu;
}

// The layers at a pixel, and what is between them.
void composeLayers(ivec2 pixel)
{
	const vec2 place = vec2(pixel) + 0.5 - vec2(push.jitter[0], push.jitter[1]);

	// The layers here. An empty slot lies behind all others. Indices are constant because kSlots is, so the arrays are
	// registers.
	float depths[kSlots];
	vec2 texels[kSlots];
	uint places[kSlots];
	for (uint i = 0u; i < kSlots; ++i)
	{
		const uint layer = layerIn(i);
		texels[i] = texelFetch(layers, ivec3(pixel, int(layer)), 0).xy;
		const float depth = params.sheets[layer].plane[0] * place.x + params.sheets[layer].plane[1] * place.y +
							params.sheets[layer].plane[2];
		depths[i] = i < push.layers && texels[i].x > kEmptyUpTo ? max(depth, 0.0) : kBehindAll;
		places[i] = colorPlace(texels[i].x, layer);
	}

	// The nearest layer that is left, round by round; of equal depths the first, as sheets in one plane have them. Software ends
	// the rounds as soon as all its pixels have done: most have one layer or none. Lavapipe (Mesa 22.3) then keeps some of what a
	// further round does to a pixel that has done, and drew its line twice. So such a round must do nothing.
	bool left;
	do
	{
		uint slot = 0u;
		float depth = depths[0];
		vec2 texel = texels[0];
		uint color_place = places[0];
		for (uint i = 1u; i < kSlots; ++i)
		{
			const bool nearer = depths[i] > depth;
			slot = nearer ? i : slot;
			depth = nearer ? depths[i] : depth;
			texel = nearer ? texels[i] : texel;
			color_place = nearer ? places[i] : color_place;
		}
		left = false;
		for (uint i = 0u; i < kSlots; ++i)
		{
			depths[i] = i == slot ? kBehindAll : depths[i];
			left = left || depths[i] > kBehindAll;
		}
		const float down_to = depth > kBehindAll ? depth : kBeforeAll;
#ifdef SURFACES
		surfacesDownTo(down_to);
#endif
		lineDownTo(down_to);
		const vec4 color = withLines(layerColor(color_place), texel, layerIn(slot), pixel);
		under(color.rgb, depth > kBehindAll ? color.a : 0.0);
	} while (left);
}

void compose(ivec2 pixel)
{
	front = vec4(0.0);
	line_depth = texelFetch(lines, pixel, 0).x;
	line_left = line_depth > 0.0 ? params.line_color[3] : 0.0;
#ifdef SURFACES
	beginList(pixel);
#endif
	if ((kFeatures & kComposeGround) == 0u)
		composeLayers(pixel);
#ifdef SURFACES
	surfacesDownTo(kBehindAll);
#endif
	lineDownTo(kBehindAll);
	if ((kFeatures & kComposeWhole) != 0u)
		front = overBackground(front, float(pixel.y) + 0.5);
}

#ifndef QUADS
void main()
{
	compose(ivec2(gl_FragCoord.xy));
}
#endif
