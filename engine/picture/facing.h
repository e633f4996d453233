#pragma once

#include "grid/block.h"
#include "grid/orientation.h"
#include "probe/sheet.h"

#include <array>
#include <string>

namespace vp::picture
{

/// Returns how the coordinates lie, if all files say the same.
grid::Orientation orientationOf(const grid::BlockSet& blocks);

/// Returns the plane of a sheet as a flat picture shows it: its x axis runs to the right in the picture, its up axis
/// up, and its normal towards the reader. The picture is never mirrored. Its window covers the same part of the plane.
///
/// Planes along the axes look as engineers draw them: from +x (y to the right, z up), from -y (x to the right, z up)
/// and from +z (x to the right, y up); a normal of -x, -y or -z looks from the opposite side. A patient is seen by the
/// radiological convention: axial from the feet, coronal from the front, sagittal from the left. So are oblique planes
/// that are less than 45 degrees off one of these, with the projection of what is up there. A raster has x to the right
/// and y down. Other planes are seen from the side of their normal, with the projection of z, the patient's head or the
/// raster's top up.
///
/// keep_up: the sheet's up axis stays up in the picture. A sheet with a window turns by quarters, so that the window is
/// the frame of the picture.
probe::Sheet facingSheet(const probe::Sheet& sheet, const grid::Orientation& orientation, bool keep_up);

/// Returns the patient's sides at the left, right, lower and upper rim of a picture of such a plane.
std::array<std::string, 4> sidesOf(const probe::Sheet& shown, const grid::Orientation::Patient& patient);

} // namespace vp::picture
