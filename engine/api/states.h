#pragma once

#include "api/border.h"
#include "gpu/image.h"
#include "picture/painter.h"
#include "session/frame.h"
#include "session/session.h"
#include "vectors/flux.h"
#include "write/slice_table.h"

#include <vprobe/dataset.h>

#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <vector>

namespace vprobe
{

// The state behind the public classes.

struct View::State
{
	vp::view::ViewSpec spec;
};

// A mesh with its arrays. Each part of the table is made when somebody asks for it.
struct Mesh::State
{
	std::shared_ptr<const Cut::State> cut; // keeps the mesh and its blocks alive
	const vp::mesh::SheetMesh* mesh = nullptr;
	std::optional<vp::mesh::SheetMesh> parted; // the mesh, if polygons of the cut have holes
	mutable std::once_flag polygons_once;
	mutable std::once_flag cells_once;
	mutable std::once_flag arrays_once;
	mutable vp::write::SliceTable table;
	mutable std::vector<MeshArray> arrays;
};

// The grids as cuts know them: those of the data set, or, where that has got neighbors or other arrays since, as they
// were.
struct CutBlocks
{
	explicit CutBlocks(std::shared_ptr<const vp::grid::BlockSet> blocks) : blocks(std::move(blocks)) {}

	std::shared_mutex mutex; // shared by those who read the blocks
	std::shared_ptr<const vp::grid::BlockSet> blocks;
};

// The figures of a sheet.
struct SheetFigures
{
	vp::measure::SheetMeasure measure;
	std::optional<vp::vectors::Flux> flux;
};

struct Cut::State
{
	std::shared_ptr<vp::gpu::Device> device; // polygons may lie in its memory
	std::shared_ptr<CutBlocks> blocks;
	std::shared_ptr<const vp::session::Frame> frame;
	// The figures of each sheet, measured when somebody asks for them.
	mutable std::mutex measuring;
	mutable std::vector<std::optional<SheetFigures>> figures;
	std::vector<std::optional<vp::grid::FieldChoice>> flux_arrays; // per sheet, as the settings were
	bool is_own = false; // the polygons and arrays are a caller's: the frame refers to blocks made of them
	std::optional<vp::write::SliceTable> table; // what save() writes then
	// By what it was made.
	const DatasetState* made_by = nullptr;
	std::uint64_t linking = 0;
	vp::view::ProbeSpec probe;
	vp::view::ContourSpec contour;
	vp::view::ColorBy color_by = vp::view::ColorBy::array;
};

// How many tuples the arrays of a block have.
struct ArraySizes
{
	std::uint64_t points = 0;
	std::uint64_t cells = 0;
};

// A session and what is kept for it. `mutex` guards all of it.
struct DatasetState : std::enable_shared_from_this<DatasetState>
{
	std::mutex mutex;
	std::unique_ptr<vp::session::Session> session;
	std::optional<vp::picture::Painter> painter;
	std::uint64_t linking = 0; // rises when cells get other numbers
	std::size_t cuts = 0;
	vp::session::FrameRequest request;            // where the next cut is made, in a sweep
	bool sweeps = false;                          // the cut is a frame of a sweep, so others follow
	std::weak_ptr<CutBlocks> blocks_of_cuts;      // block sets of the cuts that share the session's blocks
	std::optional<vp::read::TimeChoice> moved_to; // after a sweep through the times: the one whose values are loaded
	// Only for wrapped data sets: the numbers of points and cells of each block, as the caller's arrays count them.
	// Cells without a volume count too.
	std::vector<ArraySizes> array_sizes;
	std::vector<std::vector<vp::grid::Field>> added; // arrays that the caller added, a field for each block
	bool has_callers_device = false;
	std::optional<vp::gpu::Image> target; // the last picture for an image of the caller's

	static Result<std::shared_ptr<DatasetState>> of(vp::Result<std::unique_ptr<vp::session::Session>> opened);

	// The mutex is held.
	std::vector<ArraySizes> sizes() const; // for each block
	// The view's settings for the blocks there are. for_sweep: frames of a sweep follow, which may go through the
	// times.
	vp::Status take(const View& view, bool for_sweep = false);
	vp::Status link(const std::stop_token& stop); // completes the blocks, with the neighbors of cells
	vp::session::FrameRequest nextRequest() const;
	vp::Result<Cut> cut(std::stop_token stop);                           // as the session has it
	vp::Result<Image> draw(const Cut& cut, const std::stop_token& stop); // by the settings that were taken last
	// Draws a caller's polygons with the caller's arrays, which take part in the settings for so long.
	Result<Image> drawOwn(const Cut& cut, const View& view, const std::stop_token& stop);
	bool fits(const Cut& cut) const; // it is what the settings would cut now
	vp::Status readyPainter();       // for those settings
	// Makes the painter ready for those settings. Returns the cut to draw, which is another one if this one does not
	// fit.
	vp::Result<Cut> readyToDraw(const Cut& cut, const std::stop_token& stop);
	// From now on the caller's device draws and classifies. If it is null, the next picture opens a device.
	vp::Status takeDevice(std::shared_ptr<vp::gpu::Device> callers);
	vp::Status drawForCaller(const Cut& cut, VkExtent2D extent); // into `target`
	vp::Error afterFailure(const vp::Error& error);              // called after drawing failed; closes a lost device
	std::shared_ptr<CutBlocks> blocksOfCut();                    // returns the blocks for a new cut
	void keepBlocksOfCuts(); // before arrays or their marks change: cuts keep the blocks as they are
	vp::Status moveTo(const vp::read::TimeChoice& time);
	vp::Status returnToItsTime(); // time at which the data set was opened
};

// Runs `work` with the data set's lock, the view taken.
template <class T, class Work>
Result<T> withView(DatasetState& state, const View& view, Work&& work, bool for_sweep = false)
{
	return guarded(
	    [&]() -> Result<T>
	    {
		    const std::lock_guard lock(state.mutex);
		    if (vp::Status taken = state.take(view, for_sweep); !taken)
			    return publicError(taken.error());
		    vp::Result<T> done = work();
		    return done ? Result<T>(std::move(*done)) : publicError(done.error());
	    });
}

// The session's blocks of what a caller has, and the sizes of their arrays; throws read::Unusable.
vp::grid::BlockSet wrapped(std::vector<Block> blocks, std::vector<ArraySizes>& sizes);
// The same for arrays of blocks that there are.
vp::Result<std::vector<std::vector<vp::grid::Field>>> checkedFields(const std::vector<ArraySizes>& sizes,
                                                                    const std::vector<std::vector<Field>>& fields);
// The sizes where nobody wrapped the blocks.
std::vector<ArraySizes> arraySizes(const vp::grid::BlockSet& blocks);

inline DatasetState& stateOf(const Dataset& data)
{
	return *data.state_;
}

HeldBlock heldBlock(const vp::grid::Block& block);
ArrayInfo infoOf(const vp::grid::Field& field);

} // namespace vprobe
