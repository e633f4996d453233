#include "picture/painter.h"

#include "base/frame_scope.h"
#include "classify/gpu_records.h"
#include "cut/polygon_generations.h"
#include "measure/cell_steps.h"
#include "measure/plane_triangles.h"
#include "mesh/part_edges.h"
#include "picture/context_mesh.h"
#include "picture/contour_drawing.h"
#include "picture/sheet_values.h"
#include "probe/presets.h"
#include "ranks/join/hanging_borders.h"
#include "ranks/join/whole_cells.h"
#include "ranks/picture/joined_surfaces.h"
#include "ranks/picture/merged_layers.h"
#include "ranks/picture/surroundings.h"
#include "render/passes/surface_polygons.h"
#include "render/scene/value_style.h"

#include <algorithm>
#include <utility>

namespace vp::picture
{

namespace
{

// Neutral: it takes no part in the colors of the values.
constexpr render::Color kContextColor{194, 199, 206};

// The corners of its window, where it is drawn.
void addRim(const probe::Sheet& sheet, const Box& bounds, std::vector<Vec3>& extent)
{
	if (!sheet.window || probe::reachesAround(*sheet.window, bounds))
		return;
	const probe::Window& window = *sheet.window;
	for (const double x : {window.x0, window.x1})
		for (const double y : {window.y0, window.y1})
			extent.push_back(sheet.origin + x * sheet.xAxis() + y * sheet.up);
}

} // namespace

Painter::Painter(session::Session& session, SheetLooks looks, render::Renderer renderer)
    : session_(session), drawn_(session.stamp()), looks_(std::move(looks)), vectors_(session),
      renderer_(std::move(renderer)), pool_(classify::RecordPool::create(*session.device()))
{
}

// Computes anew what depends on values and blocks, if the session has others since the last picture.
Status Painter::followSession()
{
	const session::Session::Stamp before = std::exchange(drawn_, session_.stamp());
	const bool has_other_grid = before.grid != drawn_.grid;
	if (has_other_grid || before.values != drawn_.values)
	{
		looks_.forgetScales();
		vectors_.forget();
		records_.clear();
	}
	return has_other_grid ? takeBlocks() : Nothing{};
}

Status Painter::takeBlocks()
{
	Result<ranks::Surroundings> around =
	    ranks::surroundingsOf(session_.ranks(), session_.blocks(), choice().look.outline);
	if (!around)
		return around.error();
	outline_ = std::move(around->outline);
	extent_ = std::move(around->extent);
	if (choice().look.box_axes)
		for (int i = 0; i < 8; ++i)
			extent_.push_back(render::corner(session_.blocks().bounds(), i));
	for (const render::Segment& line : outline_)
		extent_.insert(extent_.end(), {line.a, line.b});
	if (const session::TimesSeen* seen = looks_.timesSeen(); seen && !seen->bounds.empty())
		for (int i = 0; i < 8; ++i)
			extent_.push_back(render::corner(seen->bounds, i));
	return makeContext();
}

Status Painter::makeContext()
{
	context_.clear();
	for (const view::ContextSpec& context : choice().spec.context)
	{
		Result<mesh::SheetMesh> mesh = contextMesh(session_.blocks(), context);
		if (!mesh)
			return mesh.error();
		const ranks::Borders borders = ranks::joinWholeCells(session_.ranks(), session_.blocks(), *mesh);
		if (borders.hangs)
			return ranks::sizesDiffer("context");
		auto polygons = ranks::surfacePolygons(session_.ranks(), *session_.device(), *mesh, borders, {});
		if (!polygons)
			return polygons.error();
		render::Surface& surface = context_.emplace_back();
		surface.polygons = std::move(*polygons);
		surface.opacity = context.opacity;
		surface.color = kContextColor;
		surface.thick = true;
	}
	return Nothing{};
}

Status Painter::setLook(view::ResolvedLook look)
{
	const view::ResolvedLook& before = looks_.choice();
	const bool same_around = look.look.outline == before.look.outline && look.look.box_axes == before.look.box_axes &&
	                         look.spec.context == before.spec.context;
	if (look.look.mesh != before.look.mesh)
		records_.clear(); // which edges are drawn stands in them
	looks_.setChoice(std::move(look));
	if (Status seen = looks_.seeTimesIfAsked(); !seen)
		return seen;
	camera_.reset();
	return same_around ? Status(Nothing{}) : takeBlocks();
}

Status Painter::fitTimes(std::span<const std::size_t> steps)
{
	if (Status seen = looks_.seeTimesIfAsked(); !seen || looks_.timesSeen())
		return seen ? takeBlocks() : seen;
	auto seen = session::lookAtTimes(session_, steps, shownFields(session_));
	if (!seen)
		return seen.error();
	looks_.setTimesSeen(std::make_shared<session::TimesSeen>(std::move(*seen)));
	return takeBlocks();
}

Result<Painter> Painter::create(session::Session& session, view::ResolvedLook look)
{
	Result<render::Renderer> renderer = session.takeRenderer();
	if (!renderer)
		return renderer.error();
	return create(session, std::move(look), std::move(*renderer));
}

Result<Painter> Painter::create(session::Session& session, view::ResolvedLook look, render::Renderer renderer)
{
	Painter painter(session, {session, std::move(look)}, std::move(renderer));
	if (Status seen = painter.looks_.seeTimesIfAsked(); !seen)
		return seen.error();
	if (Status taken = painter.takeBlocks(); !taken)
		return taken.error();
	return painter;
}

// What is no plane: a grid surface, a patch of the boundary, whole cells.
Result<render::Surface> Painter::surfaceOf(const cut::Cut& slice, std::size_t sheet, const session::SheetStats& stats,
                                           const render::SheetDrawing& drawing,
                                           const std::optional<render::ValueScale>& scale) const
{
	const grid::BlockSet& blocks = slice.blocksOf(session_.blocks());
	ShownPolygons shown = shownPolygons(blocks, slice.sheets[sheet], stats, choice().byGeneration());
	auto polygons = ranks::surfacePolygons(
	    session_.ranks(), *session_.device(), shown.mesh, stats.crinkle ? stats.crinkle_borders : stats.borders,
	    std::move(shown.values), choice().look.mesh ? mesh::partEdges(blocks, shown.mesh) : mesh::PartEdges{});
	if (!polygons)
		return polygons.error();
	return render::Surface{.polygons = std::move(*polygons),
	                       .opacity = drawing.opacity,
	                       .mesh = choice().look.mesh,
	                       .values = drawing.values ? drawing.values : scale,
	                       .colors = drawing.colors,
	                       .range = drawing.range || drawing.values ? drawing.range : choice().look.range,
	                       .lines = drawing.lines};
}

// Lines are drawn from the layers of values; labels want to know where they run.
void Painter::addContours(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
                          render::Scene& scene) const
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
		const ShownPolygons shown =
		    shownPolygons(slice.blocksOf(session_.blocks()), slice.sheets[s], sheets[s], choice().byGeneration());
		drawing.contours = render::levelLines(shown.mesh, content, shown.values, levels);
	}
	// Any sheet may hide labels of another.
	if (std::ranges::any_of(scene.sheets, [](const auto& sheet) { return !sheet.contours.empty(); }))
		for (std::size_t s = 0; s < scene.sheets.size(); ++s)
			scene.sheets[s].rim_lines =
			    measure::meshOutlines(sheets[s].mesh, measure::planePoints(sheets[s].mesh, slice.sheets[s].sheet));
}

