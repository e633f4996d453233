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

Vector3 cross(const Vector3& a, const Vector3& b)
{
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
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

// A window about the origin that nothing reaches out of, so that all ranks launch from one lattice.
std::array<double, 2> windowAround(const Settings& settings, const Whole& whole)
{
	const Vector3 normal = unit(settings.normal);
	const Vector3 side = cross(settings.up, normal);
	const bool is_parallel = dot(side, side) <= 1e-24 * dot(settings.up, settings.up);
	const Vector3 x = unit(is_parallel ? cross(Vector3{1.0, 0.0, 0.0}, normal) : side);
	const auto size = [&](const Vector3& direction)
	{
		const std::array<double, 2> ends = reach(settings, whole, direction);
		return 2.0 * std::max(std::abs(ends[0]), std::abs(ends[1]));
	};
	return {size(x), size(cross(normal, x))};
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
	else if (settings.probe == Probe::paddlewheel)
	{
		// Vanes that reach as far as the bounds of all ranks do, wherever the axis stands.
		double farthest = 0.0;
		for (const Vector3& axis : {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}, Vector3{0.0, 0.0, 1.0}})
			for (const double end : reach(settings, whole, axis))
				farthest += end * end;
		view.window(std::sqrt(farthest), 2.0 * std::sqrt(farthest));
	}
	else if (settings.launches() && whole.ranks > 1 && settings.probe != Probe::file)
	{
		const std::array<double, 2> window = windowAround(settings, whole);
		view.window(window[0], window[1]);
	}
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
	const vprobe::Status read = view.read(R"({"version": 1, "probe": {"probe": )" + settings.probe_text + "}}");
	if (read)
		return read;
	return vprobe::Error{read.error().kind, settings.probe_file + ": " + read.error().message};
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
	double dt = settings.vector_dt;
	if (dt <= 0.0 && whole.fastest > 0.0)
	{
		const std::array<double, 2> window = settings.has_window ? settings.window : windowAround(settings, whole);
		dt = std::max(window[0], window[1]) / settings.vector_lattice / whole.fastest;
	}
	constexpr std::array<const char*, 3> kDirections{"forward", "backward", "both"};
	const auto direction = static_cast<std::size_t>(std::clamp(settings.vector_direction, 0, 2));
	std::vector<std::pair<const char*, std::string>> set{
	    {"vectors", are_tufts ? "tufts" : "lines"},
	    {"vector_lattice", std::to_string(settings.vector_lattice)},
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
