#version 460
#extension GL_GOOGLE_include_directive : require
#include "classify_surface.glsl"
// surfaceAt() follows: it is written for each expression while the program runs.