// A sheet's polygons where they lie: records that the GPU classifier left in device memory, those of the last picture
// where the sheet has not moved, or the CPU's mesh put there.
Result<std::shared_ptr<const classify::SheetRecords>> Painter::recordsOf(const cut::Cut& slice, std::size_t number,
                                                                         const session::SheetStats& stats)
{
	const cut::SheetCut& sheet = slice.sheets[number];
	const bool by_generation = choice().byGeneration();
	const grid::BlockSet& blocks = slice.blocksOf(session_.blocks());
	const bool is_parted = stats.parts && !by_generation;
	const mesh::SheetMesh& shown = is_parted                       ? stats.parts->mesh
	                               : stats.shown && !by_generation ? *stats.shown
	                                                               : stats.mesh;
	// Records of the device have all edges.
	const bool shows_parts = choice().look.mesh && shown.polygons() > 0 && mesh::hasParts(blocks);
	if (sheet.records && !by_generation && !shows_parts && !is_parted && !stats.shown)
		return std::shared_ptr<const classify::SheetRecords>(sheet.records);
	if (const auto known = records_.find(sheet.number); known != records_.end())
		return known->second;
	mesh::PartEdges part_edges = shows_parts ? mesh::partEdges(blocks, shown) : mesh::PartEdges{};
	const mesh::MeshRecords host =
	    by_generation
	        ? mesh::MeshRecords(sheet.sheet, shown, cut::polygonGenerations(sheet, shown), std::move(part_edges))
	    : is_parted ? mesh::MeshRecords(sheet.sheet, shown, stats.parts->values, std::move(part_edges))
	                : mesh::MeshRecords(blocks, sheet.sheet, shown, sheet.field, std::move(part_edges));
	auto made = classify::recordsFromMesh(pool_, host);
	if (!made)
		return made.error();
	// All parts of a sheet are drawn in one way.
	(*made)->overlapping = session_.ranks().any((*made)->overlapping || classify::mayFold(session_.blocks()));
	return records_[sheet.number] = std::move(*made);
}

