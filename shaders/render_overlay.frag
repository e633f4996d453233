#version 460

layout(binding = 0) uniform sampler2D letters;
layout(location = 0) in vec2 letter;
layout(location = 1) in vec4 ink;
layout(location = 0) out vec4 pixel;

void main()
{
	const float alpha = ink.a * texture(letters, letter).r;
	pixel = vec4(alpha * ink.rgb, alpha);
}
