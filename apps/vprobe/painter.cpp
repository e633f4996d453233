#include "painter.h"

#include "slice/gpu_records.h"
#include "slice/host_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::app
{

namespace
{

std::string defaultTitle(const std::vector<std::string>& inputs)
{
	const std::string& first = inputs.front();
	const std::string name = first.starts_with("demo:") ? first : std::filesystem::path(first).filename().string();
	return inputs.size() == 1 ? name : fmt::format("{} and {} more", name, inputs.size() - 1);
}

std::string caption(const probe::Sheet& sheet)
{
	return fmt::format("origin {:.4g}, {:.4g}, {:.4g}   normal {:.3f}, {:.3f}, {:.3f}", sheet.origin.x, sheet.origin.y,
	                   sheet.origin.z, sheet.normal.x, sheet.normal.y, sheet.normal.z);
}

bool hasNan(const SheetStats& sheet)
{
	return sheet.measure.nan_area > 0.0;
}

render::ValueScale scaleOf(const grid::BlockSet& blocks, const slice::FieldChoice& field, bool has_nan)
{
	const auto [lo, hi] = slice::fieldRange(blocks, field);
	return {field.title(blocks), lo, hi, has_nan};
}

// A sheet's polygons where they lie: records that the GPU classifier left in device memory, or the CPU's mesh put
// there.
Result<std::shared_ptr<const slice::SheetRecords>> recordsOf(const Session& session, const slice::SheetSlice& sheet,
                                                             const SheetStats& stats)
{
	if (sheet.records)
		return std::shared_ptr<const slice::SheetRecords>(sheet.records);
	const auto host = slice::recordsFromMesh(session.blocks, sheet.sheet, stats.mesh, sheet.field);
	auto made = slice::recordsFromHost(slice::RecordPool::create(*session.device), host);
	if (!made)
		return made.error();
	return std::shared_ptr<const slice::SheetRecords>(std::move(*made));
}

} // namespace

Result<PictureStyle> pictureStyle(const LookOptions& options)
{
	Result<render::Look> look = makeLook(options);
	if (!look)
		return look.error();
	Result<render::CameraChoice> camera = render::parseCamera(options.camera);
	if (!camera)
		return camera.error();
	return PictureStyle{std::move(*look), *camera, options.title, options.opacity, true, true};
}

Painter::Painter(Session& session, PictureStyle style, render::Renderer renderer)
    : session_(session), style_(std::move(style)), renderer_(std::move(renderer)),
      outline_(render::outlineOf(session.blocks, style_.look.outline)), extent_(render::extentOf(session.blocks))
{
	for (const render::Segment& line : outline_)
		extent_.insert(extent_.end(), {line.a, line.b});
}

Result<Painter> Painter::create(Session& session, const ProbeOptions& options, PictureStyle style)
{
	// The paddlewheel's own window reaches around everything.
	style.window_rims = !options.window.empty() || options.probe != "paddlewheel";
	style.look.title = style.title.value_or(defaultTitle(options.inputs));
	Result<render::Renderer> renderer = render::Renderer::create(*session.device);
	if (!renderer)
		return renderer.error();
	return Painter(session, std::move(style), std::move(*renderer));
}

Result<render::SheetDrawing> Painter::drawing(const slice::SheetSlice& sheet, const SheetStats& stats) const
{
	Result<std::shared_ptr<const slice::SheetRecords>> records = recordsOf(session_, sheet, stats);
	if (!records)
		return records.error();
	const probe::SheetWishes& wishes = sheet.shown.wishes;
	render::SheetDrawing drawing{sheet.shown, std::move(*records), wishes.opacity.value_or(style_.opacity)};
	drawing.magnification = sheet.shown.fx.magnification;
	if (const std::optional<probe::Window>& window = sheet.sheet.window)
		drawing.window = render::WindowRect{window->x0, window->x1, window->y0, window->y1};
	drawing.rim = style_.window_rims;
	if (sheet.field && sheet.field != session_.field)
		drawing.values = scaleOf(session_.blocks, *sheet.field, hasNan(stats));
	if (wishes.colormap)
	{
		Result<render::ColorMap> colors = render::makeColorMap(*wishes.colormap);
		if (!colors)
			return colors.error();
		drawing.colors = std::move(*colors);
	}
	drawing.range = wishes.range;
	drawing.lines = wishes.lines;
	return drawing;
}

Result<render::Picture> Painter::draw(const slice::Slice& slice, const std::vector<SheetStats>& sheets)
{
	const TimedSection section(session_.timeline.get(), "render");
	render::Scene scene;
	scene.look = style_.look;
	scene.outline = outline_;
	if (session_.field)
		scene.values = scaleOf(session_.blocks, *session_.field, std::ranges::any_of(sheets, hasNan));
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
	{
		Result<render::SheetDrawing> made = drawing(slice.sheets[s], sheets[s]);
		if (!made)
			return made.error();
		scene.sheets.push_back(std::move(*made));
	}
	const probe::Sheet* first = slice.sheets.empty() ? nullptr : &slice.sheets.front().shown;
	if (first && style_.captions)
		scene.look.caption = caption(*first);
	if (!camera_ || style_.camera.followsSheet())
	{
		// Of several sheets none is the one to look at.
		const bool any = slice.sheets.size() == 1 || style_.camera.followsSheet();
		camera_ = render::makeCamera(style_.camera, any ? first : nullptr, extent_,
		                             render::pictureFrame(scene.look, scene.values));
	}
	scene.camera = *camera_;
	return renderer_.draw(scene, session_.timeline.get());
}

} // namespace vp::app
