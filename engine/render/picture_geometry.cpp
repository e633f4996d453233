#include "render/picture_geometry.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace vp::render
{

std::vector<glm::dvec2> samplePattern(int samples)
{
	samples = std::clamp(samples, 1, kMaxSamples);
	// The generator near n / golden ratio without a common factor spreads the lattice well.
	int generator = std::max(1, static_cast<int>(std::lround(samples / std::numbers::phi)));
	while (std::gcd(generator, samples) != 1)
		++generator;
	std::vector<glm::dvec2> pattern;
	for (int i = 0; i < samples; ++i)
		pattern.push_back(
		    {(i + 0.5) / samples - 0.5, (static_cast<long>(i) * generator % samples + 0.5) / samples - 0.5});
	return pattern;
}

glm::dmat4 clipMatrix(const Camera& camera, VkExtent2D extent, const Vec3& centre, const glm::dvec2& jitter)
{
	const glm::dvec2 size(extent.width, extent.height);
	glm::dmat4 shift(1.0);
	shift[3][0] = 2.0 * jitter.x / size.x;
	shift[3][1] = 2.0 * jitter.y / size.y;
	return shift * camera.projection(size.x / size.y) * glm::translate(camera.view(), centre);
}

Vec3 lightDirection(const Camera& camera)
{
	return glm::normalize(-camera.forward() + 0.45 * camera.trueUp() - 0.3 * camera.right());
}

float lineWidth(const Look& look)
{
	return static_cast<float>(std::max(1.2, 1.5 * std::min(look.height / 720.0, look.width / 960.0)));
}

shared::LayerPush layerPush(const SheetDrawing& drawing, const Camera& camera, VkExtent2D extent,
                            const glm::dvec2& jitter)
{
	const probe::Sheet& sheet = drawing.sheet;
	const glm::dmat4 clip = clipMatrix(camera, extent, sheet.origin, jitter);
	const glm::dvec4 u = clip * glm::dvec4(drawing.magnification * sheet.xAxis(), 0.0);
	const glm::dvec4 v = clip * glm::dvec4(drawing.magnification * sheet.up, 0.0);
	const glm::dvec4 origin = clip[3];
	shared::LayerPush push{};
	for (int i = 0; i < 4; ++i)
	{
		push.u_axis[i] = static_cast<float>(u[i]);
		push.v_axis[i] = static_cast<float>(v[i]);
		push.origin[i] = static_cast<float>(origin[i]);
	}
	if (const auto& window = drawing.window)
	{
		const double sides[] = {window->x0, window->x1, window->y0, window->y1};
		std::transform(std::begin(sides), std::end(sides), push.window, [](double d) { return static_cast<float>(d); });
	}
	return push;
}

std::vector<Segment> windowRim(const SheetDrawing& drawing)
{
	if (!drawing.window)
		return {};
	const WindowRect& w = *drawing.window;
	const auto at = [&drawing](double u, double v)
	{ return drawing.sheet.origin + drawing.magnification * (u * drawing.sheet.xAxis() + v * drawing.sheet.up); };
	const Vec3 corners[] = {at(w.x0, w.y0), at(w.x1, w.y0), at(w.x1, w.y1), at(w.x0, w.y1)};
	std::vector<Segment> rim;
	for (int i = 0; i < 4; ++i)
		rim.push_back({corners[i], corners[(i + 1) % 4]});
	return rim;
}

std::array<double, 3> planeDepth(const probe::Sheet& sheet, const Camera& camera, VkExtent2D extent)
{
	const Vec3 to_sheet = sheet.origin - camera.position;
	const double distance = glm::dot(sheet.normal, to_sheet);
	if (std::abs(distance) < 1e-12 * glm::length(to_sheet))
		return {0.0, 0.0, 0.0};
	// The point of the plane seen at a pixel is eye + w ray, ray = forward + x right + y up linear in the pixel.
	const double tangent = std::tan(0.5 * camera.vertical_field * std::numbers::pi / 180.0);
	const double right = glm::dot(sheet.normal, camera.right()) * tangent * extent.width / extent.height;
	const double up = glm::dot(sheet.normal, camera.trueUp()) * tangent;
	const double forward = glm::dot(sheet.normal, camera.forward());
	const double scale = camera.near / distance;
	return {scale * right * 2.0 / extent.width, -scale * up * 2.0 / extent.height, scale * (forward - right + up)};
}

} // namespace vp::render
