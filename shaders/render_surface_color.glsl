// The color of a surface's fragment, for surfaces that hide what is behind them and for others.
layout(binding = 5, scalar) uniform Params
{
	SurfaceColors params;
};
layout(binding = 6) uniform usamplerBuffer tables;
layout(push_constant, scalar) uniform Push
{
	SurfacePush push;
};
layout(constant_id = 0) const uint kFeatures = 0u;

layout(location = 0) in float value;
layout(location = 1) flat in float whole;
layout(location = 2) in vec3 to_eye;
layout(location = 3) in vec3 normal;
layout(location = 4) in vec2 place;
layout(location = 5) flat in uint hidden;
layout(location = 6) flat in float width;
layout(location = 7) flat in vec3 across;

#include "render_colors.glsl"

vec2 slope; // slope of the value y along the picture's x and y

float steepness(float y, float side, uint layer, ivec2 pixel)
{
	return length(slope);
}

mat2 to_pixels; // from `place`

vec2 corner(uint i)
{
	return to_pixels * (vec2(i == 1u, i == 2u) - place);
}

// Lines of values that are constant in each polygon lie on edges beyond which there is another level.
float lineBetween(float y, uint above, uint layer, ivec2 pixel)
{
	float nearest = 1e9;
	for (uint i = 0u; i < 3u; ++i)
		if (countUpTo(scaled(across[i], layer), params.sheets[layer].levels, params.sheets[layer].level_count) != above)
			nearest = min(nearest, distanceToEdge(corner(i), corner((i + 1u) % 3u)));
	return to_pixels == mat2(0.0) ? 0.0 : clamp(params.contour_half_width + 0.5 - nearest, 0.0, 1.0);
}

// A surface has two sides, both bright where they face the light.
float shadeOf(uint layer)
{
	if ((kFeatures & kSurfaceLit) == 0u)
		return 1.0;
	const vec3 light = vec3(params.light[0], params.light[1], params.light[2]);
	return kAmbient + (1.0 - kAmbient) * abs(dot(normalize(normal), light));
}

// The longest way through a thick surface. The more it is seen from the side, the longer the way.
const float kLongestWay = 3.0;

float opacityOf(uint layer)
{
	const float opacity = params.sheets[layer].opacity;
	if ((kFeatures & kSurfaceThick) == 0u)
		return opacity;
	const float facing = abs(dot(normalize(normal), normalize(to_eye)));
	return 1.0 - pow(1.0 - opacity, 1.0 / max(facing, 1.0 / kLongestWay));
}

float meshLine()
{
	if (to_pixels == mat2(0.0))
		return 0.0;
	float nearest = 1e9;
	float around = 0.0;
	for (uint i = 0u; i < 3u; ++i)
	{
		const vec2 from = corner(i);
		const vec2 to = corner((i + 1u) % 3u);
		if ((hidden >> i & 1u) == 0u)
			nearest = min(nearest, distanceToEdge(from, to));
		around += length(to - from);
	}
	return lineCoverage(nearest, width * 2.0 * abs(determinant(to_pixels)) / around, push.mesh_half_width);
}

uint tenBits(float part)
{
	return uint(clamp(part, 0.0, 1.0) * 1023.0 + 0.5);
}

// Not multiplied by alpha, the opacity taken in. texel: value, and how much of a mesh line is here.
vec4 colorOf(vec2 texel, uint layer, ivec2 pixel)
{
	const float y = scaled(texel.x, layer);
	vec4 color;
	if ((kFeatures & kComposeSteps) != 0u && params.sheets[layer].step_count > 0u)
		color = tableColor(params.sheets[layer].step_colors +
						   countUpTo(y, params.sheets[layer].step_bounds, params.sheets[layer].step_count));
	else
	{
		const float t = clamp((y - params.sheets[layer].range_lo) * params.sheets[layer].range_scale +
								  params.sheets[layer].range_offset,
							  0.0, 1.0);
		const float place = float(kTableColors - 1u) * t;
		const uint low = min(uint(place), kTableColors - 2u);
		const uint colors = params.sheets[layer].colors + low;
		color = mix(tableColor(colors), tableColor(colors + 1u), place - float(low));
	}
	color = y < params.sheets[layer].below_from ? unpacked(params.sheets[layer].below_color) : color;
	color = y > params.sheets[layer].above_from ? unpacked(params.sheets[layer].above_color) : color;
	const bool is_nan = texel.x >= kNanFrom;
	color = is_nan ? unpacked(params.sheets[layer].nan_color) : color;

	color *= vec4(vec3(shadeOf(layer)), opacityOf(layer));
	return withLines(color, texel, layer, pixel);
}

// Red, green and blue in 10 bits each.
uint packedColor(vec3 color)
{
	return tenBits(color.r) | tenBits(color.g) << 10 | tenBits(color.b) << 20;
}

vec4 fragmentColor()
{
	const float y = scaled(value, push.surface);
	slope = vec2(dFdx(y), dFdy(y));
	to_pixels = (kFeatures & (kComposeMesh | kComposeLines)) != 0u ? toPixels(mat2(dFdx(place), dFdy(place))) : mat2(0.0);
	const float mesh = (kFeatures & kComposeMesh) != 0u ? meshLine() : 0.0;
	return colorOf(vec2(whole != 0.0 ? whole : value, mesh), push.surface, ivec2(0));
}
