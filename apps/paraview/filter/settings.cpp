#include "settings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vprobe_paraview
{

namespace
{

using vprobe::Vector3;
using vprobe::View;

std::string textOf(double value)
{
	char text[40];
	std::snprintf(text, sizeof text, "%.17g", value);
	return text;
}

double dot(const Vector3& a, const Vector3& b)
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 unit(const Vector3& v)
{
	const double length = std::sqrt(dot(v, v));
	return {v[0] / length, v[1] / length, v[2] / length};
}

// Where the corners of the bounds lie along a direction, from the origin.
std::array<double, 2> reach(const Settings& settings, const Whole& whole, const Vector3& direction)
{
	std::array<double, 2> reach{INFINITY, -INFINITY};
	for (unsigned corner = 0; corner < 8; ++corner)
	{
		Vector3 to{};
		for (unsigned a = 0; a < 3; ++a)
			to[a] = whole.bounds[2 * a + (corner >> a & 1)] - settings.origin[a];
		reach = {std::min(reach[0], dot(to, direction)), std::max(reach[1], dot(to, direction))};
	}
	return reach;
}

// The distance of the farthest corner of the bounds from the origin, or a little more.
double farthest(const Settings& settings, const Whole& whole)
{
	double sum = 0.0;
	for (const Vector3& axis : {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}, Vector3{0.0, 0.0, 1.0}})
	{
		const std::array<double, 2> ends = reach(settings, whole, axis);
		sum += std::pow(std::max(std::abs(ends[0]), std::abs(ends[1])), 2);
	}
	return 1.001 * std::sqrt(sum);
}

// From where particles start: points of one lattice on all ranks, whatever part of a sheet each has.
struct Launch
{
	double spacing = 0.0;
	int points = 0;                 // along the longer side of the window
	std::array<double, 2> window{}; // of each sheet
};

Launch launchOf(const Settings& settings, const Whole& whole)
{
	constexpr int kMaxPoints = 1000;
	const int wanted = std::clamp(settings.vector_lattice, 1, kMaxPoints);
	if (settings.has_window)
		return {std::max(settings.window[0], settings.window[1]) / wanted, wanted, settings.window};
	double longest = 0.0;
	for (unsigned a = 0; a < 3; ++a)
		longest = std::max(longest, whole.bounds[2 * a + 1] - whole.bounds[2 * a]);
	// The window is as large as nothing reaches out of it, and a whole number of spacings.
	const double spacing = longest / wanted, side = 2.0 * farthest(settings, whole);
	const int points = static_cast<int>(std::min(std::ceil(side / spacing), double(kMaxPoints)));
	return {spacing, points, {spacing * points, spacing * points}};
}

void placeProbe(const Settings& settings, const Whole& whole, View& view)
{
	view.shape(settings.probe == Probe::file ? vprobe::ProbeShape::single
	                                         : static_cast<vprobe::ProbeShape>(settings.probe));
	const bool is_fixed = settings.surface == Surface::expression && !settings.expression_moves;
	if (!is_fixed || settings.probe != Probe::single)
		view.origin(settings.origin).normal(settings.normal).up(settings.up);
	if (settings.has_window)
		view.window(settings.window[0], settings.window[1]);
	else if (settings.launches() && settings.probe != Probe::file)
	{
		const Launch launch = launchOf(settings, whole);
		view.window(launch.window[0], launch.window[1]);
	}
	else if (settings.probe == Probe::paddlewheel) // vanes that reach as far as the bounds of all ranks
		view.window(farthest(settings, whole), 2.0 * farthest(settings, whole));
	if (settings.probe == Probe::paddlewheel)
		view.vanes(settings.vanes);
	if (settings.probe != Probe::stack)
		return;
	std::vector<double> offsets = settings.offsets;
	const std::array<double, 2> ends = reach(settings, whole, unit(settings.normal));
	for (int sheet = 0; settings.offsets.empty() && sheet < settings.sheets; ++sheet)
		offsets.push_back(ends[0] + (ends[1] - ends[0]) * (sheet + 0.5) / settings.sheets);
	view.offsets(offsets);
}

vprobe::Status readProbe(const Settings& settings, View& view)
{
	if (settings.probe_text.empty())
		return vprobe::Error{vprobe::ErrorKind::input,
		                     "Probe File \"" + settings.probe_file + "\" cannot be read on the server; choose another"};
	vprobe::Status read = view.read(R"({"version": 1, "probe": {"probe": )" + settings.probe_text + "}}");
	if (read)
		return read;
	std::string message = read.error().message;
	// The library names what it reads as a state.
	if (const std::string_view state = "state.json: "; message.starts_with(state))
		message.erase(0, state.size());
	return vprobe::Error{read.error().kind, settings.probe_file + ": " + message};
}

vprobe::Status setSurface(const Settings& settings, View& view)
{
	switch (settings.surface)
	{
	case Surface::plane:
		return vprobe::Nothing{};
	case Surface::sphere:
		return view.set("surface", "sphere:" + textOf(settings.radius));
	case Surface::cylinder:
		return view.set("surface", "cylinder:" + textOf(settings.radius));
	case Surface::cone:
		return view.set("surface", "cone:" + textOf(settings.angle));
	case Surface::expression:
		return view.set("surface", settings.expression);
	case Surface::iso:
		break;
	}
	return view.set("surface", "iso:" + textOf(settings.iso_value));
}

vprobe::Status setVectors(const Settings& settings, const Whole& whole, View& view)
{
	if (!settings.launches())
		return vprobe::Nothing{};
	const bool are_tufts = settings.vectors == Vectors::tufts;
	const Launch launch = launchOf(settings, whole);
	double dt = settings.vector_dt;
	if (dt <= 0.0 && whole.fastest > 0.0)
		dt = launch.spacing / whole.fastest;
	constexpr std::array<const char*, 3> kDirections{"forward", "backward", "both"};
	const auto direction = static_cast<std::size_t>(std::clamp(settings.vector_direction, 0, 2));
	std::vector<std::pair<const char*, std::string>> set{
	    {"vectors", are_tufts ? "tufts" : "lines"},
	    {"vector_lattice", std::to_string(launch.points)},
	    {"vector_direction", kDirections[direction]},
	};
	if (!are_tufts)
		set.emplace_back("vector_steps", textOf(settings.vector_steps));
	if (!settings.vector_array.empty())
		set.emplace_back("vector_array", settings.vector_array);
	if (dt > 0.0)
		set.emplace_back("vector_dt", textOf(dt));
	for (const auto& [key, value] : set)
		if (vprobe::Status done = view.set(key, value); !done)
			return done;
	return vprobe::Nothing{};
}

} // namespace

