#include "api/border.h"
#include "api/states.h"
#include "base/stop_scope.h"
#include "grid/check/memory.h"
#include "probe/probe_file.h"
#include "read/check_mesh.h"
#include "read/sandbox.h"
#include "view/settings.h"
#include "view/words.h"

#include <vprobe/dataset.h>

#include <algorithm>

namespace vprobe
{

ArrayInfo infoOf(const vp::grid::Field& field)
{
	return {field.name, field.association == vp::grid::Association::point ? Association::point : Association::cell,
	        static_cast<NumberType>(field.type), field.components, field.units};
}

namespace
{

vp::view::MachineSpec machineOf(Classify classify, const std::string& device)
{
	vp::view::MachineSpec machine;
	machine.classify = static_cast<vp::view::Classify>(classify);
	machine.device = device;
	return machine;
}

} // namespace

Result<Dataset> Dataset::open(const std::vector<std::string>& files, const OpenOptions& options)
{
	return guarded(
	    [&]() -> Result<Dataset>
	    {
		    vp::view::ViewSpec spec;
		    spec.input.files = files;
		    const vp::Result<vp::read::TimeChoice> time = vp::read::parseTime(options.time);
		    if (!time)
			    return Error{ErrorKind::usage, "`time` " + options.time + ": " + time.error().message};
		    if (files.empty())
			    return Error{ErrorKind::usage, "there is no file to open; name one, or demo:NAME"};
		    spec.input.time = *time;
		    for (const std::string& folder : options.follow)
			    if (const vp::Status fits = vp::read::checkFollow(folder); !fits)
				    return Error{ErrorKind::usage, "`follow` " + fits.error().message};
		    if (const vp::Status set = vp::view::setByKey(spec, "inputs", options.inputs); !set)
			    return publicError(set.error());
		    spec.input.solution = options.solution;
		    spec.input.refine = options.refine;
		    spec.input.level = options.level;
		    spec.input.displace = options.displace;
		    spec.input.displace_by = options.displace_by;
		    spec.input.format = options.format;
		    spec.input.cell_to_point = options.cell_to_point;
		    spec.machine = machineOf(options.classify, options.device);
		    Result<std::shared_ptr<DatasetState>> state =
		        DatasetState::of(vp::session::Session::open(std::move(spec), {.expect = vp::session::Expect::one_cut,
		                                                                      .frames_alone = options.keeps_parts,
		                                                                      .follow = options.follow,
		                                                                      .stop = options.stop}));
		    return state ? Result<Dataset>(Dataset(std::move(*state))) : state.error();
	    });
}

Result<Dataset> Dataset::open(const std::string& file, const OpenOptions& options)
{
	return open(std::vector{file}, options);
}

Result<Dataset> Dataset::wrap(std::vector<Block> blocks, Classify classify, const std::string& device,
                              std::stop_token stop)
{
	return guarded(
	    [&]() -> Result<Dataset>
	    {
		    try
		    {
			    vp::view::ViewSpec spec;
			    spec.machine = machineOf(classify, device);
			    std::vector<ArraySizes> sizes;
			    const auto take = [&] { return vp::Result<vp::grid::BlockSet>(wrapped(std::move(blocks), sizes)); };
			    vp::Result<vp::grid::BlockSet> taken = vp::endingOnRequest(stop, "wrapping", take);
			    if (!taken)
				    return publicError(taken.error());
			    Result<std::shared_ptr<DatasetState>> state = DatasetState::of(
			        vp::session::Session::of(std::move(*taken), std::move(spec),
			                                 {.expect = vp::session::Expect::one_cut, .stop = std::move(stop)}));
			    if (!state)
				    return state.error();
			    (*state)->array_sizes = std::move(sizes);
			    return Dataset(std::move(*state));
		    }
		    catch (const vp::read::Unusable& unusable)
		    {
			    return Error{ErrorKind::input, unusable.what()};
		    }
	    });
}

const char* Dataset::kind() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks().kind();
}

std::size_t Dataset::cellCount() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks().sourceCellCount();
}

std::size_t Dataset::pointCount() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks().sourcePointCount();
}

std::size_t Dataset::blockCount() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks().blocks.size();
}

std::pair<Vector3, Vector3> Dataset::bounds() const
{
	const std::lock_guard lock(state_->mutex);
	const vp::Box bounds = state_->session->blocks().bounds();
	return {{bounds.lo.x, bounds.lo.y, bounds.lo.z}, {bounds.hi.x, bounds.hi.y, bounds.hi.z}};
}

std::vector<double> Dataset::times() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks().times;
}

std::vector<ArrayInfo> Dataset::arrays() const
{
	const std::lock_guard lock(state_->mutex);
	std::vector<ArrayInfo> arrays;
	const auto isKnown = [&](const ArrayInfo& info)
	{
		return std::ranges::any_of(arrays, [&](const ArrayInfo& known)
		                           { return known.name == info.name && known.association == info.association; });
	};
	for (const vp::grid::Block& block : state_->session->blocks().blocks)
		for (const vp::grid::Field& field : block.fields)
			if (const ArrayInfo info = infoOf(field); !isKnown(info))
				arrays.push_back(info);
	return arrays;
}

