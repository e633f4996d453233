#pragma once

#include "base/result.h"
#include "base/timeline.h"
#include "classify/gpu_break_even.h"
#include "cut/cutter.h"
#include "cut/integrity.h"
#include "gpu/device.h"
#include "grid/block.h"
#include "measure/finite_fields.h"
#include "ranks/ranks.h"
#include "read/read.h"
#include "render/renderer.h"
#include "session/categories.h"
#include "session/open_device.h"
#include "session/step_ahead.h"
#include "vectors/path_lines.h"
#include "view/resolve.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace vp::session
{

// A session is a data set, its settings, and what cuts it:
//
//     open()   validates the settings, reads the inputs, opens a device, resolves, makes a cutter
//     set()    changes the settings
//     goTo()   moves to another time of the inputs
//     frame()  plans, finds the cut cells, builds polygons, launches particles, measures, grows contours
//
// picture::Painter draws a frame, and write/ writes it.
//
// Every program makes its frames by frame(), so all of them find the same cells in the same way.
//
// Only one thread at a time may use a session. A thread may draw a frame while another makes the next one, unless
// changesBlocksFor() says that the blocks will change.

/// What launching particles needs besides the settings.
struct LaunchState
{
	double dt = 1.0;                                             // time of a step
	std::optional<vectors::StoredVectors> stored{};              // filled if particles move through the input's times
	double time = 0.0;                                           // the time of the values in the blocks
	std::optional<std::pair<grid::FieldChoice, double>> fastest; // the greatest length in the array of vectors
};

/// Says whether other cuts follow. This decides what is built for a cut.
enum class Expect
{
	one_cut,       // nothing that one cut does without
	first_of_many, // the neighbors of cells are not built for this cut if it does without them
	more           // everything is built, since it makes later cuts fast
};

/// The contents of a frame besides the polygons of its sheets.
struct Wants
{
	enum class Figures
	{
		none,
		for_picture, // what a picture needs
		all
	};
	Figures figures = Figures::all;
	bool contours = true; // those of the settings
	bool warns = true;    // of empty sheets and the like; false for one frame of many

	bool operator==(const Wants&) const = default;
};

struct Frame; // frame.h

/// A request for a frame by the settings of a session.
struct FrameRequest
{
	std::optional<probe::Frame> pose{}; // of the probe; nothing takes the one of the settings
	double done = 0.0;                  // place of a grid surface in its range, 0 to 1
	Wants wants{};
	Expect expect = Expect::one_cut;
	// A frame of the same session, or null. What has not changed since then is taken from it.
	std::shared_ptr<const Frame> last{};

	bool isPlacedAs(const FrameRequest& other) const { return pose == other.pose && done == other.done; }
};

/// How to open a session, besides the settings.
struct OpenOptions
{
	DeviceUse use = DeviceUse::classify;
	Expect expect = Expect::more; // of the first frame: what is built while the inputs are read
	bool reads_all_arrays = true; // read all arrays, not only those that are shown
	bool one_cut_a_time = false;  // each time of the inputs is cut once
	bool time_may_change = true;  // goTo() may be called: it keeps the grid if that is the same at the other time
	bool frames_alone = false;    // cells and values are looked at by frames alone; see readAllParts()
	Timeline::Keep keep = Timeline::Keep::totals;
	std::shared_ptr<gpu::Device> device{};      // an open device; null opens the device of the settings
	std::vector<std::string> follow{};          // for ReadOptions::follow
	std::stop_token stop{};                     // a stop request ends the opening with ErrorKind::cancelled
	ranks::Ranks ranks = ranks::Ranks::alone(); // the processes that hold the inputs together
};

/// A data set, its settings, and what cuts and draws it. The cutter refers to the blocks. The device serves the cutter
/// and the drawing.
class Session
{
public:
	/// Validates the settings, reads the inputs and prepares the rest. A caller writes nothing before this has
	/// succeeded.
	static Result<std::unique_ptr<Session>> open(view::ViewSpec spec, OpenOptions options);
	/// The same for blocks that the caller has. Nothing is read; the input in the settings is only a name.
	static Result<std::unique_ptr<Session>> of(grid::BlockSet blocks, view::ViewSpec spec, OpenOptions options);

	/// Takes other settings for the same blocks: all settings except those of input and machine. Reads what is left of
	/// the blocks in files if the settings look at more than the cells that are cut.
	Status set(view::ViewSpec spec);

	/// Moves to a time of the inputs. If only the values differ there, a frame with `last` keeps the cells that it
	/// found. If the grid differs, it is read and built again, and frames that were made before become invalid.
	Status goTo(const read::TimeChoice& time);

	/// Makes a frame. It builds the neighbors of cells first if needsNeighborsFor() says so. If nothing has changed
	/// since the last frame, it returns that one. All ranks call it together. A stop request ends it with
	/// ErrorKind::cancelled.
	Result<std::shared_ptr<const Frame>> frame(const FrameRequest& request, std::stop_token stop = {});

	/// Returns how frame() would find the cells. If the strategy of the settings is impossible, returns a usage error
	/// that names `strategy`. Without a request: how the cells of the last frame were found.
	Result<find::CutPlan> plan(const FrameRequest& request) const;
	Result<find::CutPlan> plan() const { return plan({.expect = expected_}); }

	/// Returns true if the blocks lack what frame() needs for a request. Then frame() builds it, cells may get other
	/// numbers, and frames that were made before become invalid.
	Result<bool> needsNeighborsFor(const FrameRequest& request) const;
	/// Returns true if frame() would change the blocks: by building neighbors, or by reading parts of them where others
	/// must go, or all. While it reads some more, other threads may draw what is there.
	Result<bool> changesBlocksFor(const FrameRequest& request) const;

	/// Sweeps planes through the blocks to find cells that no sound grid has.
	Result<cut::SweepFindings> findImpossibleCells() { return cut::sweepForImpossibleCases(*cutter_); }

	/// Reads what is left of the blocks in files (grid::lacksParts): with `frames_alone` a pack is read where frames
	/// meet it. A stop request ends it with ErrorKind::cancelled.
	Status readAllParts(const std::stop_token& stop = {});

	/// Builds what the blocks lack for further cuts (grid::isComplete), such as neighbors of cells, and a new cutter.
	/// Frames that were made before become invalid. A stop request ends it with ErrorKind::cancelled, and leaves all as
	/// it was.
	Status buildNeighbors(const std::stop_token& stop = {});
	/// Takes blocks like its own for which somebody else has built the neighbors, but keeps its own values.
	Status takeNeighbors(grid::BlockSet built);

	/// Takes other arrays for its blocks: fields[block]. The probe's settings become those of a new view.
	Status replaceFields(std::vector<std::vector<grid::Field>> fields);
	/// Adds an array, or replaces the one with its name and association: of_each[block].
	void setArray(const std::vector<grid::Field>& of_each);
	/// Call this when the values in the blocks have changed.
	void forgetValues();

	/// Opens a device to draw with, unless there is one.
	Status openDevice();
	/// Takes a device to draw and to classify with; null takes none. Frames that were made before become invalid.
	Status takeDevice(std::shared_ptr<gpu::Device> device);
	/// Returns a renderer for the device, once the one that was made while the inputs were read.
	Result<render::Renderer> takeRenderer();

	/// Counts the changes of what a frame is made of. Equal numbers mean that nothing has changed.
	struct Stamp
	{
		std::uint64_t grid = 0;     // blocks were read anew
		std::uint64_t cells = 0;    // the same, or cells have got neighbors and other numbers
		std::uint64_t values = 0;   // values in the blocks
		std::uint64_t settings = 0; // other settings than the place of the probe and its look
		std::uint64_t place = 0;    // place of the probe

		bool operator==(const Stamp&) const = default;
	};
	const Stamp& stamp() const { return stamp_; }

	const view::ViewSpec& spec() const { return spec_; }
	/// The inputs as the functions of read.h take them: the files, or one series.
	const std::vector<std::string>& inputs() const { return inputs_; }
	const view::ResolvedView& view() const { return view_; }
	const grid::BlockSet& blocks() const { return blocks_; }
	/// The time of the values in the blocks; nothing if the inputs have no times.
	std::optional<double> time() const { return blocks_.times.empty() ? std::nullopt : std::optional(launch_.time); }
	/// Returns the options that read the inputs at a time as this session does.
	read::ReadOptions readOptions(const read::TimeChoice& time) const;
	const LaunchState& launch() const { return launch_; }
	const std::shared_ptr<gpu::Device>& device() const { return device_; } // null if the CPU needs no device
	/// What was measured if a device may classify: from how many cells on it is faster.
	const std::optional<classify::BreakEven>& breakEven() const { return break_even_; }
	const cut::Cutter& cutter() const { return *cutter_; }
	/// Returns true if the colors of an array reach over what the sheets show: if the settings say so, or if it stays
	/// in its file, is larger than the memory for parts, and nobody asks for all of it.
	bool colorsOverShown(const std::optional<grid::FieldChoice>& field) const;
	/// The arrays that name categories, whatever the settings say of interpolation.
	const std::vector<CategoryArray>& categories() const { return categories_; }
	measure::FiniteFields* finiteFields() const { return finite_fields_.get(); }
	Timeline* timeline() const { return timeline_.get(); }
	/// The processes that hold the blocks together. The blocks of others have no cells here. Functions that say so must
	/// be called by all of them.
	const ranks::Ranks& ranks() const { return ranks_; }

private:
	Session() = default;
	template <class Take>
	static Result<std::unique_ptr<Session>> make(view::ViewSpec spec, OpenOptions options, Take&& take);
	Result<grid::BlockSet> readBlocks(const OpenOptions& options);
	Result<grid::BlockSet> readInputs(const read::ReadOptions& options);
	Status readAnew(read::ReadOptions at);
	Status readUndivided();
	Status resolve(view::ViewSpec spec);
	Status prepareLaunch();
	void lookForCategories();
	void takeNewValues();
	void takeTime(const read::TimeChoice& time);
	void takeValuesAt(const read::TimeChoice& time);
	bool classifiesOnGpu();
	Status makeCutter();
	Status buildNeighborsOfCopy();
	Status prepareFor(const FrameRequest& request, const std::stop_token& stop);
	Status readParts(const FrameRequest& request, const std::stop_token& stop);
	bool doesWithParts(const view::ViewSpec& spec) const;
	bool mayLinkNear() const;
	Result<bool> linkNear(const FrameRequest& request);
	const Frame* usableLast(const FrameRequest& request) const;
	Result<cut::Cut> find(const FrameRequest& request, const Frame* last, const std::stop_token& stop);
	Result<cut::Cut> cut(const FrameRequest& request, std::shared_ptr<const cut::Cut> last, std::stop_token stop);
	cut::CutRequest cutRequest(const FrameRequest& request) const;

	view::ViewSpec spec_;
	std::vector<std::string> inputs_;
	view::ResolvedView view_;
	bool is_resolved_ = false; // the view is that of the settings
	grid::BlockSet blocks_;
	std::vector<CategoryArray> categories_;
	bool reads_all_arrays_ = true; // read all arrays whenever the inputs are read
	bool is_for_one_frame_ = false;
	std::optional<std::uint64_t> stays_above_{}; // bytes of an array that may stay in its file
	std::vector<std::string> follow_;
	std::shared_ptr<read::ReadyReaders> ready_; // for inputs of many files or times
	StepAhead step_ahead_;
	LaunchState launch_;
	Stamp stamp_;
	Expect expected_ = Expect::first_of_many; // of the last frame
	std::shared_ptr<gpu::Device> device_;
	std::optional<render::Renderer> renderer_; // made while the inputs were read; the first painter takes it
	std::optional<classify::BreakEven> break_even_;
	std::unique_ptr<cut::Cutter> cutter_;
	std::unique_ptr<measure::FiniteFields> finite_fields_ = std::make_unique<measure::FiniteFields>();
	std::unique_ptr<Timeline> timeline_;
	ranks::Ranks ranks_ = ranks::Ranks::alone();
};

/// Returns the options that read the inputs at a time, with all arrays.
read::ReadOptions readOptions(const view::ViewSpec& spec, const read::TimeChoice& time);

/// Returns how many bytes of files may be in memory where they are read part by part, and lets the process keep so
/// many.
std::uint64_t memoryForParts(const view::ViewSpec& spec);

/// Reads the inputs of the settings at their time, as a session does, with all neighbors.
Result<grid::BlockSet> readInputs(const view::ViewSpec& spec);

/// Reads the inputs for what there is to tell of them: with named parts of the boundary, but without the cells of a
/// pack, whose file tells the rest (grid::lacksParts).
Result<grid::BlockSet> readFacts(const view::ViewSpec& spec);

/// Returns true if the settings need neighbors, whatever a plan says: for vectors, grid surfaces, contours, or surfaces
/// around the sheets.
bool needsNeighbors(const view::ViewSpec& spec);
/// The same for these blocks. The faces of whole cells are compared with each other, and need seams of several blocks.
bool needsNeighbors(const view::ViewSpec& spec, const grid::BlockSet& blocks);

/// Returns true if blocks that were read for one cut serve the settings: seeds from every row do as well as others.
bool servesOneCut(const view::ViewSpec& spec);

/// Returns "gpu", "cpu", or "mixed" if the CPU classifies a block because of a limit of the device.
const char* classifierName(const Session& session);

bool isEmpty(const cut::SheetCut& sheet);

/// Warns of empty sheets and moved hot spots. Returns an error if a hot spot lies outside and `outside` is refuse.
Status reportWarnings(const Session& session, const cut::Cut& slice);

} // namespace vp::session
