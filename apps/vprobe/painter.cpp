#include "painter.h"

#include "render/color_map_file.h"
#include "render/value_style.h"
#include "sheet_values.h"
#include "slice/cell_steps.h"
#include "slice/generations.h"
#include "slice/gpu_records.h"
#include "slice/host_records.h"
#include "slice/plane_triangles.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

// The corners of its window, where it is drawn.
void addRim(const probe::Sheet& sheet, std::vector<Vec3>& extent)
{
	if (!sheet.window)
		return;
	const probe::Window& window = *sheet.window;
	for (const double x : {window.x0, window.x1})
		for (const double y : {window.y0, window.y1})
			extent.push_back(sheet.origin + x * sheet.xAxis() + y * sheet.up);
}

// A sheet's polygons where they lie: records that the GPU classifier left in device memory, or the CPU's mesh put
// there.
Result<std::shared_ptr<const slice::SheetRecords>> recordsOf(const Session& session, const slice::SheetSlice& sheet,
                                                             const SheetStats& stats, bool by_generation)
{
	if (sheet.records && !by_generation)
		return std::shared_ptr<const slice::SheetRecords>(sheet.records);
	const auto host =
	    by_generation ? slice::recordsFromMesh(sheet.sheet, stats.mesh, slice::polygonGenerations(sheet, stats.mesh))
	                  : slice::recordsFromMesh(session.blocks, sheet.sheet, stats.mesh, sheet.field);
	auto made = slice::recordsFromHost(slice::RecordPool::create(*session.device), host);
	if (!made)
		return made.error();
	return std::shared_ptr<const slice::SheetRecords>(std::move(*made));
}

render::ValueScale generationScale(const slice::Slice& slice)
{
	std::size_t generations = 2; // a scale has two ends
	for (const slice::SheetSlice& sheet : slice.sheets)
		for (const traverse::LaneCut& cut : sheet.cuts)
			generations = std::max(generations, cut.generations());
	return {.title = "generation", .hi = static_cast<double>(generations - 1), .per_cell = true, .log_lo = 1.0};
}

} // namespace

std::string caption(const probe::Sheet& sheet)
{
	return fmt::format("origin {:.4g}, {:.4g}, {:.4g}   normal {:.3f}, {:.3f}, {:.3f}", sheet.origin.x, sheet.origin.y,
	                   sheet.origin.z, sheet.normal.x, sheet.normal.y, sheet.normal.z);
}

bool hasNan(const SheetStats& sheet)
{
	return sheet.measure.nan_area > 0.0;
}

Painter::Painter(Session& session, SheetLooks looks, render::Renderer renderer)
    : session_(session), looks_(std::move(looks)), renderer_(std::move(renderer))
{
	takeBlocks();
}

void Painter::takeBlocks()
{
	outline_ = render::outlineOf(session_.blocks, choice().look.outline);
	extent_ = render::extentOf(session_.blocks);
	if (choice().look.box_axes)
		for (int i = 0; i < 8; ++i)
			extent_.push_back(render::corner(session_.blocks.bounds(), i));
	for (const render::Segment& line : outline_)
		extent_.insert(extent_.end(), {line.a, line.b});
}

Result<Painter> Painter::create(Session& session, const ProbeOptions& options, LookChoice choice)
{
	// The paddlewheel's own window reaches around everything.
	choice.window_rims = !options.window.empty() || options.probe != "paddlewheel";
	Result<render::Renderer> renderer = render::Renderer::create(*session.device);
	if (!renderer)
		return renderer.error();
	return Painter(session, {session, options.inputs, std::move(choice)}, std::move(*renderer));
}

SheetLooks::SheetLooks(const Session& session, std::vector<std::string> inputs, LookChoice choice)
    : session_(session), inputs_(std::move(inputs)), choice_(std::move(choice))
{
	// The file's, where all of it agrees.
	std::string& units = choice_.look.length_units;
	const auto& blocks = session_.blocks.blocks;
	if (units.empty() && !blocks.empty() &&
	    std::ranges::all_of(blocks, [&](const auto& b) { return b.length_units == blocks[0].length_units; }))
		units = blocks[0].length_units;
}

// Those of the command line go before the file's.
std::string SheetLooks::unitsOf(const std::optional<slice::FieldChoice>& field) const
{
	if (field == session_.field && !choice_.units.empty())
		return choice_.units;
	if (field && !field->name.ends_with(']'))
		for (const grid::Field* of_block : field->inEach(session_.blocks))
			if (of_block && !of_block->units.empty())
				return of_block->units;
	return {};
}

