// Lines along polygons' edges, as they are from the pixel at the origin, in pixels.

// Lines have full strength if polygons are at least this many pixels wide. Narrower polygons would be all line, so the
// strength falls, down to kMinStrength for polygons no wider than a pixel.
const float kFullStrengthFromWidth = 6.0;
const float kMinStrength = 0.1;

// Returns how much of a line covers a pixel, from the distance of its nearest edge and the polygon's width (4 area /
// perimeter).
float lineCoverage(float nearest, float width, float half_width)
{
	const float strength = clamp((width - 1.0) / (kFullStrengthFromWidth - 1.0), kMinStrength, 1.0);
	return strength * clamp(half_width + 0.5 - nearest, 0.0, 1.0);
}

float distanceToEdge(vec2 a, vec2 b)
{
	const vec2 along = b - a;
	const float square = dot(along, along);
	const float part = square > 0.0 ? clamp(-dot(a, along) / square, 0.0, 1.0) : 0.0;
	return length(a + part * along);
}

// From coordinates on a polygon to pixels, for the derivatives of coordinates along x and y; all zero where it is seen edge on.
mat2 toPixels(mat2 derivatives)
{
	const float area = determinant(derivatives);
	const bool edge_on = abs(area) <= 1e-6 * dot(derivatives[0], derivatives[0]) + 1e-6 * dot(derivatives[1], derivatives[1]);
	return edge_on ? mat2(0.0) : inverse(derivatives);
}
