#include "view/validate.h"

#include "probe/path_file.h"
#include "read/formats.h"
#include "render/color/opacity_points.h"
#include "view/resolve.h"
#include "view/settings.h"
#include "view/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::view
{

namespace
{

Error usage(std::string message)
{
	return {ErrorKind::usage, std::move(message)};
}

// The name of a surface's setting, and its value.
std::string surfaceSetting(const SurfaceSpec& surface)
{
	const auto* implicit = implicitSurface(surface);
	if (implicit && implicit->isoValue())
		return fmt::format("`iso` {}", implicit->isoValue()->value);
	return fmt::format("`surface` {}", surfaceText(surface));
}

Status checkNumbers(const ViewSpec& spec)
{
	// The places of the list are read only.
	const std::vector<Section> sections = allSectionsOf(const_cast<ViewSpec&>(spec));
	for (const Section& section : sections)
		for (const Setting& setting : section.settings)
			if (const std::string why = refusal(setting); !why.empty())
				return usage(fmt::format("`{}` {}", setting.key, why));
	return Nothing{};
}

// A raw volume needs its size, and what else is said of one needs a raw volume.
Status checkInput(const InputSpec& input)
{
	if (!input.format.empty() && !read::findFormat(input.format))
		return usage(fmt::format("`format` {}: no such format; use one of {}", input.format, read::formatNames()));
	if (input.refine != std::floor(input.refine) && !(read::isTolerance(input.refine)))
		return usage(
		    fmt::format("`refine` {}: a level is a whole number, and a tolerance lies between 0 and 1; give one "
		                "of them",
		                input.refine));
	if (read::isTolerance(input.refine) && input.refine < read::kMinTolerance)
		return usage(fmt::format("`refine` {}: rounding would be seen; give a tolerance of at least {}", input.refine,
		                         read::kMinTolerance));
	const bool has_size = input.raw.size[0] != 0;
	if (!has_size && (input.raw != read::RawLayout{} || input.format == "raw"))
		return usage("`raw_size`: a raw volume does not say how large it is; add `raw_size` NXxNYxNZ");
	if (has_size && !input.format.empty() && input.format != "raw")
		return usage(fmt::format("`raw_size`: `format` {} is no raw volume; leave one of the two out", input.format));
	return Nothing{};
}

Status checkPlace(const ProbeSpec& probe)
{
	for (const auto& [direction, key] : {std::pair{&probe.normal, "normal"}, std::pair{&probe.up, "up"}})
		if (*direction && (**direction == Vec3(0.0) || !std::isfinite(glm::length(**direction))))
			return usage(fmt::format("`{}`: a zero vector is no direction; give three numbers that are not all zero, "
			                         "and finite",
			                         key));
	if (const auto& window = probe.window)
		for (const double side : {window->width, window->height})
			if (!(side > 0.0) || !std::isfinite(side))
				return usage(
				    fmt::format("`window` {} {}: a window needs two sides above 0", window->width, window->height));
	return Nothing{};
}

// Checks that no setting is given that the probe's shape does not use.
Status checkShape(const ProbeSpec& probe)
{
	for (const auto& [given, key, shape] : {std::tuple{probe.vanes.has_value(), "vanes", ProbeShape::paddlewheel},
	                                        std::tuple{!probe.offsets.empty(), "offsets", ProbeShape::stack},
	                                        std::tuple{probe.sheets.has_value(), "sheets", ProbeShape::stack}})
		if (given && probe.shape != shape)
			return usage(fmt::format("`{}`: goes with `probe` {} only", key, text(shape)));
	const bool own = probe.shape == ProbeShape::own;
	if (own && !probe.own)
		return usage("`probe`: there is none of its own; give one, or take single, trihedral, paddlewheel or stack");
	if (probe.window && own)
		return usage("`window`: a probe of its own gives the windows; leave the setting out");
	if (probe.corners && !probe.window && !own && probe.shape != ProbeShape::paddlewheel)
		return usage("`corners`: without a window there are none; add `window` W H");
	if (probe.offsets.size() > probe::kMaxSheets)
		return usage(fmt::format("`offsets`: a probe has at most {} sheets", probe::kMaxSheets));
	if (!probe.offsets.empty() && probe.sheets)
		return usage("`sheets`: `offsets` already says how many; give one of them");
	return Nothing{};
}

// A setting that is given although it places, bounds or traverses a plane; null where there is none.
const char* planeSetting(const ViewSpec& spec)
{
	const ProbeSpec& probe = spec.probe;
	for (const auto& [given, key] :
	     {std::pair{probe.shape != ProbeShape::single, "probe"}, std::pair{probe.window.has_value(), "window"},
	      std::pair{probe.origin.has_value(), "origin"}, std::pair{probe.normal.has_value(), "normal"},
	      std::pair{probe.up.has_value(), "up"}, std::pair{probe.seeds != seed::SeedMode::automatic, "seeds"},
	      std::pair{spec.machine.visited.has_value(), "visited"}})
		if (given)
			return key;
	return nullptr;
}

Status checkSurface(const ViewSpec& spec)
{
	if (!replacesSheets(spec.probe.surface))
		return Nothing{};
	if (const char* key = planeSetting(spec))
		return usage(fmt::format("`{}`: belongs to planes, and {} is none; leave one of the two out", key,
		                         surfaceSetting(spec.probe.surface)));
	return Nothing{};
}

Status checkVectors(const ProbeSpec& probe)
{
	if (probe.vectors.on() && !std::holds_alternative<std::monostate>(probe.surface))
		return usage(fmt::format("`vectors`: are launched from planes, and {} is none; leave one of the two out",
		                         surfaceSetting(probe.surface)));
	return Nothing{};
}

Status checkContours(const ContourSpec& contours, const ProbeSpec& probe)
{
	if (contours.isGiven() && !std::holds_alternative<std::monostate>(probe.surface))
		return usage(fmt::format("`{}`: grows from planes, and {} is none; leave one of the two out",
		                         contours.values.empty() ? "contour_at" : "contour", surfaceSetting(probe.surface)));
	return Nothing{};
}

Status checkThreshold(const ProbeSpec& probe)
{
	if (probe.threshold && probe.threshold->lo > probe.threshold->hi)
		return usage(fmt::format("`threshold` {} {}: LO is above HI; give the lower value first", probe.threshold->lo,
		                         probe.threshold->hi));
	return Nothing{};
}

Status checkSize(const PictureSize& size)
{
	if (std::min(size.width, size.height) == 0 || std::max(size.width, size.height) > render::kMaxPictureSize)
		return usage(fmt::format("`size` {}x{}: no size; write WIDTHxHEIGHT in pixels, as 1280x720, up to {}",
		                         size.width, size.height, render::kMaxPictureSize));
	return Nothing{};
}

Status checkRange(const LookSpec& look)
{
	if (look.symmetric && look.logarithmic)
		return usage("`symmetric`: there is no logarithm below 0; leave it out, or `log`");
	if (!look.range)
		return Nothing{};
	const auto [lo, hi] = *look.range;
	if (!(lo < hi) || !std::isfinite(hi - lo))
		return usage(fmt::format(
		    "`range` {} {}: the first number must be below the second, and the width in `window_level` above 0", lo,
		    hi));
	if (look.logarithmic && lo <= 0.0)
		return usage(fmt::format("`range` {} {}: `log` needs a range above 0; raise the first number", lo, hi));
	return Nothing{};
}

Status checkOpacityPoints(const LookSpec& look)
{
	const std::string why = render::whyNoOpacityPoints(look.opacity_points);
	return why.empty() ? Status(Nothing{}) : usage(fmt::format("`opacity_points`: {}", why));
}

bool isStill(const SurfaceSpec& surface)
{
	const auto* range = std::get_if<surface::GridIndexRange>(&surface);
	return !range || range->isOne();
}

// A surface that moves needs a range; a sweep that does not would draw one picture many times.
Error doesNotMove(const SurfaceSpec& surface)
{
	const auto* range = std::get_if<surface::GridIndexRange>(&surface);
	if (!range)
		return usage(fmt::format("{}: does not move; take `path` times", surfaceSetting(surface)));
	return usage(fmt::format("{}: does not move; give a range to sweep through, such as {}=0..{}, or `path` times",
	                         surfaceSetting(surface), surface::axisName(range->axis),
	                         range->first > 0.0 ? range->first : 1.0));
}

} // namespace

Status validate(const ViewSpec& spec)
{
	for (const Status& fits :
	     {checkInput(spec.input), checkPlace(spec.probe), checkNumbers(spec), checkShape(spec.probe),
	      checkSurface(spec), checkVectors(spec.probe), checkContours(spec.look.contour, spec.probe),
	      checkThreshold(spec.probe), checkRange(spec.look), checkOpacityPoints(spec.look), checkSize(spec.look.size)})
		if (!fits)
			return fits;
	return Nothing{};
}

Status requireOneSurface(const ProbeSpec& probe)
{
	if (!isStill(probe.surface))
		return usage(fmt::format("{}: a range is for sweep; give one index", surfaceSetting(probe.surface)));
	return Nothing{};
}

Status requirePathOfSurface(const ProbeSpec& probe, const SweepSpec& sweep)
{
	if (!replacesSheets(probe.surface))
		return Nothing{};
	if (sweep.over_times)
		return requireOneSurface(probe);
	if (pathOf(sweep).kind != probe::PathKind::translate)
		return usage(
		    fmt::format("`path` {}: moves planes; with `surface` take translate or times", pathKindText(sweep)));
	return isStill(probe.surface) ? Status(doesNotMove(probe.surface)) : Nothing{};
}

Status refuseGenerations(const ProbeSpec& probe, ColorBy color_by)
{
	if (!replacesSheets(probe.surface) || color_by != ColorBy::generation)
		return Nothing{};
	return usage(fmt::format("`color_by` generation: {} is found without a traversal, which has the generations; leave "
	                         "one of the two out",
	                         surfaceSetting(probe.surface)));
}

Status requireLevel(const InputSpec& input, const char* who)
{
	if (!read::isTolerance(input.refine))
		return Nothing{};
	return usage(
	    fmt::format("`refine` {}: a tolerance is for cuts, and {} looks at linear cells; give a level, such as "
	                "1",
	                input.refine, who));
}

Status requirePlanes(const ProbeSpec& probe)
{
	for (const auto& [given, key] : {std::pair{!std::holds_alternative<std::monostate>(probe.surface), "surface"},
	                                 std::pair{probe.crinkle, "crinkle"}})
		if (given)
			return usage(fmt::format("`{}`: is no plane to draw flat or to lay a line through; draw it in space, or "
			                         "export it as a .vtp",
			                         key));
	return Nothing{};
}

} // namespace vp::view
