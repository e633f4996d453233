#include "render/flat/flat_drawing.h"

#include "measure/cell_steps.h"
#include "measure/plane_triangles.h"
#include "render/annotate/box_axes.h"
#include "render/flat/cairo_library.h"

#include <algorithm>
#include <array>

namespace vp::render
{

namespace
{

constexpr Color kSheetOnLight{190, 209, 237};
constexpr Color kSheetOnDark{44, 72, 122};
constexpr Color kSheetRim{92, 127, 190};
constexpr double kDash = 0.3;            // em, dashes of hidden edges
constexpr std::size_t kMaxLines = 20000; // largest number of outline lines; more would be a blot

class SmallView
{
public:
	SmallView(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen)
	    : flat_(flat), pen_(pen), box_(*flat.scene.bounds), em_(pen.em())
	{
		frame_.width = flat.scene.look.width;
		frame_.height = flat.scene.look.height;
		const glm::dvec2 names(1.6 * em_);
		frame_.free_lo = layout.small.lo + names;
		frame_.free_hi = layout.small.hi - names;
		std::vector<Vec3> extent;
		for (int i = 0; i < 8; ++i)
			extent.push_back(corner(box_, i));
		for (const Vec3& p : window())
			extent.push_back(p);
		camera_ = makeCamera(flat.camera, &flat.content, extent, frame_);
	}

	void draw()
	{
		sheet(); // below all lines, so that it looks translucent
		edges(false);
		lines();
		edges(true);
		names();
	}

private:
	glm::dvec2 pixel(const Vec3& p) const { return camera_.project(p, frame_); }
	Vec3 world(const glm::dvec2& uv) const
	{
		return flat_.content.origin + uv.x * flat_.content.xAxis() + uv.y * flat_.content.up;
	}
	Color faded(Color color, std::uint8_t alpha) const { return {color.r, color.g, color.b, alpha}; }

	std::vector<Vec3> window() const
	{
		if (!flat_.content.window)
			return {};
		const probe::Window& w = *flat_.content.window;
		return {world({w.x0, w.y0}), world({w.x1, w.y0}), world({w.x1, w.y1}), world({w.x0, w.y1})};
	}

	// Draws the box's near edges, or those behind.
	void edges(bool near)
	{
		const double dash = kDash * em_;
		cairo().save(pen_.context());
		if (!near)
			cairo().set_dash(pen_.context(), &dash, 1, 0.0);
		for (int axis = 0; axis < 3; ++axis)
			for (int at = 0; at < 8; ++at)
			{
				if (at & 1 << axis || !(box_.hi[axis] > box_.lo[axis]))
					continue;
				const int b = (axis + 1) % 3;
				const int c = (axis + 2) % 3;
				const bool seen = facesEye(box_, camera_.position, b, at & 1 << b) ||
				                  facesEye(box_, camera_.position, c, at & 1 << c);
				if (seen == near)
					pen_.line(pixel(corner(box_, at)), pixel(corner(box_, at | 1 << axis)),
					          faded(pen_.inks().text, near ? 200 : 110), em_ / 16.0);
			}
		cairo().restore(pen_.context());
	}

	// The grid's own, where the box is not all there is to it.
	void lines()
	{
		if (flat_.scene.outline.size() > kMaxLines)
			return;
		for (const Segment& line : flat_.scene.outline)
			pen_.path({pixel(line.a), pixel(line.b)}, false);
		pen_.stroke(faded(pen_.inks().faint, 110), em_ / 18.0);
	}

	// Its rim first and the rest over it: where polygons do not fit together lines within are no part of the rim.
	void sheet()
	{
		const std::vector<glm::dvec2> points = measure::planePoints(*flat_.mesh, flat_.content);
		for (const measure::PlaneLine& line : measure::meshOutlines(*flat_.mesh, points))
		{
			std::vector<glm::dvec2> rim;
			for (const glm::dvec2& uv : line.points)
				if (const glm::dvec2 p = pixel(world(uv)); rim.empty() || glm::length(p - rim.back()) > 0.25)
					rim.push_back(p);
			pen_.path(rim, true);
		}
		pen_.setColor(kSheetRim);
		cairo().set_line_width(pen_.context(), em_ / 6.0);
		cairo().stroke_preserve(pen_.context());
		pen_.setColor(flat_.scene.look.background.dark() ? kSheetOnDark : kSheetOnLight);
		cairo().set_fill_rule(pen_.context(), CAIRO_FILL_RULE_WINDING);
		cairo().fill(pen_.context());
		if (const std::vector<Vec3> corners = window(); !corners.empty())
			pen_.closedLine({pixel(corners[0]), pixel(corners[1]), pixel(corners[2]), pixel(corners[3])}, kSheetRim,
			                em_ / 16.0);
	}

	void names()
	{
		const auto edges = axisEdges(box_, camera_, frame_);
		const Color colors[] = {pen_.inks().x, pen_.inks().y, pen_.inks().z};
		for (int axis = 0; axis < 3; ++axis)
			if (edges[axis])
			{
				const std::string name(1, static_cast<char>('x' + axis));
				const glm::dvec2 middle = 0.5 * (pixel(edges[axis]->from) + pixel(edges[axis]->to));
				const glm::dvec2 half(0.5 * pen_.lettering().width(name, em_), 0.5 * em_);
				pen_.text(middle + 0.8 * em_ * edges[axis]->outward - half, em_, colors[axis], name);
			}
	}

	const FlatScene& flat_;
	CairoCanvas& pen_;
	Box box_;
	double em_;
	Frame frame_;
	Camera camera_;
};

} // namespace

void drawSmallView(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen)
{
	if (layout.small.size().x > 0.0)
		SmallView(flat, layout, pen).draw();
}

} // namespace vp::render
