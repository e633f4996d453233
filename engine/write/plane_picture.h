#pragma once

#include "base/result.h"
#include "render/flat/flat_scene.h"

#include <optional>
#include <span>
#include <string>

namespace vp::write
{

enum class PictureFormat
{
	png,
	svg,
	pdf // three quarters of a point to a pixel, as on a page of 96 dots to the inch
};

// By the path's ending, in any case; none for any other.
std::optional<PictureFormat> pictureFormatOf(const std::string& path);

// Steps of color that suit a format, for render::FlatScene: in files of polygons each step is one more outline.
int colorSteps(PictureFormat format);

// Pictures of sheets, flats[i] to paths[i], whose endings tell the formats. They appear when all are written, or none
// does; a failure is an output error.
Status writePlanePictures(std::span<const render::FlatScene> flats, std::span<const std::string> paths);

} // namespace vp::write
