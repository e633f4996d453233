#pragma once

#include "sweep/sweep_products.h"
#include "write/trace_file.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>

namespace vp::app
{

// Cuts a frame. last: the cut of the frame before, or null.
using CutSlice = std::function<Result<cut::Cut>(int frame, std::shared_ptr<const cut::Cut> last)>;

struct SweepPlan
{
	int frames;
	bool cuts_ahead; // cut on a thread of its own while the frame before is drawn; the cut must not touch anything else
	bool writes_beside;      // write on a thread of its own, see SweepProducts
	bool wants_figures;      // measure every frame
	write::TraceFile* trace; // or null
	view::ContourSpec contour;
	// Builds the neighbors of cells. Called after the first frame if the blocks lack neighbors, since all other frames
	// need them. Empty if no frame needs them.
	std::function<Status()> build_neighbors;
};

// Cuts, draws and writes frame by frame. With both threads, frame n + 1 is cut while frame n is drawn and frame n - 1
// is written. Pictures, figures, their order, and which error is reported are the same as without threads. At most two
// cut frames and three pictures are in memory. Returns the figures.
Result<nlohmann::json> sweepThrough(const SweepPlan& plan, const CutSlice& cut_slice, const session::Session& session,
                                    SweepProducts& products);

} // namespace vp::app
