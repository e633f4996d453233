#include "random_probe.h"

#include "uniform.h"

#include "shared/render_types.h"

#include <array>
#include <cmath>

namespace vp::render::test
{

namespace
{

using vp::shared::PolygonRecord;

Vec3 direction(std::mt19937& random)
{
	for (;;)
	{
		const Vec3 v{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)};
		if (glm::length(v) > 0.1 && glm::length(v) < 1.0)
			return glm::normalize(v);
	}
}

// Values over a sheet, within 0..1 and not linear.
struct Waves
{
	double a, b, c;

	double operator()(const glm::dvec2& p) const { return 0.5 + 0.2 * std::sin(a * p.x + c) + 0.2 * std::cos(b * p.y); }
};

PolygonRecord polygon(const std::vector<glm::dvec2>& corners, const Waves& waves)
{
	PolygonRecord record{};
	record.vertices = static_cast<std::uint32_t>(corners.size());
	for (std::size_t k = 0; k < corners.size(); ++k)
	{
		record.uv[2 * k] = static_cast<float>(corners[k].x);
		record.uv[2 * k + 1] = static_cast<float>(corners[k].y);
		record.value[k] = static_cast<float>(waves(corners[k]));
	}
	return record;
}

// Over the square of half a side 1.2: quadrangles with corners out of place, some halved into triangles.
std::vector<PolygonRecord> quadrangles(std::mt19937& random, const Waves& waves)
{
	constexpr int kSide = 9;
	std::array<std::array<glm::dvec2, kSide + 1>, kSide + 1> points;
	for (int j = 0; j <= kSide; ++j)
		for (int i = 0; i <= kSide; ++i)
			points[j][i] =
			    2.4 / kSide *
			    (glm::dvec2(i, j) - 0.5 * kSide + glm::dvec2(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2)));
	std::vector<PolygonRecord> records;
	for (int j = 0; j < kSide; ++j)
		for (int i = 0; i < kSide; ++i)
		{
			const glm::dvec2 p[] = {points[j][i], points[j][i + 1], points[j + 1][i + 1], points[j + 1][i]};
			if (random() % 4 == 0)
			{
				records.push_back(polygon({p[0], p[1], p[2]}, waves));
				records.push_back(polygon({p[0], p[2], p[3]}, waves));
			}
			else
				records.push_back(polygon({p[0], p[1], p[2], p[3]}, waves));
			records.push_back({}); // a cell that emitted nothing
		}
	return records;
}

std::vector<PolygonRecord> hexagons(const Waves& waves)
{
	constexpr double kRadius = 0.16;
	const double wide = std::sqrt(3.0) * kRadius;
	std::vector<PolygonRecord> records;
	for (int j = -5; j <= 5; ++j)
		for (int i = -5; i <= 5; ++i)
		{
			// Corners shared by neighbors are formed from whole numbers, so that they are the same floats.
			std::vector<glm::dvec2> corners;
			constexpr std::array<std::array<int, 2>, 6> kCorners{{{1, -1}, {1, 1}, {0, 2}, {-1, 1}, {-1, -1}, {0, -2}}};
			for (const auto& [x, y] : kCorners)
				corners.push_back({0.5 * wide * (2 * i + std::abs(j % 2) + x), 0.5 * kRadius * (3 * j + y)});
			records.push_back(polygon(corners, waves));
		}
	return records;
}

} // namespace

std::vector<KnownSheet> randomProbe(std::mt19937& random)
{
	const std::size_t count = 2 + random() % (vp::shared::kMaxLayers - 1);
	std::vector<KnownSheet> sheets;
	while (sheets.size() < count)
	{
		const Vec3 origin = 0.5 * uniform(random, 0.0, 1.0) * direction(random);
		KnownSheet made;
		made.drawing.sheet = probe::makeSheet(origin, direction(random), direction(random));
		if (!sheets.empty() && random() % 4 == 0)
		{
			// This sheet has the same plane, with another origin and other axes. Half of the time it is seen from its
			// back.
			const probe::Sheet& before = sheets.back().drawing.sheet;
			const Vec3 moved =
			    before.origin + uniform(random, -0.4, 0.4) * before.xAxis() + uniform(random, -0.4, 0.4) * before.up;
			const double side = random() % 2 == 0 ? 1.0 : -1.0;
			made.drawing.sheet = probe::makeSheet(moved, side * before.normal, direction(random));
		}
		made.drawing.opacity = uniform(random, 0.1, 1.0);
		made.drawing.magnification = uniform(random, 0.6, 1.5);
		made.drawing.window = WindowRect{uniform(random, -1.3, -0.2), uniform(random, 0.2, 1.3),
		                                 uniform(random, -1.3, -0.2), uniform(random, 0.2, 1.3)};
		made.drawing.rim = false;
		const Waves waves{uniform(random, 1.0, 3.0), uniform(random, 1.0, 3.0), uniform(random, 0.0, 6.0)};
		made.records = random() % 2 == 0 ? quadrangles(random, waves) : hexagons(waves);
		sheets.push_back(std::move(made));
	}
	return sheets;
}

Camera randomCamera(std::mt19937& random)
{
	Camera camera;
	camera.position = uniform(random, 5.0, 7.0) * direction(random);
	camera.focal_point = 0.2 * direction(random);
	camera.up = direction(random);
	camera.vertical_field = uniform(random, 20.0, 30.0);
	camera.near = 1.0;
	return camera;
}

} // namespace vp::render::test
