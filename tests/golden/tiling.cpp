#include "tiling.h"

#include "uniform.h"

#include <glm/common.hpp>

#include <cmath>

namespace vp::render::test
{

Tiling::Tiling(std::mt19937& random, const glm::ivec2& sides, double half, bool bends)
{
	const glm::dvec2 step = 2.0 * half / glm::dvec2(sides);
	for (int j = 0; j <= sides.y; ++j)
		for (int i = 0; i <= sides.x; ++i)
			points_.push_back(step * glm::dvec2(i, j) - half +
			                  step * glm::dvec2(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2)));
	for (int j = 0; j < sides.y; ++j)
		for (int i = 0; i < sides.x; ++i)
			addCell(random, static_cast<std::uint32_t>(j * (sides.x + 1) + i), static_cast<std::uint32_t>(sides.x + 1),
			        bends ? 3 : 2);
}

void Tiling::addCell(std::mt19937& random, std::uint32_t a, std::uint32_t row, unsigned kinds)
{
	const std::uint32_t b = a + 1;
	const std::uint32_t c = a + row + 1;
	const std::uint32_t d = a + row;
	switch (random() % kinds)
	{
	case 0:
		polygons_.push_back({a, b, c, d});
		break;
	case 1:
		polygons_.push_back({a, b, c});
		polygons_.push_back({c, d, a});
		break;
	default:
		points_.push_back(glm::mix(points_[a], points_[c], uniform(random, 0.1, 0.9)));
		const auto between = static_cast<std::uint32_t>(points_.size() - 1);
		polygons_.push_back({a, b, c, between});
		polygons_.push_back({c, d, a, between});
	}
}

std::vector<vp::shared::PolygonRecord> Tiling::records() const
{
	std::vector<vp::shared::PolygonRecord> records;
	for (const std::vector<std::uint32_t>& polygon : polygons_)
	{
		vp::shared::PolygonRecord& record = records.emplace_back();
		for (const std::uint32_t corner : polygon)
		{
			record.uv[2 * record.vertices] = static_cast<float>(points_[corner].x);
			record.uv[2 * record.vertices + 1] = static_cast<float>(points_[corner].y);
			record.value[record.vertices++] = static_cast<float>(0.5 + 0.3 * std::sin(points_[corner].x));
		}
	}
	return records;
}

} // namespace vp::render::test
