#pragma once

#include "base/raw_vector.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "mesh/part_edges.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"
#include "shared/slice_types.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace vp::mesh
{

// A value as shaders take it: NaN has a mark of its own, infinities come to less than the marks.
float drawnValue(double value);

// In a sheet's frame; nothing where lo is above hi.
struct UvBounds
{
	glm::dvec2 lo{std::numeric_limits<double>::infinity()};
	glm::dvec2 hi{-std::numeric_limits<double>::infinity()};

	UvBounds with(const glm::dvec2& place) const { return {glm::min(lo, place), glm::max(hi, place)}; }
	UvBounds with(const UvBounds& other) const { return {glm::min(lo, other.lo), glm::max(hi, other.hi)}; }
};

// The polygons of a mesh as they are drawn: a record is a fan of triangles about its first vertex. A polygon of more
// than six vertices becomes several records, cut along diagonals from its first vertex; a concave one is parted
// into fans that cover it and nothing else (polygon_fans.h). Records lie in the order of their polygons. They are
// counted first, then written to wherever they are to be, on all cores. The mesh outlives it. Edges of `part_edges` are
// not drawn.
class MeshRecords
{
public:
	// With a field's values; all of them 0 without one.
	MeshRecords(const grid::BlockSet& blocks, const probe::Sheet& sheet, const SheetMesh& mesh,
	            const std::optional<grid::FieldChoice>& field, PartEdges part_edges = {});
	// With a value for each polygon of the mesh, NaN where there is none.
	MeshRecords(const probe::Sheet& sheet, const SheetMesh& mesh, std::span<const double> polygon_values,
	            PartEdges part_edges = {});

	std::size_t count() const { return chunk_starts_.back(); }
	const UvBounds& bounds() const { return bounds_; }
	// Returns the greatest distance between two opposite corners of a polygon's bounds.
	double longest() const { return longest_; }
	// Numbers of the records with which those of another block begin than the one before had.
	const std::vector<std::size_t>& parts() const { return parts_; }
	// Those from `first` on, to uninitialized memory.
	void write(std::size_t first, std::span<shared::PolygonRecord> to) const;

private:
	void takePlaces(const probe::Sheet& sheet);
	bool hasInnerSide(std::size_t polygon) const;
	void countRecords();
	std::size_t recordsOf(std::size_t polygon, std::vector<glm::dvec2>& places);
	void findParts();
	template <class Emit>
	void writePolygon(std::size_t polygon, std::vector<glm::dvec2>& places, Emit&& emit) const;

	const SheetMesh& mesh_;
	PartEdges part_edges_;
	RawVector<glm::dvec2> places_; // places of the vertices in the sheet's frame
	UvBounds bounds_;
	double longest_ = 0.0;
	RawVector<float> values_;        // values of the vertices or of the polygons
	bool of_vertices_ = false;       // true if the values belong to vertices
	RawVector<std::uint8_t> is_one_; // per polygon: 1 if its corners, in their order, are one record
	std::vector<std::size_t> parts_;
	std::vector<std::size_t> chunk_starts_; // records before each chunk of polygons, and all
};

} // namespace vp::mesh
