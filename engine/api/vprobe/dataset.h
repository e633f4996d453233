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

/// Points anywhere in lattice order: float32 or float64, x y z of the first point first, i runs fastest. Where the
/// library turns the axes, which some curvilinear grids gain from, points are copied.
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
	Numbers face_stream;  // int64: per polyhedron faces, then per face its size and its points
	/// Curved cells need one: the tolerance, between 0 and 1, to which cuts refine the cells that they meet. Nodes are
	/// in VTK's order since 9.1. Lagrange and Bezier cells have the same degree along all axes unless there is a cell
	/// array "HigherOrderDegrees" of three components; a point array "RationalWeights" makes Bezier cells rational.
	/// Their nodes are shared and never copied, and cells of linear types may stand among them, polyhedra apart.
	double tolerance = 0.0;
	/// Cells of one linear type: whether their ids name points is seen by the first cut, in passing, which then is an
	/// error.
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
};

/// Bytes that a data set holds.
struct MemoryUse
{
	std::size_t geometry = 0; // coordinates and cells; shared with the caller where they were wrapped and not copied
	std::size_t arrays = 0;   // always shared with the caller where they were wrapped
	std::size_t built = 0;    // what was built to find cells: neighbors, boundary, seams, trees
	std::size_t cutter = 0;   // marks and rows that cuts share
	std::size_t device = 0;   // in device memory
	bool copied = false;      // points and cells of unstructured grids are the library's own by now
};

/// Where cells are classified.
enum class Classify : std::uint8_t
{
	automatic, // where it is faster, which is the CPU unless there is a hardware device
	gpu,
	cpu
};

/// How files are read.
struct OpenOptions
{
	std::string time = "last"; // last, first, a time (the nearest there is), or #INDEX
	std::string solution{};    // PLOT3D solution file, where its name does not follow from the grid's
	// Curved cells: how often their linear parts are halved, 0 to 6; or, between 0 and 1, a tolerance to which cuts
	// refine the cells that they meet (docs/FORMATS.md)
	double refine = 0.0;
	double displace = 0.0; // points of Exodus files move by their displacements, times this
	std::string format{};  // a name that vprobe info --formats lists; empty: the file tells
	Classify classify = Classify::automatic;
	std::string device{};   // for classifying and drawing: a part of its name, or its number; empty: the best
	std::stop_token stop{}; // asked to stop, reading ends with ErrorKind::cancelled
};

/// Values of arrays at points.
struct Samples
{
	std::vector<std::int64_t> cells;  // per point: the cell that holds it, as the input numbers it; -1 outside the grid
	std::vector<std::int32_t> blocks; // and its block; -1 outside
	struct Column
	{
		ArrayInfo array;
		std::vector<double> values; // points x components; NaN outside
	};
	std::vector<Column> columns;
};

/// The way of one sheet in one block.
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
	Image image; // empty where none is drawn
};

struct DatasetState; // internal to the library

/// A data set: grids with arrays, and what makes cuts of them fast. Copies share it. Thread safe: calls on one data set
/// wait for each other. A cut keeps what it needs of its data set alive.
class VPROBE_API Dataset
{
public:
	/// Reads files in a child process (vprobe-read), or makes a built-in data set: demo:NAME[:N]. Several files make
	/// one data set of several blocks.
	static Result<Dataset> open(const std::vector<std::string>& files, const OpenOptions& options = {});
	static Result<Dataset> open(const std::string& file, const OpenOptions& options = {});

	/// Shares the caller's arrays. Field arrays are never copied, nor are points of images, rectilinear and curvilinear
	/// grids but for what is said there. An input error says what does not fit: a size, an id, a type.
	static Result<Dataset> wrap(std::vector<Block> blocks, Classify classify = Classify::automatic,
	                            const std::string& device = {}, std::stop_token stop = {});

	const char* kind() const; // image, rectilinear, curvilinear, unstructured, block-structured, hybrid
	std::size_t cellCount() const;
	std::size_t pointCount() const;
	std::size_t blockCount() const;
	std::pair<Vector3, Vector3> bounds() const; // low and high corner
	std::vector<double> times() const;          // that the files offer, ascending
	std::vector<ArrayInfo> arrays() const;
	/// index < blockCount().
	HeldBlock block(std::size_t index) const;
	MemoryUse memory() const;

	/// The caller has changed values of wrapped arrays in place. Cuts that were made before may show either.
	void modified();
	/// Other arrays for a wrapped data set, a list for each block. The grid and what was built to find its cells stay.
	/// Cuts that were made before keep the arrays that they had.
	Status setFields(std::vector<std::vector<Field>> fields);

	/// Here and below: asked to stop, a call ends soon, with ErrorKind::cancelled, and the data set serves on.
	Result<Cut> cut(const View& view, std::stop_token stop = {}) const;
	/// How cut() would go, and why.
	Result<std::vector<PlanRow>> plan(const View& view) const;
	/// The probe as it stands in this data set, as the JSON of a probe file (docs/PROBES.md).
	Result<std::string> probeText(const View& view) const;
	/// Interpolated as docs/SAMPLING.md says. arrays: "[point:|cell:]NAME"; none: all.
	Result<Samples> sample(std::span<const Vector3> points, const std::vector<std::string>& arrays = {},
	                       std::stop_token stop = {}) const;

	/// Draws a cut of this data set. Where the View would cut otherwise, it cuts anew. Opens a Vulkan device at first.
	Result<Image> render(const Cut& cut, const View& view, std::stop_token stop = {}) const;
	Result<Image> render(const View& view, std::stop_token stop = {}) const;

	/// Cuts frame by frame along the View's path, and draws where `draws`. on_frame returns false to stop early, which
	/// is no error. With the path `times` the probe stands still, and each frame has the values of one time of the
	/// files.
	Status sweep(const View& view, const std::function<bool(const SweepFrame&)>& on_frame, bool draws = false,
	             std::stop_token stop = {}) const;
	/// One frame of that sweep, from 0; the frame tells how many there are. A usage error past the last.
	Result<SweepFrame> frame(const View& view, int index, bool draws = false, std::stop_token stop = {}) const;

private:
	friend DatasetState& stateOf(const Dataset& data);
	explicit Dataset(std::shared_ptr<DatasetState> state) : state_(std::move(state)) {}

	std::shared_ptr<DatasetState> state_;
};

} // namespace vprobe
