#include "render/passes/picture_geometry.h"

#include "classify/gpu_records.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

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
	// The first sample stands for all where no edge is (EdgeMask).
	std::iter_swap(pattern.begin(), std::min_element(pattern.begin(), pattern.end(),
	                                                 [](const glm::dvec2& a, const glm::dvec2& b)
	                                                 { return glm::dot(a, a) < glm::dot(b, b); }));
	return pattern;
}

glm::dmat4 clipMatrix(const Camera& camera, const PicturePart& part, const Vec3& center, const glm::dvec2& jitter)
{
	const glm::dvec2 size(part.picture.width, part.picture.height);
	const double rows = part.extent.height;
	glm::dmat4 to_part(1.0);
	to_part[1][1] = size.y / rows;
	to_part[3][0] = 2.0 * jitter.x / size.x;
	to_part[3][1] = (size.y - 2.0 * part.first_row + 2.0 * jitter.y) / rows - 1.0;
	return to_part * camera.projection(size.x / size.y) * glm::translate(camera.view(), center);
}

Vec3 lightDirection(const Camera& camera)
{
	return glm::normalize(-camera.forward() + 0.45 * camera.trueUp() - 0.3 * camera.right());
}

float lineWidth(const Look& look)
{
	return static_cast<float>(std::max(1.2, 1.5 * std::min(look.height / 720.0, look.width / 960.0)));
}

std::uint32_t contourReach(const Look& look)
{
	return std::max(1u, static_cast<std::uint32_t>(0.5f * lineWidth(look) + 0.5f));
}

namespace
{

// A sheet's frame in clip space.
struct ClipFrame
{
	glm::dvec4 u;
	glm::dvec4 v;
	glm::dvec4 origin;

	ClipFrame(const SheetDrawing& drawing, const Camera& camera, const PicturePart& part, const glm::dvec2& jitter)
	{
		const probe::Sheet& sheet = drawing.sheet;
		const glm::dmat4 clip = clipMatrix(camera, part, sheet.origin, jitter);
		u = clip * glm::dvec4(drawing.magnification * sheet.xAxis(), 0.0);
		v = clip * glm::dvec4(drawing.magnification * sheet.up, 0.0);
		origin = clip[3];
	}
};

void storeFloats(std::span<float> to, const double* from)
{
	std::transform(from, from + to.size(), to.begin(), [](double d) { return static_cast<float>(d); });
}

void storeWindow(float (&to)[4], const std::optional<WindowRect>& window)
{
	if (!window)
		return;
	const double sides[] = {window->x0, window->x1, window->y0, window->y1};
	storeFloats(to, sides);
}

} // namespace

shared::LayerPush layerPush(const SheetDrawing& drawing, const Camera& camera, const PicturePart& part,
                            const glm::dvec2& jitter)
{
	const ClipFrame frame(drawing, camera, part, jitter);
	shared::LayerPush push{};
	storeFloats(push.u_axis, &frame.u[0]);
	storeFloats(push.v_axis, &frame.v[0]);
	storeFloats(push.origin, &frame.origin[0]);
	storeWindow(push.window, drawing.window);
	return push;
}

shared::RasterPush rasterPush(const SheetDrawing& drawing, const Camera& camera, const PicturePart& part,
                              const glm::dvec2& jitter)
{
	const ClipFrame frame(drawing, camera, part, jitter);
	const glm::dvec2 half = 0.5 * glm::dvec2(part.extent.width, part.extent.height);
	const auto inPixels = [&](const glm::dvec4& clip) {
		return glm::dvec3(half.x * clip.x + (half.x - 0.5) * clip.w, half.y * clip.y + (half.y - 0.5) * clip.w, clip.w);
	};
	const glm::dmat3 to_pixels(inPixels(frame.u), inPixels(frame.v), inPixels(frame.origin));
	const glm::dvec3 subpixels(shared::kSubpixels, shared::kSubpixels, 1.0);
	shared::RasterPush push{};
	storeFloats(push.u_axis, &(subpixels * to_pixels[0])[0]);
	storeFloats(push.v_axis, &(subpixels * to_pixels[1])[0]);
	storeFloats(push.origin, &(subpixels * to_pixels[2])[0]);
	const glm::dmat3 back = glm::transpose(glm::inverse(to_pixels)); // its columns are the rows that are wanted
	storeFloats(push.u_of_pixel, &back[0][0]);
	storeFloats(push.v_of_pixel, &back[1][0]);
	storeFloats(push.w_of_pixel, &back[2][0]);
	storeWindow(push.window, drawing.window);
	push.near_w = static_cast<float>(camera.near);
	push.last_pixel[0] = static_cast<float>(part.extent.width - 1);
	push.last_pixel[1] = static_cast<float>(part.extent.height - 1);
	return push;
}

