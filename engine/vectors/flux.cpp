#include "vectors/flux.h"

#include "base/ordered_sum.h"
#include "grid/link/for_ranges.h"
#include "mesh/mesh_values.h"
#include "mesh/own_polygons.h"
#include "vectors/vector_array.h"

#include <cmath>
#include <limits>
#include <vector>

namespace vp::vectors
{

namespace
{

// The flow through one polygon.
struct PolygonFlux
{
	double through = 0.0;
	double nan_area = 0.0;

	void addTo(FluxSums& sums, bool in_boundary) const
	{
		(in_boundary ? sums.boundary : sums.through) += through;
		if (nan_area != 0.0 && !in_boundary)
			sums.nan_area += nan_area;
	}
	void addPart(const Vec3& area, const Vec3& vector)
	{
		const double part = glm::dot(vector, area);
		if (std::isfinite(part))
			through += part;
		else
			nan_area += glm::length(area);
	}
};

using Fields = std::vector<const grid::Field*>;

std::vector<Vec3> vertexVectors(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const Fields& fields)
{
	std::vector<Vec3> vectors(mesh.positions.size());
	grid::forRanges(vectors.size(),
	                [&](std::size_t v)
	                {
		                for (int c = 0; c < 3; ++c)
			                vectors[v][c] = mesh::vertexValue(blocks, mesh, v, fields, c);
	                });
	return vectors;
}

Vec3 polygonVector(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const Fields& fields, std::size_t polygon)
{
	const auto [b, cell] = mesh.polygon_cells[polygon];
	Vec3 vector(std::numeric_limits<double>::quiet_NaN());
	for (int c = 0; fields[b] && c < 3; ++c)
		vector[c] = mesh::cellValue(blocks.blocks[b], *fields[b], c, cell);
	return vector;
}

// The area of a triangle stands along the normal about which its polygon winds.
void addFan(const mesh::SheetMesh& mesh, std::span<const std::uint32_t> polygon, const std::vector<Vec3>& vectors,
            PolygonFlux& sum)
{
	Vec3 center(0.0);
	Vec3 mean(0.0);
	for (const std::uint32_t v : polygon)
	{
		center += mesh.positions[v] / static_cast<double>(polygon.size());
		mean += vectors[v] / static_cast<double>(polygon.size());
	}
	std::uint32_t previous = polygon.back();
	for (const std::uint32_t v : polygon)
	{
		const Vec3 area = 0.5 * glm::cross(mesh.positions[previous] - center, mesh.positions[v] - center);
		sum.addPart(area, (vectors[previous] + vectors[v] + mean) / 3.0);
		previous = v;
	}
}

} // namespace

void FluxSums::add(const FluxSums& other)
{
	through += other.through;
	boundary += other.boundary;
	nan_area += other.nan_area;
}

Flux fluxThrough(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const grid::FieldChoice& array)
{
	return fluxSums(blocks, mesh, array).flux();
}

FluxSums fluxSums(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const grid::FieldChoice& array)
{
	Fields fields = array.inEach(blocks);
	for (const grid::Field*& field : fields)
		if (field && field->components != kVectorComponents)
			field = nullptr;
	const bool on_points = array.association == grid::Association::point;
	const std::vector<Vec3> vectors = on_points ? vertexVectors(blocks, mesh, fields) : std::vector<Vec3>();
	const mesh::OwnPolygons own(mesh);
	const std::size_t of_cells = mesh.polygons() - mesh.boundary_polygons;
	return orderedSum<FluxSums>(mesh.polygons(),
	                            [&](FluxSums& sums, std::size_t p)
	                            {
		                            PolygonFlux flux;
		                            if (on_points)
			                            addFan(mesh, own[p], vectors, flux);
		                            else
			                            flux.addPart(0.5 * mesh::doubleArea(mesh, own[p]),
			                                         polygonVector(blocks, mesh, fields, p));
		                            flux.addTo(sums, p >= of_cells);
	                            });
}

} // namespace vp::vectors
