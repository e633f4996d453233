#include "picture/vector_drawing.h"

#include "ranks/particles/joined_traces.h"
#include "ranks/picture/joined_surfaces.h"
#include "vectors/trace_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::picture
{

namespace
{

// Widths, as shares of the lattice's spacing. Neighbors stay apart.
constexpr double kTuftWidth = 0.08;
constexpr double kLineWidth = 0.06;
constexpr double kRibbonWidth = 0.4;
constexpr double kTubeWidth = 0.2;
// Share of the scene's diagonal. In a dense lattice a line is still about a pixel wide.
constexpr double kMinLine = 0.0007;
// Share of the width. Points of a path that are nearer than this look like one.
constexpr double kMinPiece = 0.25;

double widthOf(const view::LaunchChoice& choice, const Box& bounds)
{
	switch (choice.kind)
	{
	case view::TraceKind::tufts:
		return kTuftWidth * choice.spacing;
	case view::TraceKind::ribbons:
		return kRibbonWidth * choice.spacing;
	case view::TraceKind::tubes:
		return kTubeWidth * choice.spacing;
	default:
		return std::max(kLineWidth * choice.spacing, kMinLine * glm::length(bounds.hi - bounds.lo));
	}
}

// Arrows in the colors of the sheet that they stand on would be lost.
render::ColorMap besides(const render::ColorMap& of_sheets)
{
	return *render::makeColorMap(of_sheets.name.starts_with("turbo") ? "grey" : "turbo");
}

std::vector<double> lengthsOf(const vectors::Traces& traces)
{
	std::vector<double> lengths;
	lengths.reserve(traces.vectors.size());
	for (const Vec3& vector : traces.vectors)
		lengths.push_back(glm::length(vector));
	return lengths;
}

// Returns the part of each vector that moves the particles.
std::vector<Vec3> velocitiesOf(const vectors::Traces& traces, vectors::VectorPart part, const Vec3& normal)
{
	vectors::Motion motion{};
	motion.part = part;
	motion.normal = normal;
	std::vector<Vec3> velocities;
	velocities.reserve(traces.vectors.size());
	for (const Vec3& vector : traces.vectors)
		velocities.push_back(motion.moving(vector));
	return velocities;
}

} // namespace

// An array's name goes before a color's.
Result<VectorDrawing::Coloring> VectorDrawing::coloringOf(const view::VectorLookSpec& look) const
{
	if (look.color.empty())
		return Coloring{session_->view().vector_array};
	auto field = grid::chooseField(session_->blocks(), look.color, {}, "`vector_color`");
	if (field)
		return Coloring{*field};
	if (const auto color = render::parseColor(look.color))
		return Coloring{{}, *color};
	return Error{field.error().kind, fmt::format("{}; or a color: white, black, grey, #RRGGBB", field.error().message)};
}

std::vector<double> VectorDrawing::valuesOf(const Coloring& coloring, const vectors::Traces& traces) const
{
	if (!coloring.field)
		return std::vector<double>(traces.points.size());
	if (coloring.field == session_->view().vector_array)
		return lengthsOf(traces);
	std::vector<double> values = vectors::valuesAt(session_->blocks(), *coloring.field, traces);
	ranks::takeFromOwners(session_->ranks(), session_->blocks(), traces, values);
	return values;
}

std::vector<double> VectorDrawing::turnsOf(const vectors::Traces& traces) const
{
	std::vector<double> rates = vectors::turnRates(session_->blocks(), *session_->view().vector_array, traces);
	ranks::takeFromOwners(session_->ranks(), session_->blocks(), traces, rates);
	return vectors::turnsAlong(rates, traces);
}

void VectorDrawing::addTraces(const vectors::Traces& traces, const Vec3& normal, const Coloring& coloring, double width,
                              vectors::TraceMesh& made) const
{
	const view::LaunchChoice& choice = *session_->view().launch;
	const vectors::Curves curves =
	    vectors::curvesOf(traces, velocitiesOf(traces, choice.part, normal), kMinPiece * width);
	const std::vector<double> values = vectors::alongCurves(curves, valuesOf(coloring, traces));
	switch (choice.kind)
	{
	case view::TraceKind::tufts:
		return vectors::addArrows(curves, values, width, made);
	case view::TraceKind::lines:
		return vectors::addLines(curves, values, width, made);
	case view::TraceKind::tubes:
		return vectors::addTubes(curves, values, width, made);
	case view::TraceKind::ribbons:
		return vectors::addRibbons(curves, values, width, normal, vectors::alongCurves(curves, turnsOf(traces)), made);
	}
}

Status VectorDrawing::make(Kept& kept, const cut::Cut& slice) const
{
	const double width = kept.width.value_or(widthOf(*session_->view().launch, session_->blocks().bounds()));
	vectors::TraceMesh made;
	for (std::size_t s = 0; s < kept.traces.size(); ++s)
		addTraces(*kept.traces[s], slice.sheets[s].sheet.normal, kept.coloring, width, made);
	kept.has_nan = std::ranges::any_of(made.values, [](double value) { return std::isnan(value); });
	render::SurfaceValues values;
	if (kept.coloring.field)
		values.at_vertices = made.values;
	auto polygons = ranks::surfaceOfFirst(session_->ranks(), *session_->device(), made.mesh, values);
	if (!polygons)
		return polygons.error();
	kept.polygons = std::move(*polygons);
	return Nothing{};
}

Result<std::optional<render::Surface>> VectorDrawing::surface(const cut::Cut& slice,
                                                              const std::vector<session::SheetStats>& sheets,
                                                              const std::optional<render::ValueScale>& scale,
                                                              SheetLooks& looks)
{
	if (!session_->view().launch)
		return std::optional<render::Surface>();
	const view::VectorLookSpec& look = looks.choice().spec.vectors;
	Result<Coloring> coloring = coloringOf(look);
	if (!coloring)
		return coloring.error();
	Kept wanted{{}, *coloring, look.width};
	for (const session::SheetStats& sheet : sheets)
		wanted.traces.push_back(sheet.traces);
	if (!kept_ || kept_->traces != wanted.traces || !(kept_->coloring == wanted.coloring) ||
	    kept_->width != wanted.width)
	{
		if (Status made = make(wanted, slice); !made)
			return made.error();
		kept_ = std::move(wanted);
	}
	render::Surface surface{.polygons = kept_->polygons, .opacity = look.opacity, .color = kept_->coloring.color};
	surface.lines = 0;
	surface.name = "vectors";
	if (!kept_->coloring.field)
		return std::optional(surface);
	const bool as_sheets = kept_->coloring.field == session_->view().field && !looks.choice().byGeneration();
	Result<std::optional<render::ValueScale>> own =
	    as_sheets ? scale : looks.scaleOf(*kept_->coloring.field, kept_->has_nan);
	if (!own)
		return own.error();
	surface.values = *own;
	surface.colors = looks.choice().vector_colors;
	if (as_sheets)
		surface.range = looks.choice().look.range;
	else if (!surface.colors)
		surface.colors = besides(looks.choice().look.colors);
	return std::optional(surface);
}

} // namespace vp::picture
