#pragma once

#include "report/sweep_products.h"
#include "write/trace_file.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>

namespace vp::app
{

// A frame's slice. last: that of the frame before, or null.
using CutSlice = std::function<Result<cut::Cut>(int frame, std::shared_ptr<const cut::Cut> last)>;

struct SweepPlan
{
	int frames;
	bool cuts_ahead;         // on a thread of its own, while the frame before is drawn: cutting must touch nothing else
	bool writes_beside;      // see SweepProducts
	bool wants_figures;      // of every frame
	write::TraceFile* trace; // or null
	view::ContourSpec contour;
	// Called after the first frame, and before any other, where the blocks lack neighbors: all frames but the first
	// need them. Empty where none does.
	std::function<Status()> build_neighbors;
};

// Cuts, draws and writes frame by frame. With both threads frame n + 1 is cut while n is drawn and n - 1 written: the
// pictures, the figures and their order are as if one came after the other, and so is which error is told. In memory
// are at most two frames that have been cut and three pictures. Gives the figures.
Result<nlohmann::json> sweepThrough(const SweepPlan& plan, const CutSlice& cut_slice, const session::Session& session,
                                    SweepProducts& products);

} // namespace vp::app
