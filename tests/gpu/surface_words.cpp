#include "surface_words.h"

#include "exhaustive.h"
#include "find/cell_signs.h"

#include <gtest/gtest.h>

#include <numeric>

namespace vp::test
{

namespace
{

// As the CPU classifier has it.
std::vector<std::uint32_t> wordsInDouble(const grid::Block& block, const surface::Curved& surface)
{
	const auto height = [&](const Vec3& p)
	{ return std::visit([&](const auto& kind) { return kind.height(p); }, surface); };
	std::vector<std::uint32_t> codes;
	const auto classify = [&](const auto& grid)
	{
		for (CellId cell = 0; cell < grid.cellCount(); ++cell)
		{
			const grid::CellShape shape = grid.shape(cell);
			if (shape == grid::CellShape::polyhedron)
			{
				codes.push_back(shared::kCodeWalk);
				continue;
			}
			const grid::CellPoints points = grid.cellPoints(cell);
			std::uint32_t index = 0;
			for (int v = 0; v < points.size; ++v)
				index |= std::uint32_t(height(grid.point(points.id[v])) >= 0.0) << v;
			codes.push_back(find::caseCodes(shape)[index]);
		}
	};
	visitGrid(block, classify);
	return codes;
}

} // namespace

SurfaceWords classifyAllCells(classify::GpuBlocks& blocks, std::size_t block, const surface::Curved& surface)
{
	SurfaceWords result;
	const auto none_left = [](std::span<const find::Front>) -> Status
	{
		ADD_FAILURE() << "the CPU was asked";
		return Nothing{};
	};
	const surface::BlockSurface seen =
	    std::visit([](const auto& kind) { return surface::BlockSurface(kind); }, surface);
	const std::vector<surface::BlockSurface> surfaces(blocks.blocks().blocks.size(), seen);
	auto on_gpu = classify::surfaceOnGpu(blocks, surfaces);
	EXPECT_TRUE(on_gpu) << on_gpu.error().message;
	if (!on_gpu)
		return result;
	auto classifier = classify::GpuClassifier::create(blocks, {(*on_gpu)[block]}, none_left, nullptr);
	EXPECT_TRUE(classifier) << classifier.error().message;
	if (!classifier)
		return result;
	const grid::Block& cut = blocks.blocks().blocks[block];
	std::vector<CellId> cells(cellCount(cut));
	std::iota(cells.begin(), cells.end(), CellId(0));
	std::vector<std::uint32_t> codes(cells.size(), 0xDEADBEEFu);
	const find::Front front{0, cells, codes};
	const Status done = (*classifier)->classify({&front, 1});
	EXPECT_TRUE(done) << done.error().message;

	const std::vector<std::uint32_t> expected = wordsInDouble(cut, surface);
	std::size_t wrong = 0;
	for (std::size_t i = 0; i < cells.size(); ++i)
	{
		const bool left = codes[i] == shared::kCodeWalk;
		wrong += !left && codes[i] != expected[i];
		result.walked += left && !(expected[i] & shared::kCodeWalk);
		result.cut += (expected[i] & shared::kCodeCut) != 0;
	}
	EXPECT_EQ(wrong, 0u) << "of " << cells.size() << " cells, of which " << result.walked << " were left open";
	result.cells = cells.size();
	return result;
}

} // namespace vp::test
