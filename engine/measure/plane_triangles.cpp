#include "measure/plane_triangles.h"

#include "base/cross2.h"
#include "mesh/own_polygons.h"
#include "mesh/polygon_fans.h"
#include "mesh/seam_names.h"

#include <cmath>

namespace vp::measure
{

namespace
{

class Triangulation
{
public:
	explicit Triangulation(PlaneTriangles& result) : result_(result) {}

	// own: the corners whose mean is the center.
	void add(std::span<const std::uint32_t> polygon, std::span<const std::uint32_t> own)
	{
		glm::dvec2 center(0.0);
		double value = 0.0;
		for (const std::uint32_t v : own)
		{
			center += result_.points[v];
			value += result_.values[v];
		}
		center /= double(own.size());
		value /= double(own.size());
		std::vector<PlaneTriangle>& triangles = std::isnan(value) ? result_.nan_triangles : result_.triangles;
		if (polygon.size() == 3)
			triangles.push_back({polygon[0], polygon[1], polygon[2]});
		else if (seesAll(center, polygon))
			addAboutCenter(center, value, polygon, triangles);
		else
			addFans(polygon, triangles);
	}

private:
	bool seesAll(const glm::dvec2& center, std::span<const std::uint32_t> polygon) const
	{
		for (std::size_t i = 0; i < polygon.size(); ++i)
		{
			const glm::dvec2 a = result_.points[polygon[i]] - center;
			const glm::dvec2 b = result_.points[polygon[(i + 1) % polygon.size()]] - center;
			if (cross(a, b) < -1e-9 * glm::length(a) * glm::length(b))
				return false;
		}
		return true;
	}

	void addAboutCenter(const glm::dvec2& center, double value, std::span<const std::uint32_t> polygon,
	                    std::vector<PlaneTriangle>& triangles)
	{
		const auto c = static_cast<std::uint32_t>(result_.points.size());
		result_.points.push_back(center);
		result_.values.push_back(value);
		for (std::size_t i = 0; i < polygon.size(); ++i)
			triangles.push_back({c, polygon[i], polygon[(i + 1) % polygon.size()]});
	}

	void addFans(std::span<const std::uint32_t> polygon, std::vector<PlaneTriangle>& triangles)
	{
		places_.clear();
		for (const std::uint32_t v : polygon)
			places_.push_back(result_.points[v]);
		for (const std::vector<std::uint32_t>& fan : mesh::cutIntoFans(places_))
			for (std::size_t i = 1; i + 1 < fan.size(); ++i)
				triangles.push_back({polygon[fan[0]], polygon[fan[i]], polygon[fan[i + 1]]});
	}

	PlaneTriangles& result_;
	std::vector<glm::dvec2> places_;
};

// So that lines go on across a seam where these values do not jump.
void nameAcrossSeams(const mesh::SeamNames& names, PlaneTriangles& result)
{
	for (PlaneTriangle& triangle : result.triangles)
		for (std::uint32_t& v : triangle)
			if (v < result.vertices)
				v = names[v];
	std::erase_if(result.triangles,
	              [](const PlaneTriangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

} // namespace

glm::dvec2 planePoint(const Vec3& position, const probe::Frame& frame)
{
	const Vec3 arm = position - frame.origin;
	return {glm::dot(arm, frame.xAxis()), glm::dot(arm, frame.up)};
}

std::vector<glm::dvec2> planePoints(const mesh::SheetMesh& mesh, const probe::Frame& frame)
{
	std::vector<glm::dvec2> points;
	points.reserve(mesh.positions.size());
	for (const Vec3& position : mesh.positions)
		points.push_back(planePoint(position, frame));
	return points;
}

PlaneTriangles planeTriangles(const mesh::SheetMesh& mesh, const probe::Frame& frame, std::span<const double> values)
{
	PlaneTriangles result;
	result.points = planePoints(mesh, frame);
	result.values.assign(values.begin(), values.end());
	result.vertices = mesh.positions.size();
	Triangulation triangulation(result);
	const mesh::OwnPolygons own(mesh);
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		triangulation.add(mesh.polygon(p), own[p]);
	const mesh::SeamNames names(mesh, [&](std::uint32_t v, std::uint32_t w) { return values[v] == values[w]; });
	if (!names.areVertices())
		nameAcrossSeams(names, result);
	return result;
}

} // namespace vp::measure