// Worked out once: an array may be large, and what it lacks is told once.
Result<std::optional<render::ValueScale>> SheetLooks::scaleOf(const std::optional<slice::FieldChoice>& field,
                                                              bool has_nan)
{
	auto known = std::ranges::find(scales_, field, [](const auto& scale) { return scale.first; });
	if (known == scales_.end())
	{
		auto scale = valueScale(session_.blocks, field, inputs_, choice_.look);
		if (!scale)
			return scale;
		if (const std::string units = unitsOf(field); *scale && !units.empty())
			(*scale)->title += fmt::format(" [{}]", units);
		known = scales_.insert(scales_.end(), {field, *scale});
	}
	std::optional<render::ValueScale> scale = known->second;
	if (scale)
		scale->has_nan = has_nan;
	return scale;
}

Result<std::optional<render::ValueScale>> SheetLooks::scaleOf(const slice::Slice& slice, bool has_nan)
{
	if (choice_.by_generation)
		return std::optional(generationScale(slice));
	return scaleOf(session_.field, has_nan);
}

Result<render::SheetDrawing> SheetLooks::drawing(const slice::SheetSlice& sheet, const SheetStats& stats)
{
	const probe::SheetWishes& wishes = sheet.shown.wishes;
	render::SheetDrawing drawing{sheet.shown, nullptr, wishes.opacity.value_or(choice_.opacity)};
	drawing.magnification = sheet.shown.fx.magnification;
	if (const std::optional<probe::Window>& window = sheet.sheet.window)
		drawing.window = render::WindowRect{window->x0, window->x1, window->y0, window->y1};
	drawing.rim = choice_.window_rims;
	if (sheet.field != session_.field && !choice_.by_generation)
	{
		auto scale = scaleOf(sheet.field, hasNan(stats));
		if (!scale)
			return scale.error();
		drawing.values = *scale;
	}
	if (wishes.colormap)
	{
		auto known = colors_.find(*wishes.colormap);
		if (known == colors_.end())
		{
			Result<render::ColorMap> colors = render::chooseColorMap(*wishes.colormap);
			if (!colors)
				return Error{ExitCode::input, fmt::format("a sheet of the probe: {}", colors.error().message)};
			known = colors_.emplace(*wishes.colormap, std::move(*colors)).first;
		}
		drawing.colors = known->second;
	}
	drawing.range = wishes.range;
	drawing.lines = wishes.lines;
	return drawing;
}

// Lines are drawn from the layers of values; labels want to know where they run.
void Painter::addContours(const slice::Slice& slice, const std::vector<SheetStats>& sheets, render::Scene& scene) const
{
	if (!choice().look.labels || !scene.values)
		return;
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
	{
		render::SheetDrawing& drawing = scene.sheets[s];
		const probe::Sheet& content = slice.sheets[s].sheet;
		const std::vector<double> levels = render::valueStyle(scene, drawing).lines;
		if (levels.empty())
			continue;
		const auto values = sheetValues(session_, slice.sheets[s], sheets[s].mesh, choice().by_generation);
		drawing.contours = render::levelLines(sheets[s].mesh, content, values, levels);
	}
	// Any sheet may hide labels of another.
	if (std::ranges::any_of(scene.sheets, [](const auto& sheet) { return !sheet.contours.empty(); }))
		for (std::size_t s = 0; s < scene.sheets.size(); ++s)
			scene.sheets[s].rim_lines =
			    slice::meshOutlines(sheets[s].mesh, slice::planePoints(sheets[s].mesh, slice.sheets[s].sheet));
}

Result<render::Picture> Painter::draw(const slice::Slice& slice, const std::vector<SheetStats>& sheets)
{
	const TimedSection section(session_.timeline.get(), "render");
	render::Scene scene;
	scene.look = choice().look;
	scene.outline = outline_;
	scene.bounds = session_.blocks.bounds();
	scene.fitted = choice().camera.kind != render::CameraChoice::Kind::fixed;
	auto scale = looks_.scaleOf(slice, std::ranges::any_of(sheets, hasNan));
	if (!scale)
		return scale.error();
	scene.values = *scale;
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
	{
		Result<render::SheetDrawing> made = looks_.drawing(slice.sheets[s], sheets[s]);
		if (!made)
			return made.error();
		auto records = recordsOf(session_, slice.sheets[s], sheets[s], choice().by_generation);
		if (!records)
			return records.error();
		made->records = std::move(*records);
		scene.sheets.push_back(std::move(*made));
	}
	addContours(slice, sheets, scene);
	const probe::Sheet* first = slice.sheets.empty() ? nullptr : &slice.sheets.front().shown;
	if (first && choice().captions)
		scene.look.caption = caption(*first);
	if (!camera_ || choice().camera.followsSheet())
	{
		// Of several sheets none is the one to look at.
		const bool by_sheet = slice.sheets.size() == 1 || choice().camera.followsSheet();
		std::vector<Vec3> extent = extent_;
		if (choice().window_rims)
			for (const slice::SheetSlice& sheet : slice.sheets)
				addRim(sheet.shown, extent);
		camera_ = render::makeCamera(choice().camera, by_sheet ? first : nullptr, extent, render::pictureFrame(scene));
	}
	scene.camera = *camera_;
	return renderer_.draw(scene, session_.timeline.get());
}

} // namespace vp::app
