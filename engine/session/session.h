#pragma once

#include "base/result.h"
#include "base/timeline.h"
#include "classify/gpu_break_even.h"
#include "cut/cutter.h"
#include "gpu/device.h"
#include "grid/block.h"
#include "measure/finite_fields.h"
#include "read/read.h"
#include "render/renderer.h"
#include "session/open_device.h"
#include "vectors/path_lines.h"
#include "view/resolve.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

namespace vp::ranks
{
class Team;                // ranks/team.h
struct Share;              // ranks/data/share.h
class LazyParticleBorders; // ranks/particles/particle_borders.h
} // namespace vp::ranks

namespace vp::session
{

// A session is a pipeline, and a caller may stop after any stage:
//
//     openSession   validates the settings, reads the inputs, opens a device, resolves, makes a cutter
//     cut           finds the cut cells                                                      cut::Cut
//     sheetStats    builds polygons, launches particles, measures                            sheet_stats.h
//     growContours  contours of the sheets                                                   grown_contours.h
//     Painter       draws                                                                    picture/painter.h
//     write         polygons, flat pictures, pictures, films                                 picture/plane_pictures.h,
//     write/
//
// resolveAgain() changes the settings, moveToTime() the values, and buildNeighbors() adds the neighbors of cells.
//
// Only one thread at a time may use a session. cut(), planOf() and other functions with a const Session may run at the
// same time if each has a Timeline of its own.

/// What launching particles needs besides the settings.
struct LaunchState
{
	double dt = 1.0;                                             // time of a step
	std::optional<vectors::StoredVectors> stored{};              // filled if particles move through the input's times
	double time = 0.0;                                           // the time of the values in the blocks
	std::optional<std::pair<grid::FieldChoice, double>> fastest; // the greatest length in the array of vectors
};

/// A data set, its settings, and what cuts and draws it. The cutter refers to the blocks. The device serves the cutter
/// and the drawing.
struct Session
{
	view::ViewSpec spec;
	view::ResolvedView view;
	grid::BlockSet blocks;
	LaunchState launch;
	double swept = 0.0;           // place of a grid surface in its range for the next cut, 0 to 1
	bool reads_all_arrays = true; // read all arrays whenever the inputs are read
	bool another_follows = false; // another cut will follow, so a plan may build neighbors
	find::Finder finder = find::Finder::automatic;
	std::shared_ptr<gpu::Device> device;           // null if the CPU needs no device
	std::optional<render::Renderer> renderer;      // made while the inputs were read; the first painter takes it
	std::optional<classify::BreakEven> break_even; // measured if a device may classify
	std::unique_ptr<cut::Cutter> cutter;
	std::unique_ptr<measure::FiniteFields> finite_fields = std::make_unique<measure::FiniteFields>();
	std::unique_ptr<Timeline> timeline;
	// If several processes hold the blocks together: the blocks of others have no cells here. Functions that say so
	// must then be called by all of them.
	ranks::Team* team = nullptr;
	std::shared_ptr<const ranks::Share> share{};                    // with a team
	std::shared_ptr<ranks::LazyParticleBorders> particle_borders{}; // with a team; of the blocks as they are now
	std::uint64_t layer_bytes = 0;                                  // of pictures, sent to others
};

/// How to open a session, besides the settings.
struct OpenOptions
{
	DeviceUse use = DeviceUse::classify;
	// The first cut may do without neighbors, by a scan. If false, neighbors are built while the inputs are read.
	bool may_scan = false;
	bool reads_all_arrays = true; // read all arrays, not only those that are shown
	bool reads_again = true;      // the inputs may be read again at other times
	// The caller calls buildNeighbors() before a second cut, and before one that servesOneCut() does not hold for.
	bool completes_later = false;
	Timeline::Keep keep = Timeline::Keep::totals;
	std::shared_ptr<gpu::Device> device{}; // an open device; null opens the device of the settings
	std::stop_token stop{};                // a stop request ends the opening with ErrorKind::cancelled
	ranks::Team* team = nullptr;           // the processes that hold the inputs together; it outlives the session
};

/// Validates the settings, reads the inputs and prepares the rest. A caller writes nothing before this has succeeded.
Result<std::unique_ptr<Session>> openSession(view::ViewSpec spec, OpenOptions options);

/// The same for blocks that the caller has. Nothing is read; the input in the settings is only a name.
Result<std::unique_ptr<Session>> sessionOf(grid::BlockSet blocks, view::ViewSpec spec, OpenOptions options);

/// Opens a device to draw with, unless the session has one.
Status drawOn(Session& session);

/// Takes other settings for the same blocks: all settings except those of input and machine.
Status resolveAgain(Session& session, view::ViewSpec spec);

/// Returns the options that read the inputs at a time, with all arrays.
read::ReadOptions readOptions(const view::ViewSpec& spec, const read::TimeChoice& time);

/// Returns the options that read the inputs of a session at another time.
read::ReadOptions readOptions(const Session& session, const read::TimeChoice& time);

/// Reads the inputs of a session: all of them, or with a team this rank's share, which the session then has.
Result<grid::BlockSet> readInputs(Session& session, const read::ReadOptions& options);

/// Returns true if the settings need neighbors, whatever a plan says: for whole cells, vectors, grid surfaces,
/// contours, or surfaces around the sheets.
bool needsNeighbors(const view::ViewSpec& spec);

/// Returns true if blocks that were read for one cut serve the settings: seeds from every row do as well as others.
bool servesOneCut(const view::ViewSpec& spec);

/// Builds what the blocks lack for further cuts (grid::isComplete), such as neighbors of cells, and a new cutter. Cuts
/// that were made before become invalid, and so does everything made from them. A stop request ends it with
/// ErrorKind::cancelled, and leaves all as it was.
Status buildNeighbors(Session& session, const std::stop_token& stop = {});

/// Makes a cutter for the blocks that the session has now.
Status makeCutter(Session& session);

/// Cuts by the session's settings. last: a cut of this session that differs only in the place of the probe, see
/// CutRequest. The session must have neighbors if the plan needs them. A stop request ends it with
/// ErrorKind::cancelled.
Result<cut::Cut> cut(const Session& session, std::shared_ptr<const cut::Cut> last = nullptr, std::stop_token stop = {});

/// Returns the plan of cut(). If the strategy of the settings is impossible, returns a usage error that names
/// `strategy`.
Result<find::CutPlan> planOf(const Session& session);

/// Returns "gpu", "cpu", or "mixed" if the CPU classifies a block because of a limit of the device.
const char* classifierName(const Session& session);

bool isEmpty(const cut::SheetCut& sheet);

/// Warns of empty sheets and moved hot spots. Returns an error if a hot spot lies outside and `outside` is refuse.
Status reportWarnings(const Session& session, const cut::Cut& slice);

} // namespace vp::session