namespace
{

// Where a sheet has something to show, in its records' uv; none: anywhere.
std::optional<mesh::UvBounds> shownBounds(const SheetDrawing& drawing)
{
	std::optional<mesh::UvBounds> bounds = drawing.bounds ? drawing.bounds : drawing.records->bounds;
	if (const auto& window = drawing.window)
	{
		const mesh::UvBounds all = bounds.value_or(mesh::UvBounds{glm::dvec2(-1e300), glm::dvec2(1e300)});
		bounds = mesh::UvBounds{glm::max(all.lo, {window->x0, window->y0}), glm::min(all.hi, {window->x1, window->y1})};
	}
	return bounds;
}

} // namespace

VkRect2D sheetsPart(const Scene& scene, const PicturePart& part)
{
	constexpr double kPad = 2.0; // pixels, for samples beside the middle and for rounding
	const VkRect2D whole{{0, 0}, part.extent};
	const glm::dvec2 size(part.picture.width, part.picture.height);
	const glm::dvec2 end(part.extent.width, part.extent.height);
	const Frame frame{size.x, size.y, {}, {}, {}};
	glm::dvec2 lo = size;
	glm::dvec2 hi(0.0);
	for (const SheetDrawing& drawing : scene.sheets)
	{
		if (!drawing.bounds && (!drawing.records || drawing.records->pages.empty()))
			continue;
		const auto bounds = shownBounds(drawing);
		if (!bounds)
			return whole;
		for (const double u : {bounds->lo.x, bounds->hi.x})
			for (const double v : {bounds->lo.y, bounds->hi.y})
			{
				const Vec3 at = drawing.inWorld({u, v});
				if (!(glm::dot(at - scene.camera.position, scene.camera.forward()) > scene.camera.near))
					return whole;
				const glm::dvec2 pixel = scene.camera.project(at, frame) - glm::dvec2(0.0, part.first_row);
				lo = glm::min(lo, pixel);
				hi = glm::max(hi, pixel);
			}
	}
	lo = glm::clamp(glm::floor(lo - kPad), glm::dvec2(0.0), end);
	hi = glm::clamp(glm::ceil(hi + kPad), lo, end);
	return {{static_cast<std::int32_t>(lo.x), static_cast<std::int32_t>(lo.y)},
	        {static_cast<std::uint32_t>(hi.x - lo.x), static_cast<std::uint32_t>(hi.y - lo.y)}};
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

std::array<double, 3> planeDepth(const probe::Sheet& sheet, const Camera& camera, const PicturePart& part)
{
	const Vec3 to_sheet = sheet.origin - camera.position;
	const double distance = glm::dot(sheet.normal, to_sheet);
	if (std::abs(distance) < 1e-12 * glm::length(to_sheet))
		return {0.0, 0.0, 0.0};
	// The point of the plane seen at a pixel is eye + w ray, ray = forward + x right + y up linear in the pixel.
	const double tangent = std::tan(0.5 * camera.vertical_field * std::numbers::pi / 180.0);
	const double right = glm::dot(sheet.normal, camera.right()) * tangent * part.picture.width / part.picture.height;
	const double up = glm::dot(sheet.normal, camera.trueUp()) * tangent;
	const double forward = glm::dot(sheet.normal, camera.forward());
	const double scale = camera.near / distance;
	const double down = -scale * up * 2.0 / part.picture.height; // from row to row
	return {scale * right * 2.0 / part.picture.width, down, scale * (forward - right + up) + down * part.first_row};
}

} // namespace vp::render
