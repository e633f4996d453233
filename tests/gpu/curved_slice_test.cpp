#include "cut_both_ways.h"
#include "gpu_fixture.h"
#include "surface/gpu_surface.h"
#include "test_grids.h"

#include "base/timeline.h"
#include "classify/gpu_surfaces.h"
#include "cut/cutter.h"

#include <fmt/format.h>

namespace vp::test
{

namespace
{

probe::Sheet sheetOf(const grid::BlockSet& set, const std::string& form)
{
	probe::Sheet sheet = probe::makeSheet(set.bounds().center(), {0.3, 0.5, 0.81});
	sheet.form = *surface::ImplicitSurface::parse(form);
	return sheet;
}

// With a device and without the same cells in the same order, with the same codes. Returns those that were cut.
std::size_t expectSameSlices(gpu::Device& device, const grid::BlockSet& set, const cut::CutRequest& request)
{
	auto on_device = cut::Cutter::onDevice(device, set, request.field, nullptr);
	EXPECT_TRUE(on_device) << on_device.error().message;
	cut::Cutter on_cpu(set);
	const cut::Cut gpu = std::move((*on_device)->cut(request).value());
	const cut::Cut cpu = std::move(on_cpu.cut(request).value());
	std::size_t cut_cells = 0;
	for (std::size_t s = 0; s < request.probe.sheets.size(); ++s)
	{
		CutBothWays cut;
		for (std::size_t b = 0; b < set.blocks.size(); ++b)
		{
			cut.gpu.push_back(gpu.sheets[s].cuts[b].cells());
			cut.cpu.push_back(cpu.sheets[s].cuts[b].cells());
		}
		expectSameCells(cut);
		for (const find::CellCut& lane : cut.gpu)
			cut_cells += lane.cut_cells;
	}
	return cut_cells;
}

} // namespace

using CurvedSlice = GpuTest;

TEST_F(CurvedSlice, IsTheSameWithADevice)
{
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		grid::BlockSet set;
		set.blocks.push_back(block);
		cut::CutRequest request;
		request.in_generations = true;
		request.field = grid::FieldChoice{"linear", grid::Association::point, 0};
		const double size = set.bounds().diagonal();
		request.probe.sheets = {sheetOf(set, fmt::format("sphere:{}", 0.3 * size)), sheetOf(set, "cone:35"),
		                        sheetOf(set, fmt::format("cylinder:{}", 0.2 * size)), sheetOf(set, "iso:0.7"),
		                        sheetOf(set, fmt::format("x^2 + x*y - {}*sin(z) = {}", size, 0.01 * size * size))};
		request.probe.sheets[2].window = probe::Window{-0.2 * size, 0.2 * size, -0.15 * size, 0.15 * size};
		EXPECT_GT(expectSameSlices(device(), set, request), 0u);
	}
}

TEST_F(CurvedSlice, SoItIsOverSeveralBlocks)
{
	grid::BlockSet set;
	for (const char* name : {"shell", "blob", "tets", "hexagonal_prisms"})
		set.blocks.push_back(gridNamed(name));
	cut::CutRequest request;
	request.in_generations = true;
	request.field = grid::FieldChoice{"linear", grid::Association::point, 0};
	request.probe.sheets = {sheetOf(set, "sphere:1.7"), sheetOf(set, "ellipsoid:2,1,3")};
	EXPECT_GT(expectSameSlices(device(), set, request), 100u);
}

TEST_F(CurvedSlice, WhatWouldTakeLongToCompileStaysWithTheCpu)
{
	std::string waves = "x - 2";
	for (int i = 1; i < 150; ++i)
		waves += fmt::format(" + tanh(y*{})/{}", i, 100 * i);
	const surface::BlockSurface of(surface::PlacedExpression(*surface::Expression::parse(waves), {}));
	EXPECT_FALSE(surface::gpuSurfaceOf(of));
	grid::BlockSet set;
	set.blocks.push_back(gridNamed("shell"));
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = {sheetOf(set, waves)};
	request.probe.sheets[0].origin = Vec3(0.0);
	EXPECT_GT(expectSameSlices(device(), set, request), 20u);
}

TEST_F(CurvedSlice, GenerationsAreOnTheTimeline)
{
	if (device().timestampBits() == 0)
		GTEST_SKIP() << device().name() << " has no timestamps";
	grid::BlockSet set;
	set.blocks.push_back(gridNamed("shell"));
	auto cutter = cut::Cutter::onDevice(device(), set, {}, nullptr);
	ASSERT_TRUE(cutter) << cutter.error().message;
	Timeline timeline;
	cut::CutRequest request;
	request.in_generations = true;
	request.timeline = &timeline;
	request.probe.sheets = {sheetOf(set, "sphere:1")};
	ASSERT_TRUE((*cutter)->cut(request));
	EXPECT_GT(timeline.totalGpu(), 0.0);
}

} // namespace vp::test
