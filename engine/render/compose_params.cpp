#include "render/compose_params.h"

#include "render/picture_geometry.h"
#include "render/value_style.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::ComposeParams) == 4 * (16 + 21 * shared::kMaxLayers));
static_assert(shared::kTableColors == kColorMapSize);

// Interpolation rounds; it must not take the ends of the range out of it.
constexpr double kRangeSlack = 1e-5;

constexpr Color kLineOnLight{66, 72, 82, 225};
constexpr Color kLineOnDark{206, 211, 218, 225};

// Sheets whose distance is this part of that to the eye lie in one plane.
constexpr double kOnePlane = 1e-9;

std::uint32_t packed(Color c)
{
	return c.r | std::uint32_t(c.g) << 8 | std::uint32_t(c.b) << 16 | std::uint32_t(c.a) << 24;
}

void store(float (&to)[4], Color c)
{
	const std::uint8_t from[] = {c.r, c.g, c.b, c.a};
	for (int i = 0; i < 4; ++i)
		to[i] = static_cast<float>(from[i]) / 255.0f;
}

// Light comes from above the viewer's left shoulder, so that sheets at right angles differ. A sheet has no back.
float shade(const probe::Sheet& sheet, const Camera& camera)
{
	const Vec3 light = glm::normalize(-camera.forward() + 0.45 * camera.trueUp() - 0.3 * camera.right());
	constexpr double kAmbient = 0.45;
	return static_cast<float>(kAmbient + (1.0 - kAmbient) * std::abs(glm::dot(sheet.normal, light)));
}

class Tables
{
public:
	std::uint32_t add(const std::vector<Color>& colors)
	{
		const auto place = static_cast<std::uint32_t>(words_.size());
		std::transform(colors.begin(), colors.end(), std::back_inserter(words_), packed);
		return place;
	}
	std::uint32_t add(const std::vector<double>& numbers)
	{
		const auto place = static_cast<std::uint32_t>(words_.size());
		for (const double number : numbers)
			words_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(number)));
		return place;
	}
	std::vector<std::uint32_t> take() { return std::move(words_); }

private:
	std::vector<std::uint32_t> words_;
};

void setPlain(shared::SheetParams& sheet)
{
	// Whatever the values are, they lie below this.
	sheet.below_from = std::numeric_limits<float>::infinity();
	sheet.above_from = std::numeric_limits<float>::infinity();
	sheet.below_color = sheet.nan_color = packed(kPlainSheet);
}

void setRange(shared::SheetParams& sheet, const ValueStyle& style)
{
	const double lo = style.scaled(style.lo);
	const double hi = style.scaled(style.hi);
	const double slack = kRangeSlack * (hi - lo);
	constexpr float kEndless = std::numeric_limits<float>::infinity();
	sheet.below_from = style.below ? static_cast<float>(lo - slack) : -kEndless;
	sheet.above_from = style.above ? static_cast<float>(hi + slack) : kEndless;
	sheet.range_lo = static_cast<float>(lo);
	// A constant has the map's middle.
	const bool constant = !(hi > lo);
	sheet.range_scale = constant ? 0.0f : static_cast<float>(1.0 / (hi - lo));
	sheet.range_offset = constant ? 0.5f : 0.0f;
	sheet.is_log = style.logarithmic ? 1 : 0;
	sheet.is_stepped = style.per_cell ? 1 : 0;
}

std::vector<double> scaled(const std::vector<double>& values, const ValueStyle& style)
{
	std::vector<double> result;
	for (const double value : values)
		result.push_back(style.scaled(value));
	return result;
}

void setSteps(shared::SheetParams& sheet, const ValueStyle& style, Tables& tables)
{
	CategorySteps steps;
	if (!style.colors->categories.empty())
	{
		steps = categorySteps(*style.colors);
		sheet.below_from = -std::numeric_limits<float>::infinity();
		sheet.above_from = std::numeric_limits<float>::infinity();
	}
	else if (!style.bands.empty())
	{
		steps.bounds = scaled(style.bands, style);
		for (std::size_t i = 0; i <= style.bands.size(); ++i)
			steps.colors.push_back(style.bandColor(i));
	}
	sheet.step_count = static_cast<std::uint32_t>(steps.bounds.size());
	sheet.step_bounds = tables.add(steps.bounds);
	sheet.step_colors = tables.add(steps.colors);
}

void setValues(shared::SheetParams& sheet, const ValueStyle& style, Tables& tables)
{
	const ColorMap& map = *style.colors;
	setRange(sheet, style);
	setSteps(sheet, style, tables);
	sheet.colors = tables.add(std::vector<Color>(map.colors.begin(), map.colors.end()));
	sheet.level_count = static_cast<std::uint32_t>(style.lines.size());
	sheet.levels = tables.add(scaled(style.lines, style));
	sheet.nan_color = packed(map.nan);
	sheet.below_color = packed(map.below);
	sheet.above_color = packed(map.above);
}

std::uint32_t featuresOf(const shared::SheetParams& sheet)
{
	return (sheet.level_count > 0 ? shared::kComposeLines : 0u) | (sheet.step_count > 0 ? shared::kComposeSteps : 0u) |
	       (sheet.is_log != 0 ? shared::kComposeLog : 0u);
}

} // namespace

std::vector<std::array<double, 3>> planeDepths(const Scene& scene, VkExtent2D extent)
{
	std::vector<std::array<double, 3>> depths;
	for (std::size_t i = 0; i < scene.sheets.size(); ++i)
	{
		const probe::Sheet& sheet = scene.sheets[i].sheet;
		depths.push_back(planeDepth(sheet, scene.camera, extent));
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

ComposeParams composeParams(const Scene& scene, VkExtent2D extent)
{
	ComposeParams made{};
	shared::ComposeParams& params = made.params;
	const Look& look = scene.look;
	params.height = static_cast<float>(extent.height);
	params.sample_weight = 1.0f / static_cast<float>(samplePattern(look.samples).size());
	params.last_layer = static_cast<std::uint32_t>(scene.sheets.empty() ? 0 : scene.sheets.size() - 1);
	params.contour_half_width = 0.5f * lineWidth(look);
	store(params.line_color, look.background.dark() ? kLineOnDark : kLineOnLight);
	store(params.top_color, look.background.top);
	store(params.bottom_color, look.background.bottom);
	Tables tables;
	const auto depths = planeDepths(scene, extent);
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
			setPlain(sheet);
		made.features |= featuresOf(sheet);
	}
	if (look.mesh)
		made.features |= shared::kComposeMesh;
	tables.add(std::vector<Color>(kColorMapSize)); // what sheets without values read and do not show
	made.tables = tables.take();
	return made;
}

} // namespace vp::render
