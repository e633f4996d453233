#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

layout(location = 0) in vec2 position; // pixels
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
layout(push_constant, scalar) uniform Push
{
	OverlayPush push;
};

layout(location = 0) out vec2 letter;
layout(location = 1) out vec4 ink;

void main()
{
	letter = uv;
	ink = color;
	gl_Position = vec4(position * vec2(push.to_clip[0], push.to_clip[1]) - 1.0, 0.0, 1.0);
}
