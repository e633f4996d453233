#include "render/annotate/overlay.h"

#include "render/annotate/box_axes.h"
#include "render/annotate/contour_labels.h"
#include "render/annotate/draw_list_canvas.h"
#include "render/annotate/legend.h"
#include "render/annotate/titles.h"
#include "render/scene/outline.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::render
{

namespace
{

// Where x, y and z point, in the corner; what is nearer to the eye is drawn over what is farther.
void writeDirections(const Scene& scene, const Layout& layout, Canvas& pen)
{
	struct Axis
	{
		glm::dvec2 tip; // from the center, in lengths of the axis
		double depth;
		Color color;
		const std::string* name;
	};
	const Camera& camera = scene.camera;
	const auto& names = scene.look.axis_names;
	const auto axis = [&](const Vec3& direction, Color color, const std::string& name)
	{
		return Axis{{glm::dot(direction, camera.right()), -glm::dot(direction, camera.trueUp())},
		            glm::dot(direction, camera.forward()),
		            color,
		            &name};
	};
	std::array<Axis, 3> axes{axis({1.0, 0.0, 0.0}, pen.inks().x, names[0]),
	                         axis({0.0, 1.0, 0.0}, pen.inks().y, names[1]),
	                         axis({0.0, 0.0, 1.0}, pen.inks().z, names[2])};
	std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.depth > b.depth; });

	const double em = layout.em;
	const glm::dvec2 center = 0.5 * (layout.axes.lo + layout.axes.hi);
	const double length = 1.9 * em;
	for (const Axis& a : axes)
	{
		const double seen = glm::length(a.tip);
		const glm::dvec2 tip = center + length * a.tip;
		if (seen > 0.15)
		{
			const glm::dvec2 along = a.tip / seen;
			const glm::dvec2 across{-along.y, along.x};
			const double head = std::min(0.55 * em, 0.7 * length * seen);
			pen.line(center, tip - head * along, a.color, std::max(1.5, 0.14 * em));
			pen.filled({tip, tip - head * along + 0.42 * head * across, tip - head * along - 0.42 * head * across},
			           a.color);
		}
		else
			pen.dot(center, 0.2 * em, a.color);
		// Beside an axis that points at the eye or away from it, its name goes where the others rarely are.
		const glm::dvec2 place =
		    seen > 0.15 ? tip + 0.55 * em * a.tip / seen : center + glm::dvec2(-0.6 * em, 0.65 * em);
		pen.text(place - glm::dvec2(0.5 * pen.lettering().width(*a.name, em), 0.55 * em), em, a.color, *a.name);
	}
}

// Returns the area in which the scene may be seen. It is the whole picture if a part of the scene is beside or behind
// the eye.
Area seenArea(const Box& box, const Camera& camera, const Frame& frame)
{
	Area seen{{frame.width, frame.height}, {0.0, 0.0}};
	for (int i = 0; i < 8; ++i)
	{
		const Vec3 at = corner(box, i);
		if (glm::dot(at - camera.position, camera.forward()) < camera.near)
			return {{0.0, 0.0}, {frame.width, frame.height}};
		const glm::dvec2 pixel = camera.project(at, frame);
		seen = {glm::min(seen.lo, pixel), glm::max(seen.hi, pixel)};
	}
	return seen;
}

// Words over the scene would be lost in its colors: they get a ground.
void writePlates(const Scene& scene, const Layout& layout, Canvas& pen)
{
	Color ground = groundOf(scene.look.background);
	ground.a = 205;
	const auto asWide = [&](Area area, const std::string& words, double size)
	{
		area.hi.x = std::min(area.hi.x, area.lo.x + pen.lettering().width(words, size));
		return area;
	};
	std::vector<Area> areas;
	if (!scene.look.title.empty())
		areas.push_back(asWide(layout.title, scene.look.title, layout.title_em));
	if (!scene.look.caption.empty())
		areas.push_back(asWide(layout.caption, scene.look.caption, layout.small_em));
	for (const LegendLayout& legend : layout.legends)
		areas.push_back(legend.column);
	const Area seen = seenArea(*scene.bounds, scene.camera, layout.frame);
	for (const Area& area : areas)
		if (area.overlaps(seen))
			pen.filled(Area{area.lo - 0.5 * layout.em, area.hi + 0.5 * layout.em}, ground);
}

} // namespace

Overlay makeOverlay(const Scene& scene, KeptLettering* kept)
{
	const std::vector<LegendContent> legends = legendContents(scene);
	const Layout layout = makeLayout(scene.look, legends);

	Overlay overlay;
	KeptLettering own;
	overlay.lettering =
	    (kept ? *kept : own)
	        .get({layout.small_em, layout.em, layout.title_em}, writtenTexts(scene.look, legends), *scene.look.font);
	DrawListCanvas pen(*overlay.lettering, inksOn(scene.look.background), layout.em);
	if (!scene.fitted && scene.bounds)
		writePlates(scene, layout, pen);
	writeContourLabels(scene, layout, pen);
	writeTitles(scene.look, layout, pen);
	if (scene.look.axes)
		writeDirections(scene, layout, pen);
	if (scene.look.box_axes && scene.bounds)
		writeBoxAxes(*scene.bounds, scene.camera, layout, scene.look.length_units, pen);
	for (std::size_t i = 0; i < layout.legends.size(); ++i)
		writeLegend(legends[i], layout.legends[i], pen);
	const ImDrawList& list = pen.list();
	overlay.vertices.assign(list.VtxBuffer.begin(), list.VtxBuffer.end());
	// ImGui starts a new base vertex with a new command once 16 bits are used up.
	for (const ImDrawCmd& command : list.CmdBuffer)
		for (unsigned i = 0; i < command.ElemCount; ++i)
			overlay.indices.push_back(command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + i)]);
	return overlay;
}

} // namespace vp::render
