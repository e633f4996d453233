#include "make_probe.h"

#include "probe/presets.h"
#include "surface_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string_view>

namespace vp::app
{

namespace
{

constexpr std::array<std::string_view, 4> kPresets = {"single", "trihedral", "paddlewheel", "stack"};

bool isPreset(const std::string& name)
{
	return std::ranges::find(kPresets, name) != kPresets.end();
}

Vec3 vectorOf(const std::vector<double>& numbers)
{
	return {numbers[0], numbers[1], numbers[2]};
}

Result<Vec3> parseNormal(const std::string& text)
{
	for (int axis = 0; axis < 3; ++axis)
		if (text == std::string(1, static_cast<char>('x' + axis)))
		{
			Vec3 normal(0.0);
			normal[axis] = 1.0;
			return normal;
		}
	std::istringstream words(text);
	Vec3 normal;
	std::string rest;
	if (!(words >> normal.x >> normal.y >> normal.z) || words >> rest)
		return Error{ErrorKind::usage, fmt::format("--normal {}: takes x, y, z or three numbers", text)};
	if (normal == Vec3(0.0))
		return Error{ErrorKind::usage,
		             "--normal: a zero vector is no direction; give x, y, z or three numbers that are not all zero"};
	return normal;
}

// An option that the probe asked for has no use for.
Status requireProbe(bool given, const char* option, const ProbeOptions& options, const char* probe)
{
	if (given && options.probe != probe)
		return Error{ErrorKind::usage, fmt::format("{}: goes with --probe {} only", option, probe)};
	return Nothing{};
}

Status checkSizes(const ProbeOptions& options)
{
	for (const double side : options.window)
		if (!(side > 0.0) || !std::isfinite(side))
			return Error{ErrorKind::usage, fmt::format("--window {} {}: a window needs two sides above 0",
			                                           options.window[0], options.window[1])};
	if (!options.window.empty() && options.own_probe)
		return Error{ErrorKind::usage, fmt::format("--window: {} gives the windows; leave the option out",
		                                           options.probe.empty() ? "the state's own probe" : options.probe)};
	if (options.corners && options.window.empty() && !options.own_probe && options.probe != "paddlewheel")
		return Error{ErrorKind::usage, "--corners: without a window there are none; add --window W H"};
	if (options.offsets.size() > probe::kMaxSheets)
		return Error{ErrorKind::usage, fmt::format("--offsets: a probe has at most {} sheets", probe::kMaxSheets)};
	if (!options.offsets.empty() && options.sheets)
		return Error{ErrorKind::usage, "--sheets: --offsets already says how many; give one of them"};
	return Nothing{};
}

} // namespace

Status requireFinite(std::span<const double> numbers, const char* option)
{
	for (const double number : numbers)
		if (!std::isfinite(number))
			return Error{ErrorKind::usage, fmt::format("{}: {} is not a finite number", option, number)};
	return Nothing{};
}

Status readProbeFile(ProbeOptions& options)
{
	if (options.probe.empty())
		return Nothing{};
	options.own_probe.reset();
	if (isPreset(options.probe))
		return Nothing{};
	if (!options.probe.ends_with(".json"))
		return Error{ErrorKind::usage,
		             fmt::format("--probe {}: takes {} or a .json file", options.probe, fmt::join(kPresets, ", "))};
	Result<probe::ProbeFile> file = probe::readProbe(options.probe);
	if (!file)
		return file.error();
	options.own_probe = std::move(*file);
	return Nothing{};
}

Status checkProbeOptions(const ProbeOptions& options)
{
	for (const auto& [numbers, name] : {std::pair{&options.origin, "--origin"}, std::pair{&options.up, "--up"},
	                                    std::pair{&options.offsets, "--offsets"}})
		if (Status finite = requireFinite(*numbers, name); !finite)
			return finite.error();
	if (!options.up.empty() && vectorOf(options.up) == Vec3(0.0))
		return Error{ErrorKind::usage, "--up: a zero vector is no direction; give three numbers that are not all zero"};
	if (options.normal)
		if (Result<Vec3> normal = parseNormal(*options.normal); !normal)
			return normal.error();
	for (const Status& fits :
	     {requireProbe(options.vanes.has_value(), "--vanes", options, "paddlewheel"),
	      requireProbe(!options.offsets.empty(), "--offsets", options, "stack"),
	      requireProbe(options.sheets.has_value(), "--sheets", options, "stack"), checkSizes(options)})
		if (!fits)
			return fits.error();
	return Nothing{};
}

namespace
{

Result<probe::Probe> makePlanes(const ProbeOptions& options, const Box& bounds, const Vec3& origin)
{
	const std::optional<probe::ProbeFile>& file = options.own_probe;
	// What a file says about its place gives way to what the command line says.
	probe::Frame frame = file && file->placed ? file->probe.frame : probe::Frame{origin};
	if (!options.origin.empty())
		frame.origin = vectorOf(options.origin);
	if (options.normal || !options.up.empty())
		frame = probe::makeFrame(frame.origin, options.normal ? *parseNormal(*options.normal) : frame.normal,
		                         options.up.empty() ? Vec3(0.0, 1.0, 0.0) : vectorOf(options.up));
	if (file)
	{
		probe::Probe probe = file->probe;
		probe.frame = frame;
		return probe;
	}
	std::optional<probe::WindowSize> size;
	if (!options.window.empty())
		size = probe::WindowSize{options.window[0], options.window[1]};
	if (options.probe == "trihedral")
		return probe::trihedral(frame, size);
	if (options.probe == "paddlewheel")
		return probe::paddlewheel(frame, bounds, options.vanes.value_or(3), size);
	if (options.probe == "stack")
		return probe::stack(frame,
		                    options.offsets.empty() ? probe::evenOffsets(frame, bounds, options.sheets.value_or(5))
		                                            : options.offsets,
		                    size);
	return probe::single(frame, size);
}

} // namespace

Result<probe::Probe> makeProbe(const ProbeOptions& options, const Box& bounds)
{
	Result<std::optional<surface::ImplicitSurface>> form = formOf(options);
	if (!form)
		return form.error();
	// An expression is in the grid's own coordinates where nothing else is said.
	const Vec3 origin = *form && !(*form)->isAboutOrigin() ? Vec3(0.0) : bounds.center();
	Result<probe::Probe> probe = makePlanes(options, bounds, origin);
	if (probe && *form)
		for (probe::Sheet& sheet : probe->sheets)
			sheet.form = **form;
	return probe;
}

} // namespace vp::app
