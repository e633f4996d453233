#pragma once

#include "base/result.h"
#include "render/picture.h"

#include <cstdint>
#include <string>

namespace vp::picture
{

// Compares two pictures of one size, tile by tile. The worst tile counts, so that a small fault in a large picture is
// seen. Each tile has two figures, since each is blind to what the other sees:
//
// - The similarity of structure (SSIM) of Wang, Bovik, Sheikh and Simoncelli, "Image Quality Assessment: From Error
//   Visibility to Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004, equation 13, with K1 =
//   0.01 and K2 = 0.03. It hardly sees colors that change a little everywhere. A tile whose pixels differ by less than
//   one whole pixel, all together, counts as similar: the edge of a polygon differs so much between drivers.
// - The mean difference of a channel with its sign. Noise of a driver cancels in it, and a changed color does not. It
//   does not see ink that has moved within the tile.

/// The side of a tile in pixels. Tiles overlap by half, so each square of nine pixels lies within one of them. In
/// smaller tiles, edges that differ by a part of a pixel weigh as much as faults do; in larger ones, faults of a few
/// pixels vanish.
constexpr std::uint32_t kTileSize = 16;

/// How far a picture may be from the expected one. docs/CI.md has the figures that these limits follow from.
struct PictureTolerance
{
	double similarity = 0.95; // at least, in every tile
	double mean = 1.5;        // at most, of 255 levels, in every tile and channel

	bool operator==(const PictureTolerance&) const = default;
};

/// Returns the tolerance for pictures that were drawn with so many samples a pixel. With few samples, drivers differ by
/// whole pixels at the edges of polygons.
PictureTolerance toleranceOf(int samples);

/// A place in a picture, in pixels from the top left corner.
struct TilePlace
{
	std::uint32_t x = 0;
	std::uint32_t y = 0;
};

struct PictureDifference
{
	double similarity = 1.0; // that of the worst tile and channel; 1 for equal pictures
	TilePlace least_similar;
	double mean = 0.0; // the largest mean difference, above 0 if the drawn picture has more
	int channel = 0;   // its channel: red, green, blue, alpha
	TilePlace farthest;

	bool isWithin(const PictureTolerance& tolerance) const;
	/// Returns both figures as text, as in "similarity 0.9312 at 640,120, mean -4.1 of blue at 632,112".
	std::string text() const;
};

/// Colors count as far as they are opaque: the color of a pixel that nobody sees does not matter. Pictures of different
/// sizes are an error of kind `found`, which tells both sizes.
Result<PictureDifference> comparePictures(const render::Picture& expected, const render::Picture& drawn);

/// Returns an opaque picture of where two pictures of one size differ: the expected one in pale gray, and over it the
/// difference of each pixel, eightfold, from yellow to red.
render::Picture pictureOfDifference(const render::Picture& expected, const render::Picture& drawn);

} // namespace vp::picture
