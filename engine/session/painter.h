#pragma once

#include "render/renderer.h"
#include "render/scene/outline.h"
#include "session/grown_contours.h"
#include "session/sheet_looks.h"
#include "session/vector_drawing.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace vp::classify
{
class RecordPool; // gpu_records.h
}

namespace vp::session
{

// Draws slices of a session, which outlives it. What does not change from picture to picture is worked out once; the
// camera stands still, unless it is bound to the sheet.
class Painter
{
public:
	static Result<Painter> create(Session& session, view::ResolvedLook look);

	// The arrays hold other values now.
	void forgetScales()
	{
		looks_.forgetScales();
		vectors_.forget();
		records_.clear();
	}
	// The session's blocks are others now.
	Status takeBlocks();
	// From the next picture on. A camera that is chosen and not given is fitted anew.
	Status setLook(view::ResolvedLook look);

	// What is to be drawn, for renderer(). sheets: sheetStats() of the slice. Section "scene".
	Result<render::Scene> sceneOf(const cut::Cut& slice, const std::vector<SheetStats>& sheets,
	                              const Contours& contours = {});
	render::Renderer& renderer() { return renderer_; }

	// The same into an image, as Renderer::drawInto() takes it.
	Status drawInto(const gpu::Image& image, const cut::Cut& slice, const std::vector<SheetStats>& sheets,
	                const Contours& contours);

	// Section "render" on the session's timeline. sheets: sheetStats() of the slice.
	Result<render::Picture> draw(const cut::Cut& slice, const std::vector<SheetStats>& sheets,
	                             const Contours& contours = {});
	// The scene without the sheets and the lines around them.
	Result<render::Picture> drawEmpty(const cut::Cut& slice, const std::vector<SheetStats>& sheets);

private:
	Painter(Session& session, SheetLooks looks, render::Renderer renderer);
	Status makeContext();
	Result<std::shared_ptr<const classify::SheetRecords>> recordsOf(const cut::SheetCut& sheet,
	                                                                const SheetStats& stats);
	Status addSheets(const cut::Cut& slice, const std::vector<SheetStats>& sheets, const Contours& contours,
	                 render::Scene& scene);
	Result<render::Surface> surfaceOf(const cut::SheetCut& sheet, const SheetStats& stats,
	                                  const render::SheetDrawing& drawing,
	                                  const std::optional<render::ValueScale>& scale) const;

	void addContours(const cut::Cut& slice, const std::vector<SheetStats>& sheets, render::Scene& scene) const;

	const view::ResolvedLook& choice() const { return looks_.choice(); }

	Session& session_;
	SheetLooks looks_;
	VectorDrawing vectors_;
	render::Renderer renderer_;
	std::shared_ptr<classify::RecordPool> pool_; // its pages serve picture after picture
	std::vector<render::Segment> outline_;
	std::vector<render::Surface> context_;
	std::vector<Vec3> extent_; // what the picture holds: the blocks and the lines around them
	std::optional<render::Camera> camera_;
	// Polygons of the last picture that were put onto the device for it, by the number of their sheet.
	std::map<std::uint64_t, std::shared_ptr<const classify::SheetRecords>> records_;
};

} // namespace vp::session
