#include "verify/flat_pictures.h"

#include "picture/compare.h"
#include "picture/plane_pictures.h"
#include "picture/read_png.h"
#include "view/validate.h"
#include "write/own_folder.h"
#include "write/png.h"

#include <filesystem>

namespace vp::app
{

namespace
{

// The background is white unless the state says otherwise, as for `vprobe slice`.
Result<view::ResolvedLook> flatLook(view::ViewSpec spec)
{
	if (spec.look.background == view::LookSpec().background)
		spec.look.background = *render::parseBackground("white");
	return view::resolveLook(spec);
}

} // namespace

Result<std::vector<render::Picture>> drawFlat(const session::Session& session, const view::ViewSpec& spec,
                                              const session::Frame& frame)
{
	if (Status planes = view::requirePlanes(spec.probe); !planes)
		return planes.error();
	if (spec.probe.vectors.on())
		return Error{ErrorKind::usage, "`vectors`: flat pictures show none; compare a picture in space"};
	const Result<view::ResolvedLook> look = flatLook(spec);
	if (!look)
		return look.error();
	std::error_code unknown;
	const std::filesystem::path scratch = std::filesystem::temp_directory_path(unknown);
	const Result<write::OwnFolder> folder = write::OwnFolder::besideFile((scratch / "flat.png").string());
	if (!folder)
		return folder.error();
	const char* name = frame.sheets.size() > 1 ? "flat.{sheet}.png" : "flat.png";
	const Result<std::vector<std::string>> written = picture::writePictures(
	    session, *look, frame.slice, frame.sheets, (std::filesystem::path(folder->path()) / name).string());
	if (!written)
		return written.error();
	std::vector<render::Picture> pictures;
	for (const std::string& file : *written)
	{
		Result<render::Picture> read = picture::readPng(file);
		if (!read)
			return read.error();
		pictures.push_back(std::move(*read));
	}
	return pictures;
}

Status keepPictures(const render::Picture& expected, const render::Picture& drawn, Judgment& found)
{
	const bool one_size = expected.width == drawn.width && expected.height == drawn.height;
	const auto keep = [](const render::Picture& picture, std::string& bytes) -> Status
	{
		Result<std::string> png = write::pngBytes(picture);
		if (!png)
			return png.error();
		bytes = std::move(*png);
		return Nothing{};
	};
	if (Status kept = keep(expected, found.expected_png); !kept)
		return kept;
	if (Status kept = keep(drawn, found.drawn_png); !kept)
		return kept;
	return one_size ? keep(picture::pictureOfDifference(expected, drawn), found.difference_png) : Nothing{};
}

} // namespace vp::app
