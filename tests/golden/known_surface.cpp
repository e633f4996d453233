#include "known_surface.h"

#include "uniform.h"

#include "render/passes/surface_polygons.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::render::test
{

namespace
{

const ValueScale kScale{.title = "g"};

} // namespace

void addPolygon(mesh::SheetMesh& mesh, const std::vector<Vec3>& corners)
{
	if (mesh.polygon_starts.empty())
		mesh.polygon_starts.push_back(0);
	for (const Vec3& corner : corners)
	{
		const auto known = std::ranges::find(mesh.positions, corner);
		mesh.polygon_vertices.push_back(static_cast<std::uint32_t>(known - mesh.positions.begin()));
		if (known == mesh.positions.end())
			mesh.positions.push_back(corner);
	}
	mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
	mesh.polygon_cells.push_back({});
}

KnownSurface asSurface(const KnownSheet& known)
{
	KnownSurface made;
	const probe::Sheet& sheet = known.drawing.sheet;
	for (const vp::shared::PolygonRecord& record : known.records)
	{
		std::vector<Vec3> corners;
		for (std::uint32_t k = 0; k < record.vertices; ++k)
		{
			const double u = known.drawing.magnification * record.uv[2 * k];
			const double v = known.drawing.magnification * record.uv[2 * k + 1];
			corners.push_back(sheet.origin + u * sheet.xAxis() + v * sheet.up);
		}
		if (corners.empty())
			continue;
		addPolygon(made.mesh, corners);
		made.vertex_values.resize(made.mesh.positions.size());
		const auto polygon = made.mesh.polygon(made.mesh.polygons() - 1);
		for (std::size_t k = 0; k < polygon.size(); ++k)
			made.vertex_values[polygon[k]] = record.value[k];
	}
	made.drawing.opacity = known.drawing.opacity;
	made.drawing.lit = false;
	made.drawing.values = kScale;
	return made;
}

KnownSurface randomBlob(std::mt19937& random)
{
	constexpr int kAround = 24;
	constexpr int kDown = 12;
	const double bulge = uniform(random, 0.1, 0.35);
	const double bumps = 2.0 + random() % 3;
	const Vec3 center(uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4));
	const auto at = [&](int i, int j)
	{
		const double longitude = 2.0 * std::numbers::pi * (i % kAround) / kAround;
		const double latitude = std::numbers::pi * (static_cast<double>(j) / kDown - 0.5);
		const double radius = 0.9 * (1.0 + bulge * std::sin(bumps * longitude) * std::cos(3.0 * latitude));
		return center + radius * Vec3(std::cos(latitude) * std::cos(longitude),
		                              std::cos(latitude) * std::sin(longitude), std::sin(latitude));
	};
	KnownSurface made;
	for (int j = 0; j < kDown; ++j)
		for (int i = 0; i < kAround; ++i)
		{
			if (j > 0)
				addPolygon(made.mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
			if (j + 1 < kDown)
				addPolygon(made.mesh, {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
		}
	const double turn = uniform(random, 0.0, 6.0);
	for (const Vec3& p : made.mesh.positions)
		made.vertex_values.push_back(0.5 + 0.4 * std::sin(2.0 * p.x - 1.5 * p.y + p.z + turn));
	if (random() % 2 == 0)
	{
		made.vertex_values.clear();
		for (std::size_t p = 0; p < made.mesh.polygons(); ++p)
			made.polygon_values.push_back(uniform(random, 0.0, 1.0));
	}
	made.drawing.opacity = random() % 4 == 0 ? 1.0 : uniform(random, 0.1, 0.9);
	made.drawing.lit = false;
	made.drawing.values = kScale;
	return made;
}

Surface onDevice(gpu::Device& device, const KnownSurface& known)
{
	auto polygons = surfacePolygons(device, known.mesh, {known.vertex_values, known.polygon_values});
	EXPECT_TRUE(polygons);
	Surface surface = known.drawing;
	surface.polygons = *polygons;
	return surface;
}

} // namespace vp::render::test
