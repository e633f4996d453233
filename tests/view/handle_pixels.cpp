#include "handle_pixels.h"

#include "probe/presets.h"
#include "render/scene/camera.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace view
{

namespace
{

glm::ivec2 onScreen(const glm::dvec2& pixel, const Area& scene)
{
	return glm::ivec2(glm::floor(pixel + glm::dvec2(scene.x, scene.y)));
}

vp::Vec3 vectorOf(const nlohmann::json& numbers)
{
	return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

} // namespace

SeenProbe seenProbe(const nlohmann::json& state, const vp::Box& bounds, const Area& scene)
{
	const nlohmann::json& options = state.at("probe");
	vp::Vec3 normal;
	std::istringstream(options.at("normal").get<std::string>()) >> normal.x >> normal.y >> normal.z;
	const vp::probe::Frame frame =
	    vp::probe::makeFrame(vectorOf(options.at("origin")), normal, vectorOf(options.at("up")));
	const vp::probe::WindowSize size{options.at("window").at(0), options.at("window").at(1)};
	auto camera = vp::render::parseCamera(state.at("look").at("camera").get<std::string>());
	if (!camera)
		throw std::runtime_error(camera.error().message);
	vp::render::Frame picture;
	picture.width = scene.width;
	picture.height = scene.height;
	return {vp::probe::single(frame, size), {camera->camera, picture}, bounds, scene};
}

glm::ivec2 pixelOf(const SeenProbe& seen, const vp::interact::Handle& handle)
{
	const auto shapes = vp::interact::handlesOf(seen.probe, seen.view, seen.bounds);
	for (const auto& shape : shapes)
		if (shape.handle == handle)
			for (const auto& line : shape.lines)
				for (const vp::Vec3& point : line)
				{
					const auto pixel = vp::interact::pixelOf(seen.view, point);
					// Half the hand's reach: a pixel of rounding is allowed for.
					if (pixel && vp::interact::pickHandle(shapes, seen.view, *pixel, 3.0) == handle)
						return onScreen(*pixel, seen.scene);
				}
	ADD_FAILURE() << "no pixel takes the handle";
	return {0, 0};
}

glm::ivec2 pixelOf(const SeenProbe& seen, const vp::Vec3& point)
{
	const auto pixel = vp::interact::pixelOf(seen.view, point);
	EXPECT_TRUE(pixel);
	return pixel ? onScreen(*pixel, seen.scene) : glm::ivec2(0);
}

} // namespace view
