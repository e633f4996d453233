#include "surface_options.h"

#include "find/listed.h"
#include "probe/path_file.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace vp::app
{

namespace
{

// An option that is given although it places, bounds or traverses a plane; null where there is none.
const char* planeOption(const ProbeOptions& options)
{
	for (const auto& [given, name] :
	     {std::pair{options.probe != "single", "--probe"}, std::pair{!options.window.empty(), "--window"},
	      std::pair{!options.origin.empty(), "--origin"}, std::pair{options.normal.has_value(), "--normal"},
	      std::pair{!options.up.empty(), "--up"}, std::pair{options.seeds != "auto", "--seeds"},
	      std::pair{!options.visited.empty(), "--visited"}})
		if (given)
			return name;
	return nullptr;
}

bool isStill(const SurfaceChoice& choice)
{
	const auto* range = std::get_if<surface::GridIndexRange>(&choice);
	return !range || range->isOne();
}

// A surface that moves needs a range; a sweep that does not would draw one picture many times.
Error doesNotMove(const std::string& text, const SurfaceChoice& choice)
{
	const auto* range = std::get_if<surface::GridIndexRange>(&choice);
	if (!range)
		return {ErrorKind::usage, fmt::format("--surface {}: does not move; take --path times", text)};
	return {
	    ErrorKind::usage,
	    fmt::format("--surface {0}: does not move; give a range to sweep through, such as {1}=0..{2}, or --path times",
	                text, surface::axisName(range->axis), range->first > 0.0 ? range->first : 1.0)};
}

constexpr std::string_view kPatch = "patch=";

} // namespace

bool namesPatch(const ProbeOptions& options)
{
	return options.surface && options.surface->starts_with(kPatch);
}

bool replacesSheets(const ProbeOptions& options)
{
	const auto isGridIndex = [](const std::string& text)
	{ return text.size() > 1 && text[1] == '=' && text[0] >= 'i' && text[0] <= 'k'; };
	return namesPatch(options) || (options.surface && isGridIndex(*options.surface));
}

bool leavesDeviceIdle(const ProbeOptions& options)
{
	const Result<std::optional<surface::ImplicitSurface>> form = formOf(options);
	return replacesSheets(options) || (form && *form && (*form)->isoValue());
}

Result<std::optional<surface::ImplicitSurface>> formOf(const ProbeOptions& options)
{
	if (!options.surface || replacesSheets(options))
		return std::optional<surface::ImplicitSurface>();
	Result<surface::ImplicitSurface> form = surface::ImplicitSurface::parse(*options.surface);
	if (!form)
		return Error{form.error().kind, fmt::format("--surface {}: {}", *options.surface, form.error().message)};
	return std::optional(*form);
}

Status checkForms(const std::vector<probe::Sheet>& sheets, std::span<const std::optional<grid::FieldChoice>> fields)
{
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		if (!sheets[s].form || !sheets[s].form->isoValue())
			continue;
		const std::optional<grid::FieldChoice>& field = fields[s];
		if (!field || field->association != grid::Association::point)
			return Error{ErrorKind::input, fmt::format("--iso {}: needs values at points{}; choose an array of points "
			                                           "with --array",
			                                           sheets[s].form->isoValue()->value,
			                                           field ? ", and " + field->name + " has them in cells" : "")};
	}
	return Nothing{};
}

Result<std::optional<SurfaceChoice>> surfaceOf(const ProbeOptions& options)
{
	if (!replacesSheets(options))
		return std::optional<SurfaceChoice>();
	if (const char* option = planeOption(options))
		return Error{ErrorKind::usage,
		             fmt::format("{}: belongs to planes, and --surface {} is none; leave one of the two out", option,
		                         *options.surface)};
	if (namesPatch(options))
		return std::optional<SurfaceChoice>(find::PatchName{options.surface->substr(kPatch.size())});
	Result<surface::GridIndexRange> range = surface::parseGridIndex(*options.surface);
	if (!range)
		return Error{range.error().kind, fmt::format("--surface {}: {}", *options.surface, range.error().message)};
	return std::optional<SurfaceChoice>(*range);
}

Status checkSurface(const grid::BlockSet& blocks, const SurfaceChoice& choice, const std::string& text)
{
	const auto* patch = std::get_if<find::PatchName>(&choice);
	const Status fits = patch ? find::checkPatch(blocks, patch->name)
	                          : find::checkGridIndex(blocks, std::get<surface::GridIndexRange>(choice));
	return fits ? fits : Error{fits.error().kind, fmt::format("--surface {}: {}", text, fits.error().message)};
}

find::ListedSurface surfaceAt(const SurfaceChoice& choice, double done)
{
	if (const auto* patch = std::get_if<find::PatchName>(&choice))
		return *patch;
	return std::get<surface::GridIndexRange>(choice).at(done);
}

Status refuseGenerations(const ProbeOptions& options, bool by_generation)
{
	if (!replacesSheets(options) || !by_generation)
		return Nothing{};
	return Error{ErrorKind::usage,
	             fmt::format("--color-by generation: --surface {} is found without a traversal, which "
	                         "has the generations; leave one of the two out",
	                         *options.surface)};
}

Status requireOneSurface(const ProbeOptions& options)
{
	Result<std::optional<SurfaceChoice>> choice = surfaceOf(options);
	if (!choice)
		return choice.error();
	if (*choice && !isStill(**choice))
		return Error{ErrorKind::usage,
		             fmt::format("--surface {}: a range is for sweep; give one index", *options.surface)};
	return Nothing{};
}

Status requirePathOfSurface(const ProbeOptions& options, const PathOptions& path)
{
	Result<std::optional<SurfaceChoice>> choice = surfaceOf(options);
	if (!choice)
		return choice.error();
	if (!*choice)
		return Nothing{};
	if (path.overTimes())
		return requireOneSurface(options);
	if (pathOf(path).kind != probe::PathKind::translate)
		return Error{ErrorKind::usage, fmt::format("--path {}: moves planes; with --surface take translate or times",
		                                           path.path.empty() ? probe::nameOf(pathOf(path).kind) : path.path)};
	if (isStill(**choice))
		return doesNotMove(*options.surface, **choice);
	return Nothing{};
}

} // namespace vp::app
