#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/slice_types.h"

layout(location = 0) in float value;
layout(location = 1) flat in uint is_nan;
layout(location = 0) out float pixel;

void main()
{
	pixel = is_nan != 0u ? kNanValue : value;
}
