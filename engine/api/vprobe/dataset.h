#pragma once

#include <vprobe/arrays.h>
#include <vprobe/cut.h>
#include <vprobe/image.h>
#include <vprobe/result.h>
#include <vprobe/view.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vprobe
{

/// Points at origin + (i, j, k) * spacing; i runs fastest.
struct Image3
{
	std::array<std::size_t, 3> points; // along x, y and z, 2 or more each
	Vector3 origin{0.0, 0.0, 0.0};
	Vector3 spacing{1.0, 1.0, 1.0}; // not zero
};

/// Points at (x[i], y[j], z[k]): float64, 2 or more each, all rising or all falling.
struct Rectilinear
{
	Numbers x, y, z;
};

/// Points anywhere in lattice order: float32 or float64, x y z of the first point first, i runs fastest. The library
/// turns the axes of some curvilinear grids to make cuts faster. Then it copies the points.
struct Structured
{
	std::array<std::size_t, 3> points; // along i, j and k, 2 or more each
	Numbers coordinates;
};

/// Cells of VTK's types and in VTK's order of points. Points and cells are copied when something needs neighbors: a
/// second cut, a contour, particles. Polyhedra have their faces in a stream, as VTK's.
struct Unstructured
{
	Numbers coordinates;  // float32 or float64, x y z of the first point first
	Numbers types;        // uint8, a cell each: VTK's numbers
	Numbers offsets;      // int32 or int64, cells + 1 into the connectivity; int32 is copied
	Numbers connectivity; // int32 or int64 ids of points
	Numbers face_offsets; // int64, cells + 1 into the stream of faces; empty if there are no polyhedra
	Numbers face_stream;  // int64: per polyhedron its number of faces, then per face its size and points
	/// Curved cells need one: the tolerance, between 0 and 1, to which cuts refine the cells that they meet. Nodes are
	/// in VTK's order since 9.1. Lagrange and Bezier cells have the same degree along all axes unless there is a cell
	/// array "HigherOrderDegrees" of three components; a point array "RationalWeights" makes Bezier cells rational.
	/// Their nodes are shared and never copied, and cells of linear types may stand among them, polyhedra apart.
	double tolerance = 0.0;
	/// If all cells have one linear type, only the first cut checks that their ids name points. A wrong id is then an
	/// error of that cut.
	bool checks_ids_later = false;
};

/// A grid of the caller's with its arrays.
struct Block
{
	std::variant<Image3, Rectilinear, Structured, Unstructured> grid;
	std::vector<Field> fields{};
	std::string name{};
	std::string length_units{};
};

/// The arrays of a block that a data set holds. Shared arrays are the caller's. They stay valid as long as their owners
/// do.
struct HeldBlock
{
	std::string name;
	std::vector<Numbers> coordinates; // points; the axes x, y and z of a rectilinear grid; empty for an image
	Numbers connectivity;             // only for an unstructured grid that has no neighbors yet
	std::vector<Field> fields;
	std::size_t points = 0; // that a point array has values for, and a cell array
	std::size_t cells = 0;
};

/// Bytes that a data set holds.
struct MemoryUse
{
	std::size_t geometry = 0; // coordinates and cells; shared with the caller if they were wrapped and not copied
	std::size_t arrays = 0;   // arrays; always shared with the caller if they were wrapped
	std::size_t built = 0;    // structures that find cells: neighbors, boundary, seams, trees
	std::size_t cutter = 0;   // marks and rows that cuts share
	std::size_t device = 0;   // bytes in device memory
	bool copied = false;      // true if the library has copied points and cells of unstructured grids
};

/// Says where cells are classified.
enum class Classify : std::uint8_t
{
	automatic, // on the CPU, unless there is a hardware device
	gpu,
	cpu
};

/// Says how files are read.
struct OpenOptions
{
	std::string time = "last"; // last, first, a time (the nearest there is), or #INDEX
	std::string solution{};    // PLOT3D solution file, if its name does not follow from the grid's name
	// Curved cells: how often their linear parts are halved, 0 to 6; or, between 0 and 1, a tolerance to which cuts
	// refine the cells that they meet (docs/FORMATS.md)
	double refine = 0.0;
	std::optional<double> displace{}; // points move by their displacements, times this; empty: 0, or 1 with an array
	std::string displace_by{};        // the point array of displacements; empty: the one whose name says so
	std::string format{};             // a name that vprobe info --formats lists; empty: the file tells
	Classify classify = Classify::automatic;
	std::string device{};   // for classifying and drawing: a part of its name, or its number; empty: the best one
	std::stop_token stop{}; // on a stop request, reading ends with ErrorKind::cancelled
	// Several files: "blocks" (together one data set), "times" (each is a time of a series), or "auto" (times if their
	// names differ by a number alone and their grids are the same)
	std::string inputs = "auto";
	// Arrays of cells become arrays of points: each point has the mean of its cells, without NaN and hidden cells
	bool cell_to_point = false;
	// Files may name others in their own folder. These are further folders for that, or "anywhere"; give them for data
	// that you trust
	std::vector<std::string> follow{};
	int level = 0; // which of several resolutions of an image (OME-Zarr), 0 the finest
	// The cells of a pack (`vprobe pack`, docs/LARGE.md) stay in its file, and cuts read those that they meet. Then
	// call readAll() before block().
	bool keeps_parts = false;
};

/// Values of arrays at points.
struct Samples
{
	std::vector<std::int64_t> cells;  // per point: its cell, as the input numbers it; -1 outside the grid
	std::vector<std::int32_t> blocks; // per point: the block of that cell; -1 outside
	struct Column
	{
		ArrayInfo array;
		std::vector<double> values; // points x components; NaN outside
	};
	std::vector<Column> columns;
};

/// How one sheet is cut in one block.
struct PlanRow
{
	std::size_t sheet = 0;
	std::size_t block = 0;
	std::string strategy;   // rows, spans, cells, generations, listed, scan
	std::string classifier; // cpu, gpu
	std::string reason;
};

/// A frame of a sweep.
struct SweepFrame
{
	int index = 0;
	int count = 0;
	std::optional<double> time{}; // time of the values, in a sweep through the times
	Cut cut;
	Image image; // empty if no picture is drawn
};

struct DatasetState; // internal to the library

/// A data set: grids with arrays, and the structures that make cuts fast. Copies share it. It is thread safe: calls on
/// one data set wait for each other. A cut keeps the parts of its data set alive that it needs.
class VPROBE_API Dataset
{
public:
	/// Reads files in a child process (vprobe-read), or makes a built-in data set: demo:NAME[:N]. Several files make
	/// one data set of several blocks.
	static Result<Dataset> open(const std::vector<std::string>& files, const OpenOptions& options = {});
	static Result<Dataset> open(const std::string& file, const OpenOptions& options = {});

	/// Shares the caller's arrays. Field arrays are never copied. Points of rectilinear and curvilinear grids are not
	/// copied either, except as CurvilinearGrid says. An input error says what does not fit: a size, an id, a type.
	static Result<Dataset> wrap(std::vector<Block> blocks, Classify classify = Classify::automatic,
	                            const std::string& device = {}, std::stop_token stop = {});

	const char* kind() const; // image, rectilinear, curvilinear, unstructured, block-structured, hybrid
	std::size_t cellCount() const;
	std::size_t pointCount() const;
	std::size_t blockCount() const;
	std::pair<Vector3, Vector3> bounds() const; // low and high corner
	std::vector<double> times() const;          // times in the files, ascending
	std::vector<ArrayInfo> arrays() const;
	/// Reads what OpenOptions::keeps_parts has left in the file. On a stop request, reading ends with
	/// ErrorKind::cancelled.
	Status readAll(std::stop_token stop = {}) const;
	/// index < blockCount().
	HeldBlock block(std::size_t index) const;
	MemoryUse memory() const;

	/// Call it after you changed values of wrapped arrays in place. Earlier cuts may show old or new values.
	void modified();
	/// Replaces the arrays of a wrapped data set, with a list for each block. The grid stays, and so do the structures
	/// that find its cells. Earlier cuts keep their arrays.
	Status setFields(std::vector<std::vector<Field>> fields);
	/// Adds an array, or replaces the one of its name: a field for each block, all with one name and association. It
	/// stays the same at all times of the input. Earlier cuts keep their arrays.
	Status setArray(std::vector<Field> of_each_block);

	/// For all calls below: on a stop request a call ends soon with ErrorKind::cancelled. The data set stays usable.
	Result<Cut> cut(const View& view, std::stop_token stop = {}) const;
	/// Returns how cut() would work, and why.
	Result<std::vector<PlanRow>> plan(const View& view) const;
	/// Returns the probe, placed in this data set, as the JSON of a probe file (docs/PROBES.md).
	Result<std::string> probeText(const View& view) const;
	/// Interpolates arrays at points, as docs/SAMPLING.md says. arrays: "[point:|cell:]NAME"; if there are none, takes
	/// all.
	Result<Samples> sample(std::span<const Vector3> points, const std::vector<std::string>& arrays = {},
	                       std::stop_token stop = {}) const;

	/// Draws a cut of this data set. If the View now asks for a different cut, it cuts again. The first call opens a
	/// Vulkan device.
	Result<Image> render(const Cut& cut, const View& view, std::stop_token stop = {}) const;
	Result<Image> render(const View& view, std::stop_token stop = {}) const;

	/// Cuts frame by frame along the View's path, and draws where `draws`. on_frame returns false to stop early, which
	/// is no error. With the path `times` the probe stands still, and each frame has the values of one time of the
	/// files.
	Status sweep(const View& view, const std::function<bool(const SweepFrame&)>& on_frame, bool draws = false,
	             std::stop_token stop = {}) const;
	/// Makes one frame of that sweep. The first frame is 0; SweepFrame::count is the number of frames. A higher index
	/// is a usage error.
	Result<SweepFrame> frame(const View& view, int index, bool draws = false, std::stop_token stop = {}) const;

private:
	friend DatasetState& stateOf(const Dataset& data);
	explicit Dataset(std::shared_ptr<DatasetState> state) : state_(std::move(state)) {}

	std::shared_ptr<DatasetState> state_;
};

} // namespace vprobe
