#version 460
#extension GL_GOOGLE_include_directive : require
#define VP_DOUBLES 1
#define VP_REAL double
#define VP_REAL3 dvec3
#include "classify.glsl"
