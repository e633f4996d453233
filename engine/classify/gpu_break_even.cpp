#include "classify/gpu_break_even.h"

#include "classify/cpu_classifier.h"
#include "classify/gpu_classifier.h"
#include "classify/gpu_planes.h"
#include "grid/link/middle_part.h"
#include "seed/cut_cells.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

namespace vp::classify
{

namespace
{

constexpr std::size_t kPartSide = 24; // 14 thousand cells: more than fit the nearest cache, and built in some ms
// The widest front comes first. The round trip matters least there, so a device that loses there loses everywhere.
constexpr std::array<std::size_t, 3> kFronts{32768, 8192, 2048};
constexpr int kRuns = 2;

// The cut cells, repeated.
std::vector<CellId> frontOf(const grid::Block& block, const surface::Plane& plane, std::size_t width)
{
	std::vector<CellId> front;
	std::visit(
	    [&](const auto& grid)
	    {
		    for (CellId cell = 0; cell < grid.cellCount(); ++cell)
			    if (seed::isCut(grid, plane, cell))
				    front.push_back(cell);
	    },
	    block.grid);
	const std::size_t cut = front.size();
	front.resize(cut == 0 ? 0 : width);
	for (std::size_t i = cut; i < front.size(); ++i)
		front[i] = front[i - cut];
	return front;
}

// Returns the best time of some runs, in seconds.
template <class Classifier>
Result<double> timeOf(Classifier& classifier, std::span<const CellId> cells)
{
	std::vector<std::uint32_t> codes(cells.size());
	const find::Front front{0, cells, codes};
	double best = std::numeric_limits<double>::infinity();
	for (int run = 0; run < kRuns; ++run)
	{
		const auto start = std::chrono::steady_clock::now();
		if (Status done = classifier.classify({&front, 1}); !done)
			return done.error();
		best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
	}
	return best;
}

Result<BreakEven> measureOn(gpu::Device& device, const grid::BlockSet& part, const probe::Sheet& sheet)
{
	Result<std::unique_ptr<GpuBlocks>> on_device = GpuBlocks::create(device, part);
	if (!on_device)
		return on_device.error();
	if ((*on_device)->heldCount() == 0)
		return BreakEven{};
	const std::optional<grid::FieldChoice> no_field;
	Result<PlanesOnGpu> planes = planesOnGpu(**on_device, {&sheet, 1}, {&no_field, 1});
	if (!planes)
		return planes.error();
	const find::SheetInBlock<surface::Plane> plane{&part.blocks[0], sheet.plane(), nullptr, {}};
	CpuClassifier<surface::Plane> cpu({&plane, 1});
	auto gpu = GpuClassifier::create(
	    **on_device, std::move(planes->sheets), [&](auto fronts) { return cpu.classify(fronts); }, nullptr);
	if (!gpu)
		return gpu.error();

	BreakEven found;
	const std::vector<CellId> cells = frontOf(part.blocks[0], sheet.plane(), kFronts[0]);
	for (const std::size_t width : kFronts)
	{
		if (cells.size() < width)
			break;
		const Result<double> by_gpu = timeOf(**gpu, std::span(cells).first(width));
		if (!by_gpu)
			return by_gpu.error();
		const Result<double> by_cpu = timeOf(cpu, std::span(cells).first(width));
		if (!(*by_gpu < *by_cpu))
			break;
		found.cells = width;
	}
	return found;
}

} // namespace

Result<BreakEven> measureBreakEven(gpu::Device& device, const grid::BlockSet& blocks)
{
	const auto cells = [](const grid::Block& block)
	{ return std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid); };
	const auto largest = std::ranges::max_element(blocks.blocks, {}, cells);
	if (largest == blocks.blocks.end())
		return BreakEven{};
	grid::BlockSet part;
	part.blocks.push_back(grid::middlePart(*largest, kPartSide));
	if (part.cellCount() == 0) // polyhedra alone, which are the CPU's anyway
		return BreakEven{};
	// Oblique to all axes, like most planes.
	const probe::Sheet sheet = probe::makeSheet(part.blocks[0].bounds.center(), {0.3, 0.5, 0.81});
	return measureOn(device, part, sheet);
}

} // namespace vp::classify
