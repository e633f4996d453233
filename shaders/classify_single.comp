#version 460
#extension GL_GOOGLE_include_directive : require
#define VP_DOUBLES 0
#define VP_REAL float
#define VP_REAL3 vec3
#include "classify.glsl"
