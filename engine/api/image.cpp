#include "api/border.h"
#include "picture/compare.h"
#include "picture/read_png.h"
#include "write/png.h"

#include <vprobe/image.h>

namespace vprobe
{

namespace
{

Result<vp::render::Picture> pictureOf(const Image& image, const std::string& name)
{
	if (image.rgba.size() != std::size_t(4) * image.width * image.height || image.rgba.empty())
		return Error{ErrorKind::usage, name + ": the picture is empty; draw one first"};
	return vp::render::Picture{image.width, image.height, image.rgba};
}

} // namespace

Status Image::save(const std::string& file) const
{
	return guarded(
	    [&]() -> Status
	    {
		    const Result<vp::render::Picture> picture = pictureOf(*this, file);
		    return picture ? publicStatus(vp::write::writePng(*picture, file)) : picture.error();
	    });
}

Result<std::string> Image::png() const
{
	return guarded(
	    [&]() -> Result<std::string>
	    {
		    const Result<vp::render::Picture> picture = pictureOf(*this, "png");
		    if (!picture)
			    return picture.error();
		    vp::Result<std::string> bytes = vp::write::pngBytes(*picture);
		    return bytes ? Result<std::string>(std::move(*bytes)) : publicError(bytes.error());
	    });
}

Result<ImageDifference> Image::differenceFrom(const std::string& expected_file) const
{
	return guarded(
	    [&]() -> Result<ImageDifference>
	    {
		    const Result<vp::render::Picture> picture = pictureOf(*this, expected_file);
		    if (!picture)
			    return picture.error();
		    const auto expected = vp::picture::readPng(expected_file);
		    if (!expected)
			    return publicError(expected.error());
		    const auto difference = vp::picture::comparePictures(*expected, *picture);
		    if (!difference)
			    return publicError(difference.error());
		    return ImageDifference{difference->similarity, difference->mean, difference->text()};
	    });
}

Status Image::saveDifferenceFrom(const std::string& expected_file, const std::string& file) const
{
	return guarded(
	    [&]() -> Status
	    {
		    const Result<vp::render::Picture> picture = pictureOf(*this, file);
		    if (!picture)
			    return picture.error();
		    const auto expected = vp::picture::readPng(expected_file);
		    if (!expected)
			    return publicError(expected.error());
		    if (expected->width != picture->width || expected->height != picture->height)
			    return Error{ErrorKind::usage, file + ": pictures of two sizes have no picture of their difference"};
		    return publicStatus(vp::write::writePng(vp::picture::pictureOfDifference(*expected, *picture), file));
	    });
}

} // namespace vprobe
