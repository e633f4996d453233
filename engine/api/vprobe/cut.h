#pragma once

#include <vprobe/arrays.h>
#include <vprobe/result.h>
#include <vprobe/view.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vprobe
{

/// Values of one array at the points or on the polygons of a mesh. The bytes live as long as the Cut or a copy of it.
struct VPROBE_API MeshArray : ArrayInfo
{
	const void* data = nullptr;
	std::size_t tuples = 0;

	double value(std::size_t tuple, int component = 0) const;
};

/// Polygons with shared points. Spans live as long as the Cut or a copy of it. A value: cheap to copy.
class VPROBE_API Mesh
{
public:
	std::size_t pointCount() const;
	std::size_t polygonCount() const;
	std::span<const double> points() const;             // x y z of the first point first
	std::span<const std::int64_t> offsets() const;      // polygons + 1, into the connectivity
	std::span<const std::int64_t> connectivity() const; // ids of points; counter-clockwise seen from the normal's side
	std::span<const std::int64_t> cells() const;        // per polygon: the cell, as the input numbers it
	std::span<const std::int32_t> blocks() const;       // per polygon: the block
	/// Every array of the data set, interpolated to the points or taken from the cells. Built when it is asked for
	/// first; thread safe.
	std::span<const MeshArray> arrays() const;
	/// Null where there is none of that name.
	const MeshArray* array(std::string_view name) const;

	struct State;

private:
	friend class Cut;
	explicit Mesh(std::shared_ptr<const State> state) : state_(std::move(state)) {}

	std::shared_ptr<const State> state_;
};

/// Figures that describe what a sheet shows.
struct Figures
{
	double area = 0.0;
	double boundary_area = 0.0;          // area of boundary faces in the plane; the other figures leave them out
	double nan_area = 0.0;               // area in which the value is not finite
	std::optional<double> mean;          // area-weighted
	std::optional<double> boundary_mean; // the same over the boundary faces in the plane
	std::optional<double> min;
	std::optional<double> max;
	std::optional<double> flux;          // flux of vectors through the sheet
	std::optional<double> boundary_flux; // the same through the boundary faces in the plane
	std::size_t components = 0;          // pieces that do not touch
	std::size_t cut_cells = 0;
};

/// Paths of particles that were launched from a sheet, each from its earliest point to its latest.
struct Traces
{
	std::vector<std::int64_t> offsets; // traces + 1, into the points
	std::vector<double> points;        // x y z
	std::vector<double> times;         // per point, from the launch; negative before it
};

/// The cut of a probe through a data set. Copies share it; it stays valid whatever becomes of its Dataset. Thread safe.
class VPROBE_API Cut
{
public:
	Cut(); // no sheets

	std::size_t sheetCount() const;
	/// sheet < sheetCount(). The polygons of a sheet; with `crinkle` the faces of the cells that are cut.
	Mesh mesh(std::size_t sheet) const;
	/// Returns the sheet's figures. The first call measures them.
	Figures figures(std::size_t sheet) const;
	/// Returns where the sheet stands.
	Vector3 origin(std::size_t sheet) const;
	Vector3 normal(std::size_t sheet) const;
	/// Returns the traces of particles launched from the sheet; empty if none were launched.
	Traces traces(std::size_t sheet) const;

	/// Surfaces that grew from the sheets.
	std::size_t contourCount() const;
	double contourValue(std::size_t contour) const;
	Mesh contour(std::size_t contour) const;

	/// As .vtp, .vtm, .pvtp, .ply or .csv, by the name's ending, with every array. Whole or not at all.
	Status save(const std::string& file) const;

	struct State;

private:
	friend struct DatasetState;
	explicit Cut(std::shared_ptr<const State> state) : state_(std::move(state)) {}

	std::shared_ptr<const State> state_;
};

} // namespace vprobe
