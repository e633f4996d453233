#pragma once

#include "session/cut_frame.h"
#include "session/painter.h"
#include "session/session.h"
#include "write/slice_table.h"

#include <vprobe/dataset.h>

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace vprobe
{

// What stands behind the public classes.

struct View::State
{
	vp::view::ViewSpec spec;
};

// A mesh with its arrays, tabulated when somebody asks for them.
struct Mesh::State
{
	std::shared_ptr<const Cut::State> cut; // keeps the mesh and its blocks alive
	const vp::mesh::SheetMesh* mesh = nullptr;
	mutable std::once_flag once;
	mutable vp::write::SliceTable table;
	mutable std::vector<MeshArray> arrays;
};

struct Cut::State
{
	// The grids as the cut knows them: those of the data set, or, where that has got neighbors since, as they were.
	std::shared_ptr<const vp::grid::BlockSet> blocks;
	vp::session::CutFrame frame;
	std::uint64_t linking = 0; // of the data set when the cut was made
};

// A session and what is kept for it. `mutex` guards all of it.
struct DatasetState : std::enable_shared_from_this<DatasetState>
{
	std::mutex mutex;
	std::unique_ptr<vp::session::Session> session;
	std::optional<vp::session::Painter> painter;
	std::uint64_t linking = 0; // rises when cells get other numbers
	std::size_t cuts = 0;

	static Result<std::shared_ptr<DatasetState>> of(vp::Result<std::unique_ptr<vp::session::Session>> opened);

	// The mutex is held.
	vp::Status take(const View& view);         // the view's settings for the blocks there are
	vp::Status link();                         // neighbors, where they are needed and not known
	vp::Result<Cut> cut(std::stop_token stop); // as the session has it
	vp::Result<Image> draw(const Cut& cut);    // by the settings that were taken last
	std::shared_ptr<const vp::grid::BlockSet> blocks();
};

// The session's blocks of what a caller has; throws read::Unusable.
vp::grid::BlockSet wrapped(std::vector<Block> blocks);

ArrayInfo infoOf(const vp::grid::Field& field);

} // namespace vprobe
