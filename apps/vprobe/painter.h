#pragma once

#include "look_options.h"
#include "render/camera.h"
#include "render/outline.h"
#include "render/renderer.h"
#include "stats_json.h"

#include <optional>
#include <vector>

namespace vp::app
{

// How a session's pictures look.
struct PictureStyle
{
	render::Look look;
	render::CameraChoice camera;
	std::optional<std::string> title; // none: the input's name
	double opacity;
	bool captions = true; // where the first sheet is
	bool window_rims = true;
};

// What the LOOK options ask for, or the error of one of them.
Result<PictureStyle> pictureStyle(const LookOptions& options);

// Draws slices of a session, which outlives it. What does not change from picture to picture is worked out once; the
// camera stands still, unless it is bound to the sheet.
class Painter
{
public:
	static Result<Painter> create(Session& session, const ProbeOptions& options, PictureStyle style);

	// Section "render" on the session's timeline. sheets: sheetStats() of the slice.
	Result<render::Picture> draw(const slice::Slice& slice, const std::vector<SheetStats>& sheets);

private:
	Painter(Session& session, PictureStyle style, render::Renderer renderer);

	Result<render::SheetDrawing> drawing(const slice::SheetSlice& sheet, const SheetStats& stats) const;

	Session& session_;
	PictureStyle style_;
	render::Renderer renderer_;
	std::vector<render::Segment> outline_;
	std::vector<Vec3> extent_; // what the picture holds: the blocks and the lines around them
	std::optional<render::Camera> camera_;
};

} // namespace vp::app
