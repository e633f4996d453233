#include "gpu/vulkan.h"

#include "render/passes/raster_side.h"

#include "classify/gpu_records.h"
#include "gpu/commands.h"
#include "render/passes/layer_pass.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace vp::render
{

namespace
{

constexpr std::uint32_t kSquares = 256; // a side of the sheet; together a page of records
constexpr int kRuns = 4;                // the first of each way compiles

Result<Scene> sceneOfSquares(gpu::Device& device)
{
	std::vector<shared::PolygonRecord> records;
	const auto at = [](std::uint32_t i) { return static_cast<float>(i) / kSquares - 0.5f; };
	for (std::uint32_t j = 0; j < kSquares; ++j)
		for (std::uint32_t i = 0; i < kSquares; ++i)
			records.push_back(
			    {0, 4, {at(i), at(j), at(i + 1), at(j), at(i + 1), at(j + 1), at(i), at(j + 1)}, {0.0f, 1.0f, 2.0f}});
	auto on_device = classify::recordsFromHost(classify::RecordPool::create(device), records);
	if (!on_device)
		return on_device.error();
	Scene scene;
	scene.look.width = scene.look.height = 2 * kSquares;
	scene.sheets.push_back({probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), *on_device, 1.0});
	scene.camera.position = {0.0, 0.0, 3.0};
	scene.camera.vertical_field = 20.0;
	scene.camera.near = 1.0;
	return scene;
}

// The best of some runs, in seconds.
Result<double> timeOf(gpu::Device& device, const Scene& scene, std::uint32_t side)
{
	auto targets = Targets::create(device, PicturePart::whole({scene.look.width, scene.look.height}), 1, false);
	if (!targets)
		return targets.error();
	auto pass = LayerPass::create(device, side);
	if (!pass)
		return pass.error();
	auto commands = gpu::Commands::create(device, "raster side");
	if (!commands)
		return commands.error();
	if (Status ready = pass->prepare(scene, *targets); !ready)
		return ready.error();
	double best = std::numeric_limits<double>::infinity();
	for (int run = 0; run < kRuns; ++run)
	{
		pass->forget();
		auto begun = commands->begin();
		if (!begun)
			return begun.error();
		pass->record(*begun, scene, *targets, {0.0, 0.0});
		const auto start = std::chrono::steady_clock::now();
		if (Status done = commands->submitAndWait(); !done)
			return done.error();
		best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
	}
	return best;
}

} // namespace

Result<std::uint32_t> measuredRasterSide(gpu::Device& device)
{
	const Result<Scene> scene = sceneOfSquares(device);
	if (!scene)
		return scene.error();
	const Result<double> hardware = timeOf(device, *scene, 0);
	if (!hardware)
		return hardware.error();
	const Result<double> computed = timeOf(device, *scene, kRasterSide);
	if (!computed)
		return computed.error();
	return *computed < *hardware ? kRasterSide : 0u;
}

Result<std::uint32_t> suitableRasterSide(gpu::Device& device)
{
	return device.isSoftware() ? Result<std::uint32_t>(kSoftwareRasterSide) : measuredRasterSide(device);
}

} // namespace vp::render
