#pragma once

#include "base/exact_sum.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "measure/finite_fields.h"
#include "mesh/sheet_mesh.h"

#include <limits>
#include <optional>

namespace vp::measure
{

// Figures that describe what a sheet shows. A polygon counts as the fan of triangles about the mean of its vertices;
// the mean has the mean of their values. In a concave polygon a triangle may run against the polygon. It counts as
// negative, so the sum is the polygon, and the integral of a linear field is exact. Boundary faces in the plane have an
// area and a mean of their own. Of the other figures only the range includes them. So the figures are the same on
// either side of a plane at which cells meet. Values of points that name categories are those of the nearest point
// (mesh/nearest_parts.h), so the mean is that of their areas (value_areas.h).
struct SheetMeasure
{
	double area = 0.0;
	double boundary_area = 0.0;          // area of the boundary faces in the plane
	std::optional<double> boundary_mean; // the mean over them, by the rules of the mean
	double nan_area = 0.0;               // area where the value is NaN or infinite; the other figures leave it out
	std::optional<double> mean;          // weighted by area; empty without an array or without area
	std::optional<double> min; // range of the values at the vertices (point arrays) or of the polygons (cell arrays)
	std::optional<double> max;
	std::size_t components = 0; // see components.h
};

// The sums over some polygons.
struct AreaSums
{
	ExactSum area;
	ExactSum nan_area;
	ExactSum value_area; // integral of the values over the area that is not NaN

	void add(const AreaSums& other);
	std::optional<double> mean() const; // empty without area
};

// The figures of a part of a sheet, which may be added to those of other parts. Sums are exact, so they do not depend
// on how a sheet is parted. A plain struct, which may be sent as bytes.
struct SheetSums
{
	AreaSums cut;      // the polygons of cells
	AreaSums boundary; // boundary faces in the plane
	double min = std::numeric_limits<double>::infinity();
	double max = -std::numeric_limits<double>::infinity();

	void add(const SheetSums& other);
};

SheetSums sumUp(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                const std::optional<grid::FieldChoice>& field);
// The measure of all parts together, but for its components. has_field: whether they show an array.
SheetMeasure measureOf(const SheetSums& sums, bool has_field);

// The nan_area of measure() alone: where all values are finite, as mostly, nothing else is looked at. known: what is
// known of the blocks' arrays from other meshes, so that not even values are; or null.
double nanArea(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const std::optional<grid::FieldChoice>& field,
               FiniteFields* known = nullptr);

SheetMeasure measure(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                     const std::optional<grid::FieldChoice>& field);

} // namespace vp::measure
