// Returns `front` over the picture's background. Both `front` and the result are multiplied by alpha.
vec4 overBackground(vec4 front, float y)
{
	vec4 background;
	for (int i = 0; i < 4; ++i)
		background[i] = mix(params.top_color[i], params.bottom_color[i], y / params.height);
	background.rgb *= background.a;
	return front + (1.0 - front.a) * background;
}
