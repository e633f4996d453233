#include "view/resolve.h"

#include "probe/presets.h"
#include "vectors/vector_array.h"
#include "view/settings.h"
#include "view/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::view
{

namespace
{

probe::Frame frameOf(const ProbeSpec& spec, const Box& bounds)
{
	const surface::ImplicitSurface* form = implicitSurface(spec.surface);
	// By default, an expression is in the grid's own coordinates.
	const Vec3 origin = form && !form->isAboutOrigin() ? Vec3(0.0) : bounds.center();
	// The settings override the place in a probe file.
	probe::Frame frame = spec.own && spec.own->placed ? spec.own->probe.frame : probe::Frame{origin};
	if (spec.origin)
		frame.origin = *spec.origin;
	if (spec.normal || spec.up)
		frame =
		    probe::makeFrame(frame.origin, spec.normal.value_or(frame.normal), spec.up.value_or(Vec3(0.0, 1.0, 0.0)));
	return frame;
}

probe::Probe makePlanes(const ProbeSpec& spec, const Box& bounds)
{
	const probe::Frame frame = frameOf(spec, bounds);
	switch (spec.shape)
	{
	case ProbeShape::own:
	{
		probe::Probe probe = spec.own->probe;
		probe.frame = frame;
		return probe;
	}
	case ProbeShape::trihedral:
		return probe::trihedral(frame, spec.window);
	case ProbeShape::paddlewheel:
		return probe::paddlewheel(frame, bounds, spec.vanes.value_or(3), spec.window);
	case ProbeShape::stack:
		return probe::stack(
		    frame, spec.offsets.empty() ? probe::evenOffsets(frame, bounds, spec.sheets.value_or(5)) : spec.offsets,
		    spec.window);
	case ProbeShape::single:
		break;
	}
	return probe::single(frame, spec.window);
}

// Chooses the arrays of sheets that ask for one of their own.
Status chooseSheetFields(const ProbeSpec& spec, const grid::BlockSet& blocks, ResolvedView& view)
{
	for (const probe::Sheet& sheet : view.probe.sheets)
	{
		const probe::SheetWishes& wishes = sheet.wishes;
		if (!wishes.array && !wishes.component)
		{
			view.sheet_fields.push_back(view.field);
			continue;
		}
		Result<std::optional<grid::FieldChoice>> field = grid::chooseField(
		    blocks, wishes.array.value_or(spec.array), wishes.component ? wishes.component : spec.component);
		if (!field)
			return field.error();
		view.sheet_fields.push_back(*field);
	}
	return Nothing{};
}

// Whether the blocks have the grid surface or patch.
Status checkListed(const grid::BlockSet& blocks, const SurfaceSpec& surface)
{
	const auto* patch = std::get_if<find::PatchName>(&surface);
	const Status fits = patch ? find::checkPatch(blocks, patch->name)
	                          : find::checkGridIndex(blocks, std::get<surface::GridIndexRange>(surface));
	if (fits)
		return fits;
	return Error{fits.error().kind, fmt::format("`surface` {}: {}", surfaceText(surface), fits.error().message)};
}

// Whether the sheets show what their iso values look at.
Status checkIsoValues(const ResolvedView& view)
{
	for (std::size_t s = 0; s < view.probe.sheets.size(); ++s)
	{
		const auto& form = view.probe.sheets[s].form;
		const std::optional<grid::FieldChoice>& field = view.sheet_fields[s];
		if (!form || !form->isoValue() || (field && field->association == grid::Association::point))
			continue;
		return Error{ErrorKind::input,
		             fmt::format("`iso` {}: needs values at points{}; choose an array of points with `array`",
		                         form->isoValue()->value, field ? ", and " + field->name + " has them in cells" : "")};
	}
	return Nothing{};
}

// The longest side of what sheets show: of their windows, which may reach around everything, or of the bounds. It does
// not follow the cut, so that steps and widths stay what they are while a probe moves.
double longestSide(const probe::Probe& probe, const Box& bounds)
{
	const Vec3 size = bounds.empty() ? Vec3(0.0) : bounds.hi - bounds.lo;
	const double whole = std::max({size.x, size.y, size.z});
	double windows = 0.0;
	for (const probe::Sheet& sheet : probe.sheets)
	{
		if (!sheet.window)
			return whole;
		windows = std::max({windows, sheet.window->width(), sheet.window->height()});
	}
	return std::min(whole, windows);
}

Status chooseVectors(const VectorSpec& spec, const grid::BlockSet& blocks, ResolvedView& view)
{
	if (!spec.on() && spec.array.empty())
		return Nothing{};
	Result<grid::FieldChoice> array = vectors::chooseVectors(blocks, spec.array);
	if (!array)
		return array.error();
	view.vector_array = *array;
	if (!spec.on())
		return Nothing{};
	const double spacing = longestSide(view.probe, blocks.bounds()) / spec.lattice;
	view.launch = LaunchChoice{.array = *array,
	                           .kind = *spec.kind,
	                           .lattice = {spec.lattice, spec.jitter},
	                           .steps = spec.stepsOrDefault(),
	                           .dt = spec.dt,
	                           .spacing = spacing > 0.0 ? spacing : 1.0,
	                           .direction = spec.direction,
	                           .part = spec.part,
	                           .path_lines = spec.path_lines};
	return Nothing{};
}

} // namespace

probe::Probe makeProbe(const ProbeSpec& spec, const Box& bounds)
{
	probe::Probe probe = makePlanes(spec, bounds);
	if (const surface::ImplicitSurface* form = implicitSurface(spec.surface))
		for (probe::Sheet& sheet : probe.sheets)
			sheet.form = *form;
	return probe;
}

namespace
{

// Curved cells are refined where sheets cut them, and nowhere else.
Status refuseCurved(const ViewSpec& spec, const grid::BlockSet& blocks)
{
	if (std::ranges::none_of(blocks.blocks, [](const grid::Block& block) { return block.curved != nullptr; }))
		return Nothing{};
	const surface::ImplicitSurface* form = implicitSurface(spec.probe.surface);
	for (const auto& [given, key] :
	     {std::pair{!std::holds_alternative<std::monostate>(spec.probe.surface) && (!form || form->isoValue()),
	                "surface"},
	      std::pair{spec.probe.crinkle, "crinkle"}, std::pair{spec.probe.threshold.has_value(), "threshold"},
	      std::pair{spec.probe.vectors.on(), "vectors"}, std::pair{spec.look.contour.isGiven(), "contour"},
	      std::pair{!spec.look.context.empty(), "context"},
	      std::pair{spec.look.outline == render::Outline::edges, "outline"},
	      std::pair{spec.look.color_by == ColorBy::generation, "color_by"}})
		if (given)
			return Error{
			    ErrorKind::usage,
			    fmt::format("`{}`: not for curved cells, which a tolerance keeps; leave it out, or read the file "
			                "with `refine` 1",
			                key)};
	return Nothing{};
}

} // namespace

Result<ResolvedView> resolve(const ViewSpec& spec, const grid::BlockSet& blocks)
{
	if (Status fits = refuseCurved(spec, blocks); !fits)
		return fits.error();
	const ProbeSpec& probe = spec.probe;
	ResolvedView view;
	view.time = spec.input.time;
	view.seeds.mode = probe.seeds;
	view.seeds.outside = probe.outside;
	view.corners = probe.corners.value_or(mesh::Corners::keep);
	view.hanging = probe.hanging;
	view.crinkle = probe.crinkle;
	view.threshold = probe.threshold;
	Result<std::optional<grid::FieldChoice>> field = grid::chooseField(blocks, probe.array, probe.component);
	if (!field)
		return field.error();
	view.field = *field;
	if (replacesSheets(probe.surface))
	{
		if (Status fits = checkListed(blocks, probe.surface); !fits)
			return fits.error();
		view.surface = probe.surface;
	}
	if (view.threshold && !view.field)
		return Error{ErrorKind::input, fmt::format("{}: has no array for `threshold` to look at; leave the setting out",
		                                           spec.input.files.empty() ? "the input" : spec.input.files.front())};
	view.probe = makeProbe(probe, blocks.bounds());
	std::erase_if(view.probe.sheets, [](const probe::Sheet& sheet) { return sheet.wishes.hidden; });
	if (Status chosen = chooseSheetFields(probe, blocks, view); !chosen)
		return chosen.error();
	if (Status fits = checkIsoValues(view); !fits)
		return fits.error();
	if (Status chosen = chooseVectors(probe.vectors, blocks, view); !chosen)
		return chosen.error();
	return view;
}

void takePlace(ProbeSpec& spec, const ProbeSpec& from)
{
	spec.origin = from.origin;
	spec.normal = from.normal;
	spec.up = from.up;
	spec.window = from.window;
	spec.shape = from.shape;
	spec.own = from.own;
	spec.vanes = from.vanes;
	spec.offsets = from.offsets;
	spec.sheets = from.sheets;
}

std::optional<find::ListedSurface> listedSurface(const SurfaceSpec& surface, double done)
{
	if (const auto* patch = std::get_if<find::PatchName>(&surface))
		return *patch;
	if (const auto* range = std::get_if<surface::GridIndexRange>(&surface))
		return range->at(done);
	return std::nullopt;
}

probe::Path pathOf(const SweepSpec& sweep)
{
	probe::Path path;
	if (sweep.own)
		path = *sweep.own;
	else if (!sweep.over_times)
		path.kind = sweep.kind;
	path.there_and_back = path.there_and_back || sweep.there_and_back;
	return path;
}

double framesPerSecond(const SweepSpec& sweep)
{
	constexpr double kSmooth = 25.0;
	constexpr double kTimes = 2.0; // so that each can be looked at
	return sweep.frames_per_second.value_or(sweep.over_times ? kTimes : kSmooth);
}

double filmSpeed(const SweepSpec& sweep, int frames)
{
	return sweep.seconds ? frames / *sweep.seconds : framesPerSecond(sweep);
}

Result<int> frameCount(const SweepSpec& sweep)
{
	if (sweep.over_times)
		return 0;
	const std::optional<int> frames =
	    sweep.frames ? sweep.frames : probe::framesOf(pathOf(sweep), framesPerSecond(sweep));
	if (frames)
		return *frames;
	return Error{ErrorKind::usage,
	             fmt::format("`frames`: the path {} does not say how many frames there are; give their number",
	                         pathKindText(sweep))};
}

} // namespace vp::view