Status Painter::addSheets(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
                          const session::Contours& contours, render::Scene& scene)
{
	std::erase_if(records_,
	              [&](const auto& kept) {
		              return std::ranges::find(slice.sheets, kept.first, &cut::SheetCut::number) == slice.sheets.end();
	              });
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
	{
		Result<render::SheetDrawing> made = looks_.drawing(slice.sheets[s], sheets[s]);
		if (!made)
			return made.error();
		if (s < contours.size())
			if (Status added = picture::addContours(session_, slice.sheets[s], contours[s], *made, choice(), scene);
			    !added)
				return added;
		if (!slice.sheets[s].isPlane() || sheets[s].crinkle)
		{
			Result<render::Surface> surface = surfaceOf(slice, s, sheets[s], *made, scene.values);
			if (!surface)
				return surface.error();
			scene.surfaces.push_back(std::move(*surface));
			continue;
		}
		auto records = recordsOf(slice, s, sheets[s]);
		if (!records)
			return records.error();
		made->records = std::move(*records);
		made->bounds = ranks::boundsOfAll(session_.ranks(), made->records->bounds);
		scene.sheets.push_back(std::move(*made));
	}
	return Nothing{};
}

Result<render::Scene> Painter::sceneOf(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
                                       const session::Contours& contours)
{
	const TimedSection section(session_.timeline(), "scene");
	if (Status followed = followSession(); !followed)
		return followed.error();
	render::Scene scene;
	scene.look = choice().look;
	scene.outline = outline_;
	scene.surfaces = context_;
	scene.bounds = session_.blocks().bounds();
	scene.fitted = choice().spec.camera.kind != render::CameraChoice::Kind::fixed;
	auto scale = looks_.scaleOf(slice, sheets, std::ranges::any_of(sheets, hasNan));
	if (!scale)
		return scale.error();
	scene.values = *scale;
	if (Status added = addSheets(slice, sheets, contours, scene); !added)
		return added.error();
	auto launched = vectors_.surface(slice, sheets, scene.values, looks_);
	if (!launched)
		return launched.error();
	if (*launched)
		scene.surfaces.push_back(std::move(**launched));
	addContours(slice, sheets, scene);
	const bool has_plane = !slice.sheets.empty() && slice.sheets.front().isPlane();
	const probe::Sheet* first = has_plane ? &slice.sheets.front().shown : nullptr;
	if (!slice.sheets.empty() && choice().captions)
		scene.look.caption = withTime(session_, has_plane ? caption(*first, session_.blocks().bounds())
		                                                  : cut::surfaceName(slice.sheets.front()));
	if (!camera_ || choice().spec.camera.followsSheet())
	{
		if (choice().spec.camera.followsSheet() && !has_plane)
			return Error{ErrorKind::usage,
			             "`camera` sheet: a surface that is no plane has no front; choose another view"};
		// If there are several sheets, the camera does not look along any of them.
		const bool by_sheet = slice.sheets.size() == 1 || choice().spec.camera.followsSheet();
		std::vector<Vec3> extent = extent_;
		if (choice().window_rims)
			for (const cut::SheetCut& sheet : slice.sheets)
				addRim(sheet.shown, session_.blocks().bounds(), extent);
		camera_ =
		    render::makeCamera(choice().spec.camera, by_sheet ? first : nullptr, extent, render::pictureFrame(scene));
	}
	scene.camera = *camera_;
	return scene;
}

Result<render::Picture> Painter::draw(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
                                      const session::Contours& contours, const std::stop_token& stop)
{
	const TimedSection section(session_.timeline(), "render");
	FrameScope::comesTo(FrameScope::Stop::picture, session_.timeline());
	Result<render::Scene> scene = sceneOf(slice, sheets, contours);
	if (!scene)
		return scene.error();
	std::function<bool()> goes_on;
	if (stop.stop_possible())
		goes_on = [&] { return !stop.stop_requested(); };
	return ranks::draw(session_.ranks(), renderer_, *scene, session_.timeline(), goes_on);
}

Status Painter::drawInto(const gpu::Image& image, const cut::Cut& slice, const std::vector<session::SheetStats>& sheets,
                         const session::Contours& contours)
{
	const TimedSection section(session_.timeline(), "render");
	Result<render::Scene> scene = sceneOf(slice, sheets, contours);
	if (!scene)
		return scene.error();
	Result<bool> drawn = renderer_.drawInto(*scene, image, {}, session_.timeline());
	return drawn ? Status(Nothing{}) : drawn.error();
}

Result<render::Picture> Painter::drawEmpty(const cut::Cut& slice, const std::vector<session::SheetStats>& sheets)
{
	const TimedSection section(session_.timeline(), "render");
	Result<render::Scene> scene = sceneOf(slice, sheets);
	if (!scene)
		return scene.error();
	for (render::SheetDrawing& sheet : scene->sheets)
	{
		sheet.records = nullptr;
		sheet.rim = false;
		sheet.contours.clear();
		sheet.rim_lines.clear();
	}
	scene->surfaces = context_;
	return renderer_.draw(*scene, session_.timeline());
}

} // namespace vp::picture
