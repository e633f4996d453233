#pragma once

#include "render/color/color_map.h"
#include "render/picture.h"

#include <string>

namespace view
{

struct Area
{
	std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

// Reads what a screen of Xvfb shows: the file that it keeps with -fbdir, in X's window dump format of 32 bits per pixel
// (see X11/XWDFile.h). The picture is 0 x 0 if the file has another format.
vp::render::Picture readScreen(const std::string& file);

vp::render::Picture part(const vp::render::Picture& picture, const Area& area);

// Parts of 1 of all pixels: that differ at all; that have one of the map's colors, give or take 6 of 255.
double difference(const vp::render::Picture& a, const vp::render::Picture& b);
double shareOf(const vp::render::ColorMap& map, const vp::render::Picture& picture);

} // namespace view
