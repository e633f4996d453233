#pragma once

#include "gpu/device.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vp::render::test
{

// One device for all tests, with validation where the layer is installed; null, and why, where there is none.
gpu::Device* sharedDevice();
const std::string& whyNoDevice();

// Skips where there is no device; expects that validation stayed silent.
class DrawingTest : public testing::Test
{
protected:
	void SetUp() override;
	void TearDown() override;

	Renderer& renderer() { return *renderer_; }
	gpu::Device& device() { return *sharedDevice(); }
	Picture draw(const Scene& scene);

	// A square of half a side `half` about the sheet's origin in n by n polygons, with values f(u, v).
	SheetDrawing square(const probe::Sheet& sheet, double half, double opacity,
	                    const std::function<double(double, double)>& f, int n = 8);

private:
	std::optional<Renderer> renderer_;
	std::size_t messages_before_ = 0;
};

// Values over a square.
inline double half(double, double)
{
	return 0.5;
}
inline double waves(double u, double v)
{
	return std::sin(3.0 * u) * std::cos(2.0 * v);
}

// A sheet at the origin that faces the z axis.
const probe::Sheet kFacing = probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0});

// A camera on the z axis that looks at the origin, and a picture with nothing in it: white, no overlay.
Scene bareScene(std::uint32_t width, std::uint32_t height, int samples);

// The place where the ray through a pixel (continuous, from the top left) meets the sheet's square.
struct Hit
{
	double distance; // along the view's axis
	double u;
	double v;
};
std::optional<Hit> hit(const Scene& scene, const probe::Sheet& sheet, double half, double x, double y);

using Rgb = std::array<double, 3>; // 0..255
Rgb rgb(Color color);
constexpr Rgb kWhite{255.0, 255.0, 255.0};
Rgb over(const Rgb& front, double opacity, const Rgb& back);
double difference(const Rgb& expected, const std::array<std::uint8_t, 4>& pixel); // in the worst channel

} // namespace vp::render::test
