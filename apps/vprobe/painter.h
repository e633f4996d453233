#pragma once

#include "look_options.h"
#include "render/outline.h"
#include "render/renderer.h"
#include "stats_json.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::app
{

// Draws slices of a session, which outlives it. What does not change from picture to picture is worked out once; the
// camera stands still, unless it is bound to the sheet.
class Painter
{
public:
	static Result<Painter> create(Session& session, const ProbeOptions& options, LookChoice choice);

	// The arrays hold other values now.
	void forgetScales() { scales_.clear(); }
	// The session's blocks are others now.
	Status takeBlocks();

	// Section "render" on the session's timeline. sheets: sheetStats() of the slice.
	Result<render::Picture> draw(const slice::Slice& slice, const std::vector<SheetStats>& sheets);

private:
	Painter(Session& session, std::vector<std::string> inputs, LookChoice choice, render::Renderer renderer);
	Status makeContext();

	Result<render::SheetDrawing> drawing(const slice::SheetSlice& sheet, const SheetStats& stats);
	Result<std::optional<render::ValueScale>> scaleOf(const std::optional<slice::FieldChoice>& field, bool has_nan);

	Session& session_;
	std::vector<std::string> inputs_;
	LookChoice choice_;
	render::Renderer renderer_;
	std::vector<render::Segment> outline_;
	std::vector<render::Surface> context_;
	std::vector<Vec3> extent_; // what the picture holds: the blocks and the lines around them
	std::vector<std::pair<std::optional<slice::FieldChoice>, std::optional<render::ValueScale>>> scales_;
	std::map<std::string, render::ColorMap> colors_; // of sheets that wish for one
	std::optional<render::Camera> camera_;
};

} // namespace vp::app
