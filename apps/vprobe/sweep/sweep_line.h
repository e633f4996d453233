#pragma once

#include "base/frame_scope.h"
#include "report/frame_figures.h"
#include "sweep/sweep_products.h"
#include "write/trace_file.h"

#include <functional>
#include <memory>

namespace vp::app
{

// Returns what a frame cuts. The sweep adds what it wants and the frame before.
using AskFrame = std::function<session::FrameRequest(int frame)>;

struct SweepPlan
{
	int frames;
	bool cuts_ahead; // cut on a thread of its own while the frame before is drawn; the cut must not touch anything else
	bool writes_beside;                         // write on a thread of its own, see SweepProducts
	FrameFigures* figures;                      // measures every frame for them, or null
	write::TraceFile* trace;                    // or null
	FrameScope::Stop last_stop;                 // where a frame ends
	const std::vector<double>* times = nullptr; // of a sweep over the times of the inputs: one for each frame
};

// Cuts, draws and writes frame by frame. With both threads, frame n + 1 is cut while frame n is drawn and frame n - 1
// is written. Pictures, figures, their order, and which error is reported are the same as without threads. At most two
// cut frames and three pictures are in memory.
Status sweepThrough(const SweepPlan& plan, const AskFrame& ask, session::Session& session, SweepProducts& products);

} // namespace vp::app
