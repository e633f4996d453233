// Measures how the shape of a polygon affects its drawing time. Rectangles cover a picture of 1280 x 720, turned to its
// rows, so that shapes of one area are as many polygons and cover as many pixels. Each row is drawn by the compute
// rasterizer and by the device's own. Nothing else may run on the machine.
#include "gpu/vulkan.h"

#include "classify/gpu_records.h"
#include "gpu/commands.h"
#include "render/passes/layer_pass.h"
#include "render/passes/raster_side.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vp::bench
{

namespace
{

using shared::PolygonRecord;

constexpr std::uint32_t kWidth = 1280;
constexpr std::uint32_t kHeight = 720;

gpu::Device& device()
{
	static const std::unique_ptr<gpu::Device> made = []
	{
		auto opened = gpu::Device::create({.validation = false});
		if (!opened)
		{
			fmt::print(stderr, "{}\n", opened.error().message);
			std::exit(3);
		}
		return std::move(*opened);
	}();
	return *made;
}

// A pixel is 1; the picture's middle is the origin. The camera is far away, so places in the sheet are those in the
// picture.
render::Scene facingScene()
{
	render::Scene scene;
	scene.look.width = kWidth;
	scene.look.height = kHeight;
	scene.camera.position = {0.0, 0.0, 1000.0};
	scene.camera.vertical_field = 2.0 * glm::degrees(std::atan(0.5 * kHeight / 1000.0));
	scene.camera.near = 1.0;
	return scene;
}

// Rectangles of `size`, turned by 0.5, that cover the picture.
std::vector<PolygonRecord> rectangles(const glm::dvec2& size)
{
	const double reach = 0.5 * std::hypot(kWidth, kHeight);
	const glm::dvec2 along(std::cos(0.5), std::sin(0.5));
	const glm::dvec2 across(-along.y, along.x);
	const auto seen = [](const glm::dvec2& p) { return std::abs(p.x) < 0.5 * kWidth && std::abs(p.y) < 0.5 * kHeight; };
	std::vector<PolygonRecord> records;
	for (double y = -reach; y < reach; y += size.y)
		for (double x = -reach; x < reach; x += size.x)
		{
			const auto at = [&](double i, double j) { return (x + i * size.x) * along + (y + j * size.y) * across; };
			if (!seen(at(0.5, 0.5)))
				continue;
			PolygonRecord& record = records.emplace_back();
			record.vertices = 4;
			const glm::dvec2 corners[] = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
			for (int i = 0; i < 4; ++i)
			{
				record.uv[2 * i] = static_cast<float>(corners[i].x);
				record.uv[2 * i + 1] = static_cast<float>(corners[i].y);
				record.value[i] = static_cast<float>(i);
			}
		}
	return records;
}

std::uint32_t sideOfComputed()
{
	return device().isSoftware() ? render::kSoftwareRasterSide : render::kRasterSide;
}

void draw(benchmark::State& state, const glm::dvec2& size, std::uint32_t side)
{
	const std::vector<PolygonRecord> records = rectangles(size);
	render::Scene scene = facingScene();
	scene.sheets.push_back({probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}),
	                        classify::recordsFromHost(classify::RecordPool::create(device()), records).value(), 1.0});
	auto targets = render::Targets::create(device(), render::PicturePart::whole({kWidth, kHeight}), 1, false);
	auto pass = render::LayerPass::create(device(), side);
	auto commands = gpu::Commands::create(device(), "bench");
	if (!targets || !pass || !commands || !pass->prepare(scene, *targets))
		return state.SkipWithError("the device draws nothing");
	const auto frame = [&]
	{
		pass->forget();
		const VkCommandBuffer to = commands->begin().value();
		pass->record(to, scene, *targets, {0.0, 0.0});
		return bool(commands->submitAndWait());
	};
	frame(); // compiles
	for (auto _ : state)
		if (!frame())
			return state.SkipWithError("the device was lost");
	const auto per = [&](double count)
	{
		return benchmark::Counter(1e-9 * count,
		                          benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
	};
	state.counters["polygons"] = static_cast<double>(records.size());
	state.counters["ns_polygon"] = per(static_cast<double>(records.size()));
	state.counters["ns_pixel"] = per(static_cast<double>(kWidth) * kHeight);
}

void addRow(const std::string& name, const glm::dvec2& size)
{
	for (const bool computed : {true, false})
		benchmark::RegisterBenchmark(fmt::format("{}/{}", name, computed ? "computed" : "device").c_str(),
		                             [=](benchmark::State& state)
		                             { draw(state, size, computed ? sideOfComputed() : 0); })
		    ->Unit(benchmark::kMillisecond)
		    ->UseRealTime();
}

} // namespace

} // namespace vp::bench

int main(int argc, char** argv)
{
	using namespace vp::bench;
	for (const double side : {1.0, 2.0, 4.0, 8.0, 12.0, 16.0, 24.0, 32.0, 64.0, 256.0})
		addRow(fmt::format("square:{}", side), {side, side});
	for (const double area : {4.0, 16.0, 64.0, 1024.0})
		for (const double aspect : {1.0, 2.0, 10.0, 100.0, 1000.0})
			addRow(fmt::format("area:{}/aspect:{}", area, aspect),
			       {std::sqrt(area * aspect), std::sqrt(area / aspect)});
	addRow("whole", {std::hypot(kWidth, kHeight), std::hypot(kWidth, kHeight)});
	benchmark::Initialize(&argc, argv);
	if (benchmark::ReportUnrecognizedArguments(argc, argv))
		return 1;
	fmt::print("{}\n", device().name());
	benchmark::RunSpecifiedBenchmarks();
	return 0;
}
