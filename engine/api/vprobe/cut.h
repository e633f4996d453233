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

/// The values of one array at the points or on the polygons of a mesh. The bytes stay valid as long as the Cut or a
/// copy of it lives.
struct VPROBE_API MeshArray : ArrayInfo
{
	const void* data = nullptr;
	std::size_t tuples = 0;

	double value(std::size_t tuple, int component = 0) const;
};

/// Polygons with shared points. Spans stay valid as long as the Cut or a copy of it lives. A Mesh is cheap to copy.
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
	/// Returns every array of the data set, interpolated to the points or taken from the cells. The first call builds
	/// it. It is thread safe.
	std::span<const MeshArray> arrays() const;
	/// Returns null if there is no array of that name.
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
	std::optional<double> mean;          // weighted by area
	std::optional<double> boundary_mean; // the same over the boundary faces in the plane
	std::optional<double> min;
	std::optional<double> max;
	std::optional<double> flux;          // flux of vectors through the sheet
	std::optional<double> boundary_flux; // the same through the boundary faces in the plane
	std::size_t components = 0;          // number of pieces that do not touch
	std::size_t cut_cells = 0;
};

/// Paths of particles that were launched from a sheet, each from its earliest point to its latest.
struct Traces
{
	std::vector<std::int64_t> offsets; // traces + 1, into the points
	std::vector<double> points;        // x y z
	std::vector<double> times;         // per point, from the launch; negative before it
};

/// Polygons of a caller's with arrays over their points and over the polygons (Association::cell).
struct OwnPolygons
{
	Numbers points;       // float64, x y z of the first point first
	Numbers offsets;      // int64, polygons + 1 into the connectivity
	Numbers connectivity; // int64 ids of points
	Numbers cells;        // int64, per polygon: the cell of the input that it was cut from
	Numbers blocks;       // int32, per polygon: the block of that cell
	std::vector<Field> fields{};
};

/// The cut of a probe through a data set. Copies share it. It stays valid even after its Dataset is gone. It is thread
/// safe.
class VPROBE_API Cut
{
public:
	Cut(); // no sheets

	std::size_t sheetCount() const;
	/// Returns the polygons of a sheet, or the faces of the cut cells if `crinkle` is set. sheet < sheetCount().
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

	/// Returns one sheet of this cut with polygons and arrays of the caller's, which are copied. save() writes them,
	/// and Dataset::render() draws them. view: of the sheet alone. An input error says what does not fit.
	Result<Cut> withOwn(std::size_t sheet, const View& view, const OwnPolygons& own) const;

	/// Writes the cut with every array as .vtp, .vtm, .pvtp, .ply or .csv, by the name's ending. If it fails, no file
	/// is left.
	Status save(const std::string& file) const;

	struct State;

private:
	friend struct DatasetState;
	friend class Dataset;
	explicit Cut(std::shared_ptr<const State> state) : state_(std::move(state)) {}

	std::shared_ptr<const State> state_;
};

} // namespace vprobe
