#pragma once

#include "base/result.h"
#include "base/timeline.h"
#include "classify/gpu_break_even.h"
#include "cut/cutter.h"
#include "gpu/device.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "measure/finite_fields.h"
#include "open_device.h"
#include "probe/probe.h"
#include "probe_options.h"
#include "read/read.h"
#include "surface_options.h"
#include "vector_choice.h"
#include "vectors/path_lines.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace vp::app
{

// What a command cuts and by what, made ready from the options. The cutter refers to the blocks, the device serves
// cutter and drawing.
struct Session
{
	grid::BlockSet blocks;
	std::optional<grid::FieldChoice> field;
	probe::Probe probe; // without its hidden sheets
	std::vector<std::optional<grid::FieldChoice>> sheet_fields;
	mesh::Corners corners = mesh::Corners::keep;
	seed::SeedOptions seeds;
	std::optional<SurfaceChoice> surface; // in place of the probe's sheets
	double swept = 0.0;                   // how far along its range the next cut lies, 0 to 1
	bool crinkle = false;                 // the whole cells are wanted too
	bool range_of_slice = false;          // pictures' colors go by the values that are shown
	std::optional<find::Threshold> threshold;
	std::optional<grid::FieldChoice> vector_array;                 // where one is asked for, or needed
	std::optional<VectorChoice> vectors;                           // launched from the sheets
	std::optional<vectors::StoredVectors> stored{};                // of that array, where particles go through times
	double time = 0.0;                                             // that the blocks have values of
	std::optional<std::pair<grid::FieldChoice, double>> fastest{}; // the greatest length in an array of vectors
	bool another_follows = false; // so that a cut builds neighbors where they are not known
	find::Finder finder = find::Finder::automatic;
	std::optional<find::Strategy> strategy; // asked for by name
	find::VisitedSet visited = find::VisitedSet::stamps;
	std::shared_ptr<gpu::Device> device;      // null where the CPU does without
	std::optional<render::Renderer> renderer; // for who draws first, where it was made beside reading
	std::unique_ptr<cut::Cutter> cutter;
	std::optional<classify::BreakEven> break_even; // measured where --classify auto has a device to choose
	std::unique_ptr<measure::FiniteFields> finite_fields = std::make_unique<measure::FiniteFields>();
	std::unique_ptr<Timeline> timeline;
};

// Reads the inputs and builds the rest. Nothing is written before this has succeeded. device: one that is open; null
// opens the one that the options say. stop: asked to stop, reading ends with an error.
Result<std::unique_ptr<Session>> openSession(const ProbeOptions& options, DeviceUse use,
                                             Timeline::Keep keep = Timeline::Keep::totals,
                                             std::shared_ptr<gpu::Device> device = nullptr,
                                             const std::stop_token& stop = {});

// What is cut and by what, of the blocks that the session has: all that the options say beside input and device.
Status choose(Session& session, const ProbeOptions& options);

// How the inputs are read at one of their times.
read::ReadOptions readOptions(const ProbeOptions& options, const read::TimeChoice& time);

// Whether what is cut asks for neighbors before the session can say what that is: whole cells, vectors, grid surfaces.
bool needsNeighbors(const ProbeOptions& options);

// Builds the neighbors of cells where the session has been opened without, and a cutter for them. Cuts that were made
// before, and what was made of them, hold no more. `options`: as the session was opened with.
Status buildNeighbors(Session& session, const ProbeOptions& options);

// A cutter for the blocks that the session has now.
Status makeCutter(Session& session, const ProbeOptions& options);

// last: a cut of this session that differs in the probe's place alone; see CutRequest. The session has neighbors where
// the plan needs them.
Result<cut::Cut> cut(const Session& session, std::shared_ptr<const cut::Cut> last = nullptr);

// How cut() goes. A usage error that names --strategy where what it asks for cannot be had.
Result<find::CutPlan> planOf(const Session& session);

bool isEmpty(const cut::SheetCut& sheet);

// Tells the user in a word what is empty or was moved; an error where a hot spot outside is to be one.
Status reportWarnings(const Session& session, const cut::Cut& slice);

} // namespace vp::app
