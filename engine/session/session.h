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

namespace vp::session
{

// A session is a pipeline, and a caller may stop after any stage:
//
//     openSession   validates the settings, reads the inputs, opens a device, resolves, makes a cutter
//     cut           finds the cut cells                                                      cut::Cut
//     sheetStats    builds polygons, launches particles, measures                            sheet_stats.h
//     growContours  contours of the sheets                                                   grown_contours.h
//     Painter       draws                                                                    painter.h
//     write         polygons, flat pictures, pictures, films                                 plane_pictures.h, write/
//
// resolveAgain() takes other settings, moveToTime() other values, buildNeighbors() the neighbors of cells.
//
// One thread at a time works with a session; cut(), planOf() and what takes a const Session may run beside each other
// where each has a Timeline of its own.

/// What belongs to particles that are launched, beside what the settings say.
struct LaunchState
{
	double dt = 1.0;                                             // of a step
	std::optional<vectors::StoredVectors> stored{};              // where particles go through times
	double time = 0.0;                                           // that the blocks have values of
	std::optional<std::pair<grid::FieldChoice, double>> fastest; // the greatest length in an array of vectors
};

/// A data set with what is cut and by what. The cutter refers to the blocks, the device serves cutter and drawing.
struct Session
{
	view::ViewSpec spec;
	view::ResolvedView view;
	grid::BlockSet blocks;
	LaunchState launch;
	double swept = 0.0;           // how far along its range a surface of the grid lies in the next cut, 0 to 1
	bool reads_all_arrays = true; // whenever the inputs are read
	bool another_follows = false; // so that a cut builds neighbors where they are not known
	find::Finder finder = find::Finder::automatic;
	std::shared_ptr<gpu::Device> device;           // null where the CPU does without
	std::optional<render::Renderer> renderer;      // for who draws first, where it was made beside reading
	std::optional<classify::BreakEven> break_even; // measured where a device may classify
	std::unique_ptr<cut::Cutter> cutter;
	std::unique_ptr<measure::FiniteFields> finite_fields = std::make_unique<measure::FiniteFields>();
	std::unique_ptr<Timeline> timeline;
};

/// How a session is opened, beside the settings.
struct OpenOptions
{
	DeviceUse use = DeviceUse::classify;
	// The first cut may do without neighbors, see cuts that scan. Else they are built while the inputs are read.
	bool may_scan = false;
	bool reads_all_arrays = true; // not only those that are shown
	bool reads_again = true;      // the inputs may be read at other times
	Timeline::Keep keep = Timeline::Keep::totals;
	std::shared_ptr<gpu::Device> device{}; // one that is open; null opens the one that the settings say
	std::stop_token stop{};                // asked to stop, reading ends with ErrorKind::cancelled
};

/// Validates the settings, reads the inputs and makes the rest ready. Nothing is written before this has succeeded.
Result<std::unique_ptr<Session>> openSession(view::ViewSpec spec, OpenOptions options);

/// The same with blocks that the caller has; nothing is read, and the settings' input is a name at most.
Result<std::unique_ptr<Session>> sessionOf(grid::BlockSet blocks, view::ViewSpec spec, OpenOptions options);

/// Opens a device to draw on, where the session has none yet.
Status drawOn(Session& session);

/// Takes other settings for the blocks that the session has: all but those of input and machine.
Status resolveAgain(Session& session, view::ViewSpec spec);

/// How inputs are read at one of their times, with all arrays.
read::ReadOptions readOptions(const view::ViewSpec& spec, const read::TimeChoice& time);

/// How those of a session are read at another time.
read::ReadOptions readOptions(const Session& session, const read::TimeChoice& time);

/// Whether what is cut or drawn asks for neighbors before a plan can say so: whole cells, vectors, grid surfaces,
/// contours, what is drawn around the sheets.
bool needsNeighbors(const view::ViewSpec& spec);

/// Builds the neighbors of cells where the session has been opened without, and a cutter for them. Cuts that were made
/// before, and what was made of them, hold no more.
Status buildNeighbors(Session& session);

/// A cutter for the blocks that the session has now.
Status makeCutter(Session& session);

/// last: a cut of this session that differs in the probe's place alone; see CutRequest. The session has neighbors where
/// the plan needs them. Asked to stop, it ends with ErrorKind::cancelled.
Result<cut::Cut> cut(const Session& session, std::shared_ptr<const cut::Cut> last = nullptr, std::stop_token stop = {});

/// How cut() goes. A usage error that names `strategy` where what it asks for cannot be had.
Result<find::CutPlan> planOf(const Session& session);

/// "gpu", "cpu", or "mixed" where a block stayed with the CPU for a limit of the device.
const char* classifierName(const Session& session);

bool isEmpty(const cut::SheetCut& sheet);

/// Warns of what is empty or was moved; an error where a hot spot outside is to be one.
Status reportWarnings(const Session& session, const cut::Cut& slice);

} // namespace vp::session