Status Dataset::readAll(std::stop_token stop) const
{
	return guarded(
	    [&]() -> Status
	    {
		    const std::lock_guard lock(state_->mutex);
		    return publicStatus(state_->session->readAllParts(stop));
	    });
}

HeldBlock Dataset::block(std::size_t index) const
{
	const std::lock_guard lock(state_->mutex);
	HeldBlock held = heldBlock(state_->session->blocks().blocks[index]);
	const ArraySizes sizes = state_->sizes()[index];
	held.points = sizes.points;
	held.cells = sizes.cells;
	return held;
}

MemoryUse Dataset::memory() const
{
	const std::lock_guard lock(state_->mutex);
	const vp::grid::BlockSet& blocks = state_->session->blocks();
	const vp::grid::Memory grid = vp::grid::memoryOf(blocks);
	const vp::cut::Cutter::Memory cutter = state_->session->cutter().memory();
	const bool copied = std::ranges::any_of(
	    blocks.blocks, [](const vp::grid::Block& block)
	    { return std::holds_alternative<vp::grid::UnstructuredGrid>(block.grid) && vp::grid::hasNeighbors(block); });
	return {grid.geometry, grid.arrays, grid.built(), cutter.marks, cutter.device, copied};
}

void Dataset::modified()
{
	const std::lock_guard lock(state_->mutex);
	state_->session->forgetValues();
}

Status Dataset::setFields(std::vector<std::vector<Field>> fields)
{
	return guarded(
	    [&]() -> Status
	    {
		    const std::lock_guard lock(state_->mutex);
		    vp::Result<std::vector<std::vector<vp::grid::Field>>> checked = checkedFields(state_->sizes(), fields);
		    if (!checked)
			    return publicError(checked.error());
		    state_->keepBlocksOfCuts();
		    state_->added.clear();
		    if (vp::Status replaced = state_->session->replaceFields(std::move(*checked)); !replaced)
			    return publicError(replaced.error());
		    return Nothing{};
	    });
}

Status Dataset::setArray(std::vector<Field> of_each_block)
{
	return guarded(
	    [&]() -> Status
	    {
		    const std::lock_guard lock(state_->mutex);
		    std::vector<std::vector<Field>> each;
		    for (Field& field : of_each_block)
			    each.push_back({std::move(field)});
		    const vp::Result<std::vector<std::vector<vp::grid::Field>>> checked = checkedFields(state_->sizes(), each);
		    if (!checked)
			    return publicError(checked.error());
		    std::vector<vp::grid::Field> array;
		    for (const std::vector<vp::grid::Field>& of_block : *checked)
			    array.push_back(of_block.front());
		    state_->keepBlocksOfCuts();
		    state_->session->setArray(array);
		    std::erase_if(state_->added, [&](const std::vector<vp::grid::Field>& known)
		                  { return known[0].name == array[0].name && known[0].association == array[0].association; });
		    state_->added.push_back(std::move(array));
		    return Nothing{};
	    });
}

Result<Cut> Dataset::cut(const View& view, std::stop_token stop) const
{
	return withView<Cut>(*state_, view, [&] { return state_->cut(stop); });
}

Result<std::vector<PlanRow>> Dataset::plan(const View& view) const
{
	const auto rows = [&]() -> vp::Result<std::vector<PlanRow>>
	{
		const vp::Result<vp::find::CutPlan> plan = state_->session->plan(state_->nextRequest());
		if (!plan)
			return plan.error();
		std::vector<PlanRow> found;
		for (std::size_t s = 0; s < plan->sheets.size(); ++s)
			for (std::size_t b = 0; b < plan->sheets[s].size(); ++b)
			{
				const vp::find::BlockPlan& way = plan->sheets[s][b];
				found.push_back({s, b, nameOf(way.strategy), nameOf(way.classifier), way.reason()});
			}
		return found;
	};
	return withView<std::vector<PlanRow>>(*state_, view, rows);
}

Result<std::string> Dataset::probeText(const View& view) const
{
	return withView<std::string>(*state_, view,
	                             [&]() -> vp::Result<std::string>
	                             { return vp::probe::probeText(state_->session->view().probe); });
}

Result<Image> Dataset::render(const Cut& cut, const View& view, std::stop_token stop) const
{
	if (cut.state_->is_own)
		return guarded(
		    [&]
		    {
			    const std::lock_guard lock(state_->mutex);
			    return state_->drawOwn(cut, view, stop);
		    });
	return withView<Image>(*state_, view, [&] { return state_->draw(cut, stop); });
}

Result<Image> Dataset::render(const View& view, std::stop_token stop) const
{
	return withView<Image>(*state_, view,
	                       [&]() -> vp::Result<Image>
	                       {
		                       vp::Result<Cut> cut = state_->cut(stop);
		                       return cut ? state_->draw(*cut, stop) : cut.error();
	                       });
}

} // namespace vprobe
