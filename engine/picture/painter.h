#pragma once

#include "picture/sheet_looks.h"
#include "picture/vector_drawing.h"
#include "render/renderer.h"
#include "render/scene/outline.h"
#include "session/grown_contours.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace vp::classify
{
class RecordPool; // gpu_records.h
}

namespace vp::picture
{

// Draws frames of a session. The session outlives it. Whatever does not change between pictures is computed once, and
// again after the session has gone to another time. The camera stands still, unless it is bound to the sheet.
class Painter
{
public:
	static Result<Painter> create(session::Session& session, view::ResolvedLook look);
	// The same with the renderer of another painter on the same device. Pipelines are not compiled again.
	static Result<Painter> create(session::Session& session, view::ResolvedLook look, render::Renderer renderer);
	render::Renderer takeRenderer() && { return std::move(renderer_); }

	// From now on the camera shows the grids, and the colors reach over the values, of several times: those given as
	// indices of BlockSet::times, or all if the look asks for the range of all. To be called before the first picture.
	Status fitTimes(std::span<const std::size_t> steps);
	// Sets the look from the next picture on. A camera that the look does not fix is fitted again.
	Status setLook(view::ResolvedLook look);

	// Returns the scene for renderer(). sheets: those of the frame. Section "scene" on the timeline.
	Result<render::Scene> sceneOf(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
	                              const session::Contours& contours = {});
	render::Renderer& renderer() { return renderer_; }

	// Draws into an image, which must be as Renderer::drawInto() asks for it.
	Status drawInto(const gpu::Image& image, const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
	                const session::Contours& contours);

	// Draws a picture. sheets: those of the frame. Section "render" on the timeline. A stop request ends it with
	// ErrorKind::cancelled. Only the first of several ranks gets a picture, the others an empty one.
	Result<render::Picture> draw(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
	                             const session::Contours& contours = {}, const std::stop_token& stop = {});
	// Draws the scene without the sheets and without the lines around them.
	Result<render::Picture> drawEmpty(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets);

private:
	Painter(session::Session& session, SheetLooks looks, render::Renderer renderer);
	Status followSession();
	Status takeBlocks();
	Status makeContext();
	Result<std::shared_ptr<const classify::SheetRecords>> recordsOf(const cut::Cut& slice, std::size_t sheet,
	                                                                const session::SheetStats& stats);
	Status addSheets(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
	                 const session::Contours& contours, render::Scene& scene);
	Result<render::Surface> surfaceOf(const cut::Cut& slice, std::size_t sheet, const session::SheetStats& stats,
	                                  const render::SheetDrawing& drawing,
	                                  const std::optional<render::ValueScale>& scale) const;

	void addContours(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets, render::Scene& scene) const;

	const view::ResolvedLook& choice() const { return looks_.choice(); }

	session::Session& session_;
	session::Session::Stamp drawn_; // of the session when the last picture was drawn
	SheetLooks looks_;
	VectorDrawing vectors_;
	render::Renderer renderer_;
	std::shared_ptr<classify::RecordPool> pool_; // its pages are reused from picture to picture
	std::vector<render::Segment> outline_;
	std::vector<render::Surface> context_;
	std::vector<Vec3> extent_; // what a fitted camera must show: the blocks and the lines around them
	std::optional<render::Camera> camera_;
	// Polygons that were copied to the device for the last picture, by the number of their sheet.
	std::map<std::uint64_t, std::shared_ptr<const classify::SheetRecords>> records_;
};

} // namespace vp::picture
