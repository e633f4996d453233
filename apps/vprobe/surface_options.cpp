#include "surface_options.h"

#include "probe/path_file.h"

#include <fmt/format.h>

#include <utility>

namespace vp::app
{

namespace
{

// An option that is given although it places or bounds a plane; null where there is none.
const char* planeOption(const ProbeOptions& options)
{
	for (const auto& [given, name] :
	     {std::pair{options.probe != "single", "--probe"}, std::pair{!options.window.empty(), "--window"},
	      std::pair{!options.origin.empty(), "--origin"}, std::pair{options.normal.has_value(), "--normal"},
	      std::pair{!options.up.empty(), "--up"}, std::pair{options.seeds != "auto", "--seeds"}})
		if (given)
			return name;
	return nullptr;
}

} // namespace

Result<std::optional<surface::GridIndexRange>> surfaceOf(const ProbeOptions& options)
{
	if (!options.surface)
		return std::optional<surface::GridIndexRange>();
	if (const char* option = planeOption(options))
		return Error{ExitCode::usage,
		             fmt::format("{}: belongs to planes, and --surface {} is none; leave one of the two out", option,
		                         *options.surface)};
	Result<surface::GridIndexRange> range = surface::parseGridIndex(*options.surface);
	if (!range)
		return Error{range.error().code, fmt::format("--surface {}: {}", *options.surface, range.error().message)};
	return std::optional(*range);
}

Status requireOneSurface(const ProbeOptions& options)
{
	Result<std::optional<surface::GridIndexRange>> range = surfaceOf(options);
	if (!range)
		return range.error();
	if (*range && !(*range)->isOne())
		return Error{ExitCode::usage,
		             fmt::format("--surface {}: a range is for sweep; give one index", *options.surface)};
	return Nothing{};
}

Status requirePathOfSurface(const ProbeOptions& options, const PathOptions& path)
{
	Result<std::optional<surface::GridIndexRange>> range = surfaceOf(options);
	if (!range)
		return range.error();
	if (!*range)
		return Nothing{};
	if (path.overTimes())
		return requireOneSurface(options);
	if (pathOf(path).kind != probe::PathKind::translate)
		return Error{ExitCode::usage, fmt::format("--path {}: moves planes; with --surface take translate or times",
		                                          path.path.empty() ? probe::nameOf(pathOf(path).kind) : path.path)};
	if ((*range)->isOne())
		return Error{ExitCode::usage,
		             fmt::format("--surface {0}: does not move; give a range to sweep through, such as "
		                         "{1}=0..{2}, or --path times",
		                         *options.surface, surface::axisName((*range)->axis),
		                         (*range)->first > 0.0 ? (*range)->first : 1.0)};
	return Nothing{};
}

} // namespace vp::app
