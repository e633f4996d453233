// The functions that color a layer from the pixels around, which have values of the same layer.

// Returns y of a neighbor, or `here` if the neighbor has none.
float neighbor(ivec2 pixel, ivec2 offset, uint layer, float here)
{
	const ivec2 at = pixel + offset;
	if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, textureSize(layers, 0).xy)))
		return here;
	const float value = texelFetch(layers, ivec3(at, int(layer)), 0).x;
	if (abs(value) >= kInfiniteFrom) // empty, NaN or infinite
		return here;
	const float y = scaled(value, layer);
	return y > kNoScaled ? y : here;
}

// If values are constant in each polygon, lines run between polygons: wherever a neighbor's value is beyond a level.
float lineBetween(float y, uint above, uint layer, ivec2 pixel)
{
	const int reach = max(1, int(params.contour_half_width + 0.5));
	for (int i = 0; i < 4; ++i)
	{
		const ivec2 offset = reach * (1 - (i & 2)) * ((i & 1) == 0 ? ivec2(1, 0) : ivec2(0, 1));
		const float there = neighbor(pixel, offset, layer, y);
		if (countUpTo(there, params.sheets[layer].levels, params.sheets[layer].level_count) != above)
			return 1.0;
	}
	return 0.0;
}

// Only the neighbor that leads toward the level counts. The other may lie behind a kink or a jump.
float steepness(float y, float side, uint layer, ivec2 pixel)
{
	vec2 rise = vec2(0.0);
	for (int i = 0; i < 4; ++i)
	{
		const ivec2 offset = (1 - (i & 2)) * ((i & 1) == 0 ? ivec2(1, 0) : ivec2(0, 1));
		rise[i & 1] = max(rise[i & 1], side * (neighbor(pixel, offset, layer, y) - y));
	}
	return length(rise);
}

float opacityOf(uint layer)
{
	return params.sheets[layer].opacity;
}

// The place of a value's color in the table of layers' colors (engine/render/layer_colors.h).
uint colorPlace(float value, uint layer)
{
	const float y = scaled(value, layer);
	const uint table = params.layer_colors[layer];
	uint place = table + kLayerRange;
	if ((kFeatures & kComposeSteps) != 0u && params.sheets[layer].step_count > 0u)
		place += countUpTo(y, params.sheets[layer].step_bounds, params.sheets[layer].step_count);
	else
	{
		const float t =
			(y - params.sheets[layer].range_lo) * params.sheets[layer].range_scale + params.sheets[layer].range_offset;
		place += uint(clamp(t, 0.0, 1.0) * float(kLayerRangeColors - 1u) + 0.5);
	}
	place = y < params.sheets[layer].below_from ? table + kLayerBelow : place;
	place = y > params.sheets[layer].above_from ? table + kLayerAbove : place;
	return value >= kNanFrom ? table + kLayerNan : place;
}

vec4 layerColor(uint place)
{
	const uvec2 channels = texelFetch(colors, int(place)).xy;
	return vec4(unpackUnorm2x16(channels.x), unpackUnorm2x16(channels.y));
}
