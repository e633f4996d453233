#include "our_cuts.h"

#include "command_output.h"
#include "gpu/device.h"
#include "grids.h"
#include "mesh/mesh_values.h"
#include "probe/path.h"
#include "probe/presets.h"

#include <nlohmann/json.hpp>

#include <numbers>
#include <optional>

namespace vp::bench
{

namespace
{

std::vector<probe::Sheet> sheetsAt(const probe::Frame& frame, int count)
{
	std::vector<probe::Sheet> sheets;
	for (const probe::Frame& plane : fanOf(frame, count))
	{
		probe::Sheet& sheet = sheets.emplace_back();
		sheet.origin = plane.origin;
		sheet.normal = plane.normal;
		sheet.up = plane.up;
	}
	return sheets;
}

// A moved plane after the other; `window` one a plane, or empty.
void sweep(benchmark::State& state, cut::Cutter& cutter, Search search, int sheets,
           const std::vector<std::optional<probe::Window>>& windows = {})
{
	const std::vector<probe::Frame> planes = sweepOf(cutter.blocks().bounds());
	std::size_t k = 0;
	std::size_t cells = 0;
	std::size_t generations = 0;
	std::vector<const grid::Field*> fields; // the first array of each block
	for (const grid::Block& block : cutter.blocks().blocks)
		fields.push_back(block.fields.empty() ? nullptr : &block.fields[0]);
	for (auto _ : state)
	{
		cut::CutRequest request;
		request.in_generations = search == Search::generations;
		request.seeds.lattice = cutter.usesGpu();
		request.probe.sheets = sheetsAt(planes[k], sheets);
		if (!windows.empty())
			request.probe.sheets[0].window = windows[k];
		const Result<cut::Cut> slice = cutter.cut(request);
		for (std::size_t s = 0; s < slice->sheets.size(); ++s)
		{
			cells += slice->sheets[s].cuts[0].cutCells();
			generations += slice->sheets[s].cuts[0].steps();
			if (cutter.usesGpu())
				continue;
			const mesh::SheetMesh mesh = slice->mesh(cutter.blocks(), s);
			const auto values = mesh::vertexValues(cutter.blocks(), mesh, fields, 0);
			benchmark::DoNotOptimize(mesh.positions.data());
			benchmark::DoNotOptimize(values.data());
		}
		k = (k + 1) % planes.size();
	}
	state.counters["per_cell"] =
	    benchmark::Counter(static_cast<double>(cells), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
	if (generations > 0)
		state.counters["generations"] =
		    benchmark::Counter(static_cast<double>(generations) / sheets, benchmark::Counter::kAvgIterations);
}

std::optional<probe::Window> middleOf(const probe::Sheet& sheet, const mesh::SheetMesh& mesh)
{
	if (mesh.positions.empty())
		return std::nullopt;
	glm::dvec2 lo(INFINITY);
	glm::dvec2 hi(-INFINITY);
	for (const Vec3& p : mesh.positions)
	{
		const glm::dvec2 uv(glm::dot(p - sheet.origin, sheet.xAxis()), glm::dot(p - sheet.origin, sheet.up));
		lo = glm::min(lo, uv);
		hi = glm::max(hi, uv);
	}
	constexpr double kPart = 1.0 / 5.0;
	const glm::dvec2 center = 0.5 * (lo + hi);
	const glm::dvec2 half = 0.5 * kPart * (hi - lo);
	return probe::Window{center.x - half.x, center.x + half.x, center.y - half.y, center.y + half.y};
}

void cutOnce(const grid::BlockSet& blocks)
{
	const std::vector<probe::Frame> planes = sweepOf(blocks.bounds());
	cut::Cutter cutter(blocks);
	cut::CutRequest request;
	request.probe.sheets = sheetsAt(planes[planes.size() / 2], 1);
	const mesh::SheetMesh mesh = cutter.cut(request)->mesh(blocks, 0);
	benchmark::DoNotOptimize(mesh.positions.data());
}

std::optional<nlohmann::json> profile(const std::string& command)
{
	const std::optional<std::string> text = outputOf(command);
	if (!text)
		return std::nullopt;
	return nlohmann::json::parse(*text);
}

} // namespace

std::vector<probe::Frame> fanOf(const probe::Frame& frame, int planes)
{
	std::vector<probe::Frame> fan;
	const Vec3 x_axis = glm::cross(frame.up, frame.normal);
	for (int i = 0; i < planes; ++i)
	{
		const double angle = std::numbers::pi * i / planes;
		probe::Frame& turned = fan.emplace_back(frame);
		turned.normal = glm::normalize(std::cos(angle) * frame.normal + std::sin(angle) * x_axis);
	}
	return fan;
}

double cutCellsOfPlane(const std::string& name)
{
	cut::Cutter cutter(gridNamed(name));
	const std::vector<probe::Frame> planes = sweepOf(cutter.blocks().bounds());
	std::size_t cells = 0;
	for (const probe::Frame& plane : planes)
	{
		cut::CutRequest request;
		request.probe.sheets = sheetsAt(plane, 1);
		cells += cutter.cut(request)->sheets[0].cuts[0].cutCells();
	}
	return static_cast<double>(cells) / static_cast<double>(planes.size());
}

void cpuCut(benchmark::State& state, const std::string& name, Search search)
{
	cut::Cutter cutter(gridNamed(name));
	sweep(state, cutter, search, 1);
}

void gpuCut(benchmark::State& state, const std::string& name, Search search, int sheets)
{
	Result<std::unique_ptr<gpu::Device>> device = gpu::Device::create({});
	if (!device)
		return state.SkipWithError(device.error().message.c_str());
	Result<std::unique_ptr<cut::Cutter>> cutter = cut::Cutter::onDevice(**device, gridNamed(name), {}, nullptr);
	if (!cutter)
		return state.SkipWithError(cutter.error().message.c_str());
	state.SetLabel((*device)->name());
	sweep(state, **cutter, search, sheets);
}

void windowCut(benchmark::State& state, const std::string& name)
{
	cut::Cutter cutter(gridNamed(name));
	std::vector<std::optional<probe::Window>> windows;
	for (const probe::Frame& plane : sweepOf(cutter.blocks().bounds()))
	{
		cut::CutRequest request;
		request.probe.sheets = sheetsAt(plane, 1);
		const Result<cut::Cut> slice = cutter.cut(request);
		windows.push_back(middleOf(request.probe.sheets[0], slice->mesh(cutter.blocks(), 0)));
	}
	sweep(state, cutter, Search::fastest, 1, windows);
}

void firstCut(benchmark::State& state, const std::string& name)
{
	const grid::Block& block = listedNamed(name).blocks[0];
	const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&block.grid);
	for (auto _ : state)
	{
		grid::BlockSet blocks;
		grid::Block& made = blocks.blocks.emplace_back();
		if (unstructured)
			made.grid = grid::UnstructuredGrid::listed(unstructured->coordinates(), *unstructured->list());
		else
			made.grid = block.grid; // which shares the points
		grid::finishBlock(made);
		cutOnce(blocks);
	}
}

void buildGrid(benchmark::State& state, const std::string& name, bool shuffled)
{
	const ReadCells read = readCells(std::get<grid::UnstructuredGrid>(gridNamed(name).blocks[0].grid), shuffled);
	for (auto _ : state)
	{
		const auto grid = grid::UnstructuredGrid::build(read.points, read.cells);
		benchmark::DoNotOptimize(grid.cellCount());
	}
}

void memory(benchmark::State& state, const std::string& program, const std::string& name)
{
	std::optional<nlohmann::json> figures;
	for (auto _ : state)
		figures = profile(program + " profile demo:" + name + " --classify cpu --planes 4 --no-floor --json -");
	if (!figures)
		return state.SkipWithError("vprobe profile failed");
	const nlohmann::json& parts = figures->at("memory_bytes");
	state.counters["extra_per_cell"] = parts.at("extra").get<double>() / figures->at("grid").at("cells").get<double>();
}

void frames(benchmark::State& state, const std::string& program, const std::string& name)
{
	std::optional<nlohmann::json> figures;
	for (auto _ : state)
		figures = profile(program + " profile demo:" + name +
		                  " --probe paddlewheel --vanes 3 --opacity 0.6 --samples 1 --size 1280x720 --classify auto "
		                  "--draw --no-floor --json -");
	if (!figures)
		return state.SkipWithError("vprobe profile failed");
	state.counters["frame_ms"] = figures->at("frame_ms").at("median").get<double>();
}

} // namespace vp::bench
