#include "render/passes/surface_triangles.h"

#include "mesh/bridges.h"
#include "mesh/host_records.h"
#include "mesh/polygon_fans.h"
#include "render/passes/corner_normals.h"
#include "render/passes/values_across.h"
#include "render/scene/sheet_contours.h"

#include <glm/packing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::SurfaceTriangle) == 16 * shared::kSurfaceTexels);

constexpr std::uint32_t kNotHere = 0xFFFFFFFFu;

// Meyer et al., "On Floating-Point Normal Vectors" (2010).
std::uint32_t octahedral(const Vec3f& n)
{
	const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
	if (!(sum > 0.0f))
		return 0;
	glm::vec2 p(n.x / sum, n.y / sum);
	if (n.z < 0.0f)
		p = {(1.0f - std::abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f),
		     (1.0f - std::abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f)};
	return glm::packSnorm2x16(p);
}

// 4 area / perimeter: a square's side.
double width(double double_area, std::span<const Vec3> corners)
{
	double around = 0.0;
	for (std::size_t i = 0; i < corners.size(); ++i)
		around += glm::length(corners[(i + 1) % corners.size()] - corners[i]);
	return around > 0.0 ? 2.0 * double_area / around : 0.0;
}

class TriangleMaker
{
public:
	TriangleMaker(const mesh::SheetMesh& mesh, const SurfaceValues& values, const Vec3& origin, std::size_t most_texels)
	    : mesh_(mesh), values_(values), origin_(origin), most_texels_(most_texels), normals_(cornerNormals(mesh)),
	      across_(values.of_polygons.empty() ? std::vector<double>() : valuesAcross(mesh, values.of_polygons)),
	      here_(mesh.positions.size(), kNotHere)
	{
	}

	std::vector<SurfacePart> make(std::size_t polygons)
	{
		for (std::size_t p = 0; p < polygons; ++p)
			addPolygon(p);
		return std::move(parts_);
	}

private:
	void addPolygon(std::size_t p)
	{
		const auto polygon = mesh_.polygon(p);
		if (polygon.size() < 3)
			return;
		takePartFor(polygon.size());
		corners_.clear();
		for (const std::uint32_t v : polygon)
			corners_.push_back(mesh_.positions[v]);
		const Vec3 area = mesh::doubleArea(mesh_, polygon);
		const double polygon_width = width(glm::length(area), corners_);
		flatten(area);
		bridges_ = mesh::hiddenSidesOf(mesh_, p);
		if (!mesh::isFan(places_))
		{
			for (const std::vector<std::uint32_t>& fan : mesh::cutIntoFans(places_))
				addFan(p, fan, polygon_width);
			return;
		}
		whole_.resize(polygon.size());
		std::iota(whole_.begin(), whole_.end(), 0u);
		addFan(p, whole_, polygon_width);
	}

	// `fan`: corner numbers.
	void addFan(std::size_t p, std::span<const std::uint32_t> fan, double polygon_width)
	{
		for (std::size_t i = 1; i + 1 < fan.size(); ++i)
			addTriangle(p, {fan[0], fan[i], fan[i + 1]}, polygon_width);
	}

	// The corners' places in the polygon's mean plane.
	void flatten(const Vec3& area)
	{
		const double length = glm::length(area);
		const Vec3 normal = length > 0.0 ? area / length : Vec3(0.0, 0.0, 1.0);
		const Vec3 x_axis =
		    glm::normalize(glm::cross(std::abs(normal.x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0), normal));
		const Vec3 y_axis = glm::cross(normal, x_axis);
		places_.clear();
		for (const Vec3& corner : corners_)
			places_.emplace_back(glm::dot(corner - corners_[0], x_axis), glm::dot(corner - corners_[0], y_axis));
	}

