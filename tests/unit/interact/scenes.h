#pragma once

#include "interact/handles.h"
#include "probe/presets.h"
#include "render/scene/outline.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace vp::test
{

using interact::Handle;
using interact::HandleKind;
using interact::View;
using Pixel = glm::dvec2;

// A probe in a box, and somebody who looks at it.
struct Scene
{
	std::string name;
	Box bounds;
	probe::Probe probe;
	View view;

	std::vector<Vec3> corners() const
	{
		std::vector<Vec3> points;
		for (int i = 0; i < 8; ++i)
			points.push_back(render::corner(bounds, i));
		return points;
	}
};

// Beside the middle of the probe on screen.
inline Pixel startOf(const Scene& scene)
{
	return scene.view.camera.project(scene.probe.frame.origin, scene.view.frame) + Pixel(37.0, -21.0);
}

inline double degreesBetween(const Vec3& a, const Vec3& b)
{
	return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / std::numbers::pi;
}

inline double uniform(double lo, double hi, std::mt19937& random)
{
	return std::uniform_real_distribution<double>(lo, hi)(random);
}

inline std::vector<probe::Probe> someProbes(const Box& bounds)
{
	const Vec3 c = bounds.center();
	const probe::Frame level = probe::makeFrame(c, {0.0, 0.0, 1.0});
	const probe::Frame oblique = probe::makeFrame(c + Vec3(0.2, -0.1, 0.3), {0.3, 0.5, 0.81}, {0.1, 1.0, 0.2});
	const std::array offsets{-0.5, 0.1, 0.6};
	std::vector<probe::Probe> probes{probe::single(level),
	                                 probe::single(oblique, probe::WindowSize{1.5, 0.8}),
	                                 probe::single(oblique, probe::WindowSize{2e-5, 1e-5}),
	                                 probe::trihedral(oblique, probe::WindowSize{2.0, 2.0}),
	                                 probe::paddlewheel(level, bounds),
	                                 probe::paddlewheel(oblique, bounds, 5, probe::WindowSize{1.0, 2.0}),
	                                 probe::stack(oblique, offsets),
	                                 probe::stack(level, offsets, probe::WindowSize{1.0, 1.2})};
	probes.push_back(probes[1]);
	probes.back().sheets[0].fx = {4.0, {0.1, -0.2, 0.0}};
	probes.push_back(probes[7]);
	probes.back().sheets[1].wishes.hidden = true;
	return probes;
}

// All probes from all sides, some straight onto a sheet or along it; near zero and far from it.
inline std::vector<Scene> allScenes()
{
	const render::Frame frame{1280.0, 720.0, {20.0, 60.0}, {1100.0, 690.0}, {}};
	std::vector<Scene> scenes;
	for (const double offset : {0.0, 1e7})
	{
		const Box bounds{Vec3(offset - 1.0, -2.0, -offset - 1.5), Vec3(offset + 1.0, 2.0, -offset + 1.5)};
		const std::vector<probe::Probe> probes = someProbes(bounds);
		for (std::size_t p = 0; p < probes.size(); ++p)
			for (const char* camera : {"x", "-y", "z", "iso", "sheet", "-100,70", "33,-8"})
			{
				Scene scene{std::to_string(p) + " from " + camera + (offset == 0.0 ? "" : ", far off"),
				            bounds,
				            probes[p],
				            {{}, frame}};
				const probe::Sheet sheet = probe::placed(probes[p]).sheets[0];
				scene.view.camera =
				    render::makeCamera(render::parseCamera(camera).value(), &sheet, scene.corners(), frame);
				scenes.push_back(scene);
			}
	}
	return scenes;
}

inline Scene sceneNamed(const std::string& name)
{
	for (const Scene& scene : allScenes())
		if (scene.name == name)
			return scene;
	ADD_FAILURE() << "no scene " << name;
	return {};
}

inline Pixel somePixel(const View& view, std::mt19937& random)
{
	return {uniform(0.0, view.frame.width, random), uniform(0.0, view.frame.height, random)};
}

inline void expectFrame(const probe::Frame& frame)
{
	EXPECT_NEAR(glm::length(frame.normal), 1.0, 1e-14);
	EXPECT_NEAR(glm::length(frame.up), 1.0, 1e-14);
	EXPECT_NEAR(glm::dot(frame.normal, frame.up), 0.0, 1e-14);
	EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(frame.origin), Vec3(1e9))));
}

} // namespace vp::test
