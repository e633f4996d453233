// Values as colors, of sheets' layers and of surfaces. Selections instead of branches where no fetch is spared: neighboring pixels go different ways at
// every edge.

const float kNoScaled = -3.0e38; // log of what has none

vec4 unpacked(uint color)
{
	return unpackUnorm4x8(color);
}

vec4 tableColor(uint place)
{
	return unpacked(texelFetch(tables, int(place)).x);
}

float tableNumber(uint place)
{
	return uintBitsToFloat(texelFetch(tables, int(place)).x);
}

float scaled(float value, uint layer)
{
	if ((kFeatures & kComposeLog) == 0u || params.sheets[layer].is_log == 0u)
		return value;
	return value > 0.0 ? log2(value) * 0.30102999566398 : kNoScaled;
}

// Returns how many of the ascending numbers are <= y.
uint countUpTo(float y, uint place, uint count)
{
	uint low = 0u;
	while (count > 0u)
	{
		const uint step = count >> 1;
		const bool beyond = tableNumber(place + low + step) <= y;
		low = beyond ? low + step + 1u : low;
		count = beyond ? count - step - 1u : step;
	}
	return low;
}

// Layers and surfaces differ in these functions, so the including shader defines them. steepness(): how much nearer y
// comes to a level above it (`side` 1) or below it (-1), from one pixel to the next. lineBetween(): whether a line runs
// between polygons here. opacityOf(): the opacity.
float steepness(float y, float side, uint layer, ivec2 pixel);
float lineBetween(float y, uint above, uint layer, ivec2 pixel);
float opacityOf(uint layer);

// Lines this many pixels apart and farther have full strength; closer ones would cover everything.
const float kFullStrengthFrom = 5.0;

// Returns how much of a contour line covers this pixel: the distance to the nearest level in values, divided by the
// values' slope, is the distance in pixels. So lines are equally wide everywhere.
float contourLine(float y, uint layer, ivec2 pixel)
{
	const uint place = params.sheets[layer].levels;
	const uint count = params.sheets[layer].level_count;
	if (count == 0u || y <= kNoScaled)
		return 0.0;
	const uint above = countUpTo(y, place, count);
	if (params.sheets[layer].is_stepped != 0u)
		return lineBetween(y, above, layer, pixel);
	const float lower = tableNumber(place + max(above, 1u) - 1u);
	const float upper = tableNumber(place + min(above, count - 1u));
	const bool to_upper = abs(upper - y) < abs(y - lower);
	const float level = to_upper ? upper : lower;
	const float steep = steepness(y, level >= y ? 1.0 : -1.0, layer, pixel);
	if (!(steep > 0.0))
		return 0.0;
	const float apart = upper > lower ? (upper - lower) / steep : kFullStrengthFrom;
	return clamp(params.contour_half_width + 0.5 - abs(level - y) / steep, 0.0, 1.0) *
		   clamp(apart / kFullStrengthFrom, 0.1, 1.0);
}

// Dark on light, light on dark: on colors darker than this.
const float kDarkForContours = 0.33;
const float kDarkForMesh = 0.2; // a mesh runs through many colors, and is to change seldom

float inkOn(vec3 color, float dark)
{
	return dot(color, vec3(0.2126, 0.7152, 0.0722)) < dark ? 0.92 : 0.07;
}

// Lines over a color: not multiplied by alpha, as what they lie over.
vec4 inked(vec4 color, float ink, float coverage, float opacity)
{
	// On a faint sheet lines are not as faint.
	const float over = coverage * sqrt(opacity);
	const float alpha = over + (1.0 - over) * color.a;
	const vec3 mixed = over * vec3(ink) + (1.0 - over) * color.a * color.rgb;
	return alpha > 0.0 ? vec4(mixed / alpha, alpha) : vec4(0.0);
}

const float kContourInk = 0.75;
const float kMeshInk = 0.5;

// The lines that run over a color. texel: value, and how much of a mesh line is here.
vec4 withLines(vec4 color, vec2 texel, uint layer, ivec2 pixel)
{
	const vec3 ground = color.rgb;
	if ((kFeatures & kComposeMesh) != 0u)
		color = inked(color, inkOn(ground, kDarkForMesh), kMeshInk * texel.y, opacityOf(layer));
	if ((kFeatures & kComposeLines) != 0u && abs(texel.x) < kInfiniteFrom)
		color = inked(color, inkOn(ground, kDarkForContours),
					  kContourInk * contourLine(scaled(texel.x, layer), layer, pixel), opacityOf(layer));
	return color;
}
