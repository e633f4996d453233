#include "render/flat/flat_drawing.h"

#include "base/cross2.h"
#include "measure/cell_steps.h"
#include "measure/contour_lines.h"
#include "mesh/bridges.h"
#include "render/annotate/label_places.h"
#include "render/flat/cairo_library.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vp::render
{

namespace
{

using measure::Contours;
using measure::PlaneLine;

// Points nearer than this to the line without them are left out; files of vectors are a third as large then.
constexpr double kTolerance = 0.05; // pixels
constexpr std::size_t kMaxLeftOut = 24;

// Between neighbors that each have a color, and their edges smoothed, the ground would shine through.
constexpr double kSeam = 0.6; // pixels

constexpr double kDarkForMesh = 0.2; // as in pictures in space

constexpr std::size_t kEdgesAtOnce = 2000; // cairo's work grows faster than a path
constexpr double kFlatLabelsApart = 26.0;  // em, along a line

std::vector<glm::dvec2> thinned(const std::vector<glm::dvec2>& points)
{
	std::vector<glm::dvec2> kept;
	std::size_t last = 0; // last point that was kept
	const auto straight = [&](std::size_t to)
	{
		const glm::dvec2 chord = points[to] - points[last];
		const double length = glm::length(chord);
		for (std::size_t i = last + 1; i < to; ++i)
		{
			const glm::dvec2 off = points[i] - points[last];
			const double along = glm::dot(off, chord);
			if (std::abs(cross(off, chord)) > kTolerance * length || along < 0.0 || along > length * length)
				return false;
		}
		return true;
	};
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		if (i > 0 && i + 1 < points.size() && i - last < kMaxLeftOut && straight(i + 1))
			continue;
		kept.push_back(points[i]);
		last = i;
	}
	return kept;
}

class FlatSheet
{
public:
	FlatSheet(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen)
	    : flat_(flat), layout_(layout), pen_(pen), points_(measure::planePoints(*flat.mesh, flat.content)),
	      style_(flat.hasValues() ? valueStyle(flat.scene, flat.sheet()) : ValueStyle{})
	{
	}

	void draw()
	{
		if (!flat_.hasValues())
			fillPlain();
		else if (!flat_.values.of_polygons.empty())
			fillCells();
		else
			fillValues();
		if (flat_.scene.look.mesh)
			drawMesh();
		if (!style_.lines.empty())
			drawLines();
	}

private:
	std::vector<glm::dvec2> inPixels(const std::vector<glm::dvec2>& points) const
	{
		std::vector<glm::dvec2> pixels;
		pixels.reserve(points.size());
		for (const glm::dvec2& p : points)
			pixels.push_back(layout_.pixel(p));
		return pixels;
	}

	// Fills areas as measure::Contours gives them. seam: how far to fill beyond their rim, pixels.
	void fill(const std::vector<PlaneLine>& outlines, Color color, double seam)
	{
		if (outlines.empty())
			return;
		for (const PlaneLine& line : outlines)
			pen_.path(thinned(inPixels(line.points)), true);
		pen_.setColor(color);
		cairo().set_fill_rule(pen_.context(), CAIRO_FILL_RULE_WINDING);
		cairo().fill_preserve(pen_.context());
		if (seam > 0.0 && color.a == 255)
			pen_.stroke(color, seam);
		cairo().new_path(pen_.context());
	}

	void fillPlain() { fill(measure::meshOutlines(*flat_.mesh, points_), kPlainSheet, 0.0); }

	// Polygons of one color are one area.
	void fillCells()
	{
		const ColorSteps steps = colorSteps(style_, flat_.color_steps);
		const auto nan = static_cast<std::uint32_t>(steps.colors.size());
		std::vector<std::uint32_t> groups;
		for (const double value : flat_.values.of_polygons)
			groups.push_back(std::isnan(value) ? nan : static_cast<std::uint32_t>(steps.at(value)));
		const auto outlines = measure::groupOutlines(*flat_.mesh, points_, groups, nan + 1);
		for (std::uint32_t i = 0; i <= nan; ++i)
			fill(outlines[i], i == nan ? style_.colors->nan : steps.colors[i], kSeam);
	}

	// Fills polygons that are infinite everywhere, over the color of NaN. Categories have no infinite values.
	void fillInfinite()
	{
		if (!(style_.below || style_.above) || !style_.colors->categories.empty())
			return;
		std::vector<std::uint32_t> groups;
		for (std::size_t p = 0; p < flat_.mesh->polygons(); ++p)
		{
			const Interpolated found = interpolated(flat_.mesh->polygon(p), flat_.values.of_vertices);
			groups.push_back(found == Interpolated::minus_infinity  ? 1u
			                 : found == Interpolated::plus_infinity ? 2u
			                                                        : 0u);
		}
		const auto outlines = measure::groupOutlines(*flat_.mesh, points_, groups, 3);
		fill(outlines[1], style_.belowColor(), kSeam);
		fill(outlines[2], style_.aboveColor(), kSeam);
	}

	// Each area reaches over the next one, which is drawn over it: so no seam is left between them.
	void fillValues()
	{
		const measure::PlaneTriangles triangles =
		    measure::planeTriangles(*flat_.mesh, flat_.content, finiteOnly(flat_.values.of_vertices));
		fill(measure::outlinesOf(triangles.points, triangles.nan_triangles), style_.colors->nan, kSeam);
		fillInfinite();
		const ColorSteps steps = colorSteps(style_, flat_.color_steps);
		const Contours contours(triangles, steps.bounds);
		const std::size_t reach = steps.opaque() ? 2 : 1;
		for (std::size_t i = 0; i < steps.colors.size(); ++i)
			fill(contours.area(i > 0 ? i - 1 : Contours::kNoLevel,
			                   i + reach <= steps.bounds.size() ? i + reach - 1 : Contours::kNoLevel),
			     steps.colors[i], 0.0);
	}

	// Each edge once, with a value that it runs through.
	std::map<std::pair<std::uint32_t, std::uint32_t>, double> meshEdges() const
	{
		const SheetValues& values = flat_.values;
		std::map<std::pair<std::uint32_t, std::uint32_t>, double> edges;
		for (std::size_t p = 0; p < flat_.mesh->polygons(); ++p)
		{
			const auto polygon = flat_.mesh->polygon(p);
			const std::vector<std::uint8_t> is_hidden = mesh::hiddenSidesOf(*flat_.mesh, p);
			for (std::size_t i = 0; i < polygon.size(); ++i)
			{
				if ((!is_hidden.empty() && is_hidden[i]) || flat_.part_edges.isInner(flat_.mesh->polygon_starts[p] + i))
					continue;
				const std::pair<std::uint32_t, std::uint32_t> edge =
				    std::minmax(polygon[i], polygon[(i + 1) % polygon.size()]);
				edges[edge] = !values.of_polygons.empty() ? values.of_polygons[p]
				              : !values.of_vertices.empty()
				                  ? 0.5 * (values.of_vertices[edge.first] + values.of_vertices[edge.second])
				                  : std::nan("");
			}
		}
		return edges;
	}

	// Light on dark colors, dark on others.
	void drawMesh()
	{
		const auto edges = meshEdges();
		const ColorSteps shown =
		    flat_.hasValues() ? colorSteps(style_, flat_.color_steps) : ColorSteps{{}, {kPlainSheet}};
		for (const bool light : {false, true})
		{
			const Color ink = light ? Color{235, 235, 235, 90} : Color{18, 18, 18, 110};
			std::size_t count = 0;
			for (const auto& [ends, value] : edges)
			{
				if (light != (!std::isnan(value) && luminance(shown.colors[shown.at(value)]) < kDarkForMesh))
					continue;
				pen_.path({layout_.pixel(points_[ends.first]), layout_.pixel(points_[ends.second])}, false);
				if (++count % kEdgesAtOnce == 0)
					pen_.stroke(ink, pen_.em() / 22.0);
			}
			pen_.stroke(ink, pen_.em() / 22.0);
		}
	}

	double labelSize() const { return layout_.text.small_em; }

	void drawLines()
	{
		const std::vector<LevelLine> drawn = levelLines(*flat_.mesh, flat_.content, flat_.values, style_.lines);
		const int digits = digitsApart(style_.lines);
		std::vector<LabeledLine> lines;
		for (const LevelLine& line : drawn)
			lines.push_back({inPixels(line.line.points), line.line.closed,
			                 pen_.lettering().width(shortNumber(line.level, digits), labelSize())});
		for (const PlaneLine& rim : measure::meshOutlines(*flat_.mesh, points_))
			lines.push_back({inPixels(rim.points), true, 0.0});
		std::vector<LabelPlace> places;
		if (flat_.scene.look.labels)
			places = placeLabels(lines, labelSize(), kFlatLabelsApart * pen_.em(), layout_.plot);
		const double width = std::max(1.2, pen_.em() / 11.0);
		for (std::size_t i = 0; i < drawn.size(); ++i)
		{
			std::vector<LabelPlace> on_line;
			std::ranges::copy_if(places, std::back_inserter(on_line), [&](const LabelPlace& p) { return p.line == i; });
			if (on_line.empty())
				pen_.path(thinned(lines[i].points), lines[i].closed);
			else
				for (const std::vector<glm::dvec2>& part : withGaps(lines[i], on_line))
					pen_.path(thinned(part), false);
			pen_.stroke(inkOver(colorAt(drawn[i].level)), width);
		}
		for (const LabelPlace& place : places)
		{
			const double level = drawn[place.line].level;
			Color ink = inkOver(colorAt(level));
			ink.a = 255;
			Color halo = colorAt(level);
			halo.a = 170;
			pen_.turnedText(place.center, place.angle, labelSize(), ink, halo, shortNumber(level, digits));
		}
	}

	Color colorAt(double value) const { return style_.colors->at(style_.part(value)); }

	const FlatScene& flat_;
	const FlatLayout& layout_;
	CairoCanvas& pen_;
	std::vector<glm::dvec2> points_;
	ValueStyle style_;
};

} // namespace

void drawFlatSheet(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen)
{
	cairo_t* context = pen.context();
	cairo().save(context);
	cairo().rectangle(context, layout.plot.lo.x, layout.plot.lo.y, layout.plot.size().x, layout.plot.size().y);
	cairo().clip(context);
	FlatSheet(flat, layout, pen).draw();
	cairo().restore(context);
}

} // namespace vp::render
