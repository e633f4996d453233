#pragma once

#include "render/color/color_map.h"

namespace vp::render
{

// The built-in color maps, in the order in which they are listed: X(name for users, function). Each function is in a
// file of its own, map_NAME.cpp.
#define VP_COLOR_MAPS(X)                                                                                               \
	X("viridis", viridis)                                                                                              \
	X("cividis", cividis)                                                                                              \
	X("turbo", turbo)                                                                                                  \
	X("cool-warm", coolWarm)                                                                                           \
	X("grey", gray)

#define VP_DECLARE(name, make) ColorMap make();
VP_COLOR_MAPS(VP_DECLARE)
#undef VP_DECLARE

// A map of kColorMapSize colors from as many times six hex digits, RRGGBB.
ColorMap mapFromHex(const char* digits);

} // namespace vp::render
