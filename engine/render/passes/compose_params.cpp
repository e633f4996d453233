#include "render/passes/compose_params.h"

#include "render/passes/picture_geometry.h"
#include "render/passes/value_params.h"

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::ComposeParams) == 4 * (15 + 22 * shared::kMaxLayers));

constexpr Color kLineOnLight{66, 72, 82, 225};
constexpr Color kLineOnDark{206, 211, 218, 225};

// Sheets whose distance is this part of that to the eye lie in one plane.
constexpr double kOnePlane = 1e-9;

void storeColor(float (&to)[4], Color c)
{
	const std::uint8_t from[] = {c.r, c.g, c.b, c.a};
	for (int i = 0; i < 4; ++i)
		to[i] = static_cast<float>(from[i]) / 255.0f;
}

// A sheet has no back.
float shade(const probe::Sheet& sheet, const Camera& camera)
{
	const double facing = std::abs(glm::dot(sheet.normal, lightDirection(camera)));
	return shared::kAmbient + (1.0f - shared::kAmbient) * static_cast<float>(facing);
}

} // namespace

std::vector<std::array<double, 3>> planeDepths(const Scene& scene, const PicturePart& part)
{
	std::vector<std::array<double, 3>> depths;
	for (std::size_t i = 0; i < scene.sheets.size(); ++i)
	{
		const probe::Sheet& sheet = scene.sheets[i].sheet;
		depths.push_back(planeDepth(sheet, scene.camera, part));
		for (std::size_t j = 0; j < i; ++j)
		{
			const probe::Sheet& other = scene.sheets[j].sheet;
			const Vec3 between = sheet.origin - other.origin;
			const double reach = glm::length(between) + glm::length(other.origin - scene.camera.position);
			if (glm::length(glm::cross(sheet.normal, other.normal)) < kOnePlane &&
			    std::abs(glm::dot(between, other.normal)) < kOnePlane * reach)
			{
				depths.back() = depths[j];
				break;
			}
		}
	}
	return depths;
}

ComposeParams composeParams(const Scene& scene, const PicturePart& part)
{
	ComposeParams made{};
	shared::ComposeParams& params = made.params;
	const Look& look = scene.look;
	params.height = static_cast<float>(part.picture.height);
	params.sample_weight = 1.0f / static_cast<float>(samplePattern(look.samples).size());
	params.contour_half_width = 0.5f * lineWidth(look);
	storeColor(params.line_color, look.background.dark() ? kLineOnDark : kLineOnLight);
	storeColor(params.top_color, look.background.top);
	storeColor(params.bottom_color, look.background.bottom);
	ColorTables tables;
	const auto depths = planeDepths(scene, part);
	for (std::size_t i = 0; i < scene.sheets.size(); ++i)
	{
		const SheetDrawing& drawing = scene.sheets[i];
		shared::SheetParams& sheet = params.sheets[i];
		std::transform(depths[i].begin(), depths[i].end(), sheet.plane, [](double d) { return static_cast<float>(d); });
		sheet.opacity = static_cast<float>(std::clamp(drawing.opacity, 0.0, 1.0));
		sheet.shade = look.lit ? shade(drawing.sheet, scene.camera) : 1.0f;
		if (drawing.values || scene.values)
			setValues(sheet, valueStyle(scene, drawing), tables);
		else
			setPlain(sheet, kPlainColor);
		made.features |= featuresOf(sheet);
	}
	if (look.mesh)
		made.features |= shared::kComposeMesh;
	made.tables = tables.take();
	for (std::size_t i = 0; i < std::max<std::size_t>(1, scene.sheets.size()); ++i)
		params.layer_colors[i] = addLayerColors(made.colors, params.sheets[i], made.tables);
	return made;
}

} // namespace vp::render