vprobe::Result<View> viewOf(const Settings& settings, const Whole& whole)
{
	View view;
	if (!(dot(settings.normal, settings.normal) > 0.0))
		return vprobe::Error{vprobe::ErrorKind::usage, "Normal is zero; give it a direction"};
	placeProbe(settings, whole, view);
	if (settings.probe == Probe::file)
		if (const vprobe::Status read = readProbe(settings, view); !read)
			return read.error();
	if (const vprobe::Status set = setSurface(settings, view); !set)
		return set.error();
	view.crinkle(settings.crinkle);
	if (!settings.array.empty() && settings.needsArray())
		view.array(settings.array);
	if (settings.needsArray())
		view.component(settings.component);
	if (settings.has_threshold)
		view.threshold(settings.threshold[0], settings.threshold[1]);
	if (settings.growsContours())
		view.contour(settings.contours);
	if (settings.contour_depth > 0.0)
		if (const vprobe::Status set = view.set("contour_depth", textOf(settings.contour_depth)); !set)
			return set.error();
	if (const vprobe::Status set = setVectors(settings, whole, view); !set)
		return set.error();
	if (settings.threads > 0)
		if (const vprobe::Status set = view.set("threads", std::to_string(settings.threads)); !set)
			return set.error();
	if (const vprobe::Status checked = view.check(); !checked)
		return checked.error();
	return view;
}

} // namespace vprobe_paraview