	void addTriangle(std::size_t p, const std::array<std::uint32_t, 3>& of_polygon, double polygon_width)
	{
		const auto polygon = mesh_.polygon(p);
		const auto corners = static_cast<std::uint32_t>(polygon.size());
		const std::uint32_t start = mesh_.polygon_starts[p];
		shared::SurfaceTriangle triangle{};
		glm::vec4 across(polygonValue(p), polygonValue(p), polygonValue(p), 0.0f);
		std::array<Vec3, 3> places;
		for (int k = 0; k < 3; ++k)
		{
			const std::uint32_t corner = of_polygon[k];
			const std::uint32_t next = of_polygon[(k + 1) % 3];
			const bool is_edge = (next == (corner + 1) % corners && !isHidden(start, corner)) ||
			                     (corner == (next + 1) % corners && !isHidden(start, next));
			triangle.corners[k] = vertexHere(polygon[corner]) | (is_edge ? 0u : shared::kHiddenEdge);
			triangle.normals[k] = octahedral(normals_[start + corner]);
			if (is_edge && !across_.empty())
				across[k] = mesh::drawnValue(across_[start + (next == (corner + 1) % corners ? corner : next)]);
			places[k] = corners_[corner];
		}
		triangle.value = polygonValue(p);
		const double own = width(glm::length(glm::cross(places[1] - places[0], places[2] - places[0])), places);
		triangle.width = own > 0.0 ? static_cast<float>(polygon_width / own) : 1.0f;
		if (values_.part_edges)
			triangle.width *= values_.part_edges->widthOf(p);
		parts_.back().triangles.push_back(triangle);
		if (!across_.empty())
			parts_.back().across.push_back(across);
	}

	bool isHidden(std::uint32_t start, std::uint32_t corner) const
	{
		return (!bridges_.empty() && bridges_[corner]) ||
		       (values_.part_edges && values_.part_edges->isInner(start + corner));
	}

	float polygonValue(std::size_t p) const
	{
		if (!values_.of_polygons.empty())
			return mesh::drawnValue(values_.of_polygons[p]);
		if (values_.at_vertices.empty())
			return 0.0f;
		switch (interpolated(mesh_.polygon(p), values_.at_vertices))
		{
		case Interpolated::minus_infinity:
			return -shared::kInfiniteValue;
		case Interpolated::plus_infinity:
			return shared::kInfiniteValue;
		case Interpolated::nothing:
			return shared::kNanValue;
		default:
			return 0.0f;
		}
	}

	std::uint32_t vertexHere(std::uint32_t v)
	{
		if (here_[v] == kNotHere)
		{
			std::vector<glm::vec4>& vertices = parts_.back().vertices;
			here_[v] = static_cast<std::uint32_t>(vertices.size());
			named_.push_back(v);
			const float value = values_.at_vertices.empty() ? 0.0f : mesh::drawnValue(values_.at_vertices[v]);
			vertices.emplace_back(Vec3f(mesh_.positions[v] - origin_), value);
		}
		return here_[v];
	}

	// One with room for a polygon of so many corners.
	void takePartFor(std::size_t corners)
	{
		const auto full = [&](const SurfacePart& part)
		{
			return (part.triangles.size() + corners) * shared::kSurfaceTexels > most_texels_ ||
			       part.vertices.size() + corners > most_texels_;
		};
		if (!parts_.empty() && (parts_.back().triangles.empty() || !full(parts_.back())))
			return;
		parts_.emplace_back();
		for (const std::uint32_t v : named_)
			here_[v] = kNotHere;
		named_.clear();
	}

	const mesh::SheetMesh& mesh_;
	const SurfaceValues& values_;
	Vec3 origin_;
	std::size_t most_texels_;
	std::vector<Vec3f> normals_;
	std::vector<double> across_;      // value at each entry of polygon_vertices
	std::vector<std::uint32_t> here_; // per vertex of the mesh: its number in the last part
	std::vector<std::uint32_t> named_;
	std::vector<SurfacePart> parts_;
	std::vector<Vec3> corners_; // corners of the current polygon
	std::vector<glm::dvec2> places_;
	std::vector<std::uint8_t> bridges_;
	std::vector<std::uint32_t> whole_;
};

} // namespace

std::vector<SurfacePart> surfaceTriangles(const mesh::SheetMesh& mesh, const SurfaceValues& values, const Vec3& origin,
                                          std::size_t most_texels, std::size_t polygons_elsewhere)
{
	return TriangleMaker(mesh, values, origin, most_texels).make(mesh.polygons() - polygons_elsewhere);
}

} // namespace vp::render
