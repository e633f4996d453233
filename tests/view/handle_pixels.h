#pragma once

#include "desktop.h"
#include "interact/pick.h"
#include "probe/probe.h"

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

namespace view
{

// The visible probe, from a saved state that has origin, normal, window and camera.
struct SeenProbe
{
	vp::probe::Probe probe;
	vp::interact::View view;
	vp::Box bounds;
	Area scene;
};

// bounds: of the input.
SeenProbe seenProbe(const nlohmann::json& state, const vp::Box& bounds, const Area& scene);

// A place on the screen where a hand takes this handle and no other; fails the test where there is none.
glm::ivec2 pixelOf(const SeenProbe& seen, const vp::interact::Handle& handle);
// Returns the pixel where a point of the world is seen.
glm::ivec2 pixelOf(const SeenProbe& seen, const vp::Vec3& point);

} // namespace view
