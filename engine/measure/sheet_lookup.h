#pragma once

#include "mesh/sheet_mesh.h"
#include "probe/transform.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vp::measure
{

// A place on a sheet: a polygon, and the place in one triangle of the polygon's fan about the mean of its vertices. The
// mean has the mean of their values, as in measure() (stats.h). A linear field is exact in any of the triangles.
struct SheetPlace
{
	std::uint32_t polygon;
	mesh::BlockCell cell;                // the block's own numbering; grid::Block knows those of the file
	std::array<std::uint32_t, 2> corner; // vertices of the mesh, in the order of the polygon
	std::array<double, 3> weight;        // weights of the corners and of the mean: 0 to 1, with the sum 1
	bool inside = true;                  // false: the place lies beside the polygon, by rounding
};

// Finds what lies at places of a sheet: polygons are listed in bins over its plane. Made in time linear in the mesh,
// holds at most kLookupBytes a polygon.
class SheetLookup
{
public:
	// content: the frame of what the mesh is the cut of (SheetCut::sheet). The mesh must outlive the lookup.
	SheetLookup(const mesh::SheetMesh& mesh, const probe::Frame& content);

	// uv: along the frame's x and y axes from its origin, in the grid's units. None where no polygon is; of those that
	// lie over each other the last, which is seen. A place on a side that two polygons share is in one of them.
	std::optional<SheetPlace> at(const glm::dvec2& uv) const;

	// vertex_values: one per vertex of the mesh. NaN where a vertex of the polygon is. Values of polygons need no
	// help: polygon_values[place.polygon].
	double value(const SheetPlace& place, std::span<const double> vertex_values) const;

	std::size_t bytes() const; // bytes of the lookup, without the mesh

private:
	using Bins = glm::uvec2;
	struct Rect
	{
		glm::dvec2 lo;
		glm::dvec2 hi;
	};

	std::vector<Rect> takeRects();
	Bins firstBins(std::span<const Rect> rects) const;
	void setBins(const Bins& bins);
	Bins binOf(const glm::dvec2& uv) const;
	std::size_t entries(std::span<const Rect> rects) const; // there would be with these bins
	void chooseBins(std::span<const Rect> rects);
	void fill(std::span<const Rect> rects);
	glm::dvec2 place(std::uint32_t vertex) const;
	bool holds(std::uint32_t polygon, const glm::dvec2& uv) const;
	std::optional<SheetPlace> inFan(std::uint32_t polygon, const glm::dvec2& uv) const;

	const mesh::SheetMesh* mesh_;
	probe::Frame frame_;
	Rect rect_; // bounds of the whole mesh
	Bins bins_{1, 1};
	glm::dvec2 per_length_{0.0};        // bins
	std::vector<std::uint32_t> starts_; // bins + 1 offsets into polygons_, rows along x
	std::vector<std::uint32_t> polygons_;
};

constexpr std::size_t kLookupBytes = 24;

} // namespace vp::measure
