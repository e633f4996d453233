// A corner's place in subpixels from the first pixel's center, as whole numbers. at: x and y times w, and w. The compute rasterizer
// and the hardware's share corners, which both must put at the same place: so both round here, in the same steps.
vec2 snapped(vec3 at)
{
	precise const vec2 place = at.xy * (1.0 / at.z);
	return roundEven(place);
}

vec3 placeTimesW(vec2 uv, vec3 u_axis, vec3 v_axis, vec3 origin)
{
	precise const vec3 at = uv.x * u_axis + (uv.y * v_axis + origin);
	return at;
}
