#include "grid/block.h"

#include <algorithm>

namespace vp::grid
{

namespace
{

std::size_t cellsOf(const Block& block)
{
	return std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid);
}

std::size_t gridPoints(const Block& block)
{
	return std::visit([](const auto& grid) { return grid.pointCount(); }, block.grid);
}

} // namespace

void replaceFields(Block& block, std::vector<Field> fields)
{
	block.fields = std::move(fields);
	for (Field& field : block.fields)
		field.categorical = namesCategories(field);
}

bool hasNeighbors(const Block& block)
{
	const auto* grid = std::get_if<UnstructuredGrid>(&block.grid);
	return !grid || grid->hasNeighbors();
}

bool hasNeighbors(const BlockSet& blocks)
{
	return std::ranges::all_of(blocks.blocks, [](const Block& block) { return hasNeighbors(block); });
}

namespace
{

template <class Visit>
void forEachStored(const BlockSet& blocks, Visit&& visit)
{
	for (const Block& block : blocks.blocks)
		for (const Field& field : block.fields)
			if (field.stored)
				visit(*field.stored);
}

} // namespace

bool staysInFile(const BlockSet& blocks)
{
	bool stays = false;
	forEachStored(blocks, [&](const parts::PartStore&) { stays = true; });
	return stays;
}

std::optional<parts::PartUse> partUse(const BlockSet& blocks)
{
	std::optional<parts::PartUse> sum;
	const auto include = [&](const parts::PartUse& use)
	{
		if (!sum)
			sum.emplace();
		sum->include(use);
	};
	forEachStored(blocks, [&](const parts::PartStore& store) { include(store.use()); });
	for (const Block& block : blocks.blocks)
		if (block.runs)
			include(block.runs->use());
		else if (block.whole)
			include(block.whole->parts);
	return sum;
}

std::int64_t cellNumber(const Block& block, CellId cell)
{
	const std::size_t source =
	    std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); }, block.grid);
	return block.whole ? static_cast<std::int64_t>(block.whole->cell_numbers.value(source, 0))
	                   : static_cast<std::int64_t>(source);
}

bool lacksParts(const BlockSet& blocks)
{
	return std::ranges::any_of(blocks.blocks, [](const Block& block) { return block.runs != nullptr; });
}

bool hasTimeInRuns(const BlockSet& blocks, std::size_t time)
{
	const auto hasIt = [&](const Block& block) { return block.runs && block.runs->times() == blocks.times.size(); };
	return time < blocks.times.size() && std::ranges::all_of(blocks.blocks, hasIt);
}

void leaveFile(Block& block)
{
	auto whole = std::make_shared<WholeGrid>(*block.whole);
	whole->parts = block.runs->use();
	block.whole = std::move(whole);
	block.runs.reset();
	for (Field& field : block.fields)
		field.is_in_runs = false;
}

void readAllParts(BlockSet& blocks)
{
	for (Block& block : blocks.blocks)
		if (block.runs)
		{
			const std::vector<std::uint32_t> all = block.runs->all();
			block.runs->fetch(all);
			if (block.runs->isShare()) // it has room for cells that it does not have
				block = linkedRuns(block, all);
			else
				leaveFile(block);
		}
}

void startCountingParts(const BlockSet& blocks)
{
	forEachStored(blocks, [](const parts::PartStore& store) { store.startCounting(); });
}

bool knowsSeams(const BlockSet& blocks)
{
	return blocks.matches_seams && hasNeighbors(blocks);
}

bool isComplete(const BlockSet& blocks)
{
	return knowsSeams(blocks) && std::ranges::all_of(blocks.blocks, &Block::knows_folds);
}

const BlockTree& treeOf(const Block& block)
{
	return std::visit([&](const auto& grid) -> const BlockTree& { return block.tree->over(grid); }, block.grid);
}

std::size_t BlockSet::cellCount() const
{
	std::size_t count = 0;
	for (const Block& block : blocks)
		count += cellsOf(block);
	return count;
}

std::size_t BlockSet::pointCount() const
{
	std::size_t count = 0;
	for (const Block& block : blocks)
		count += gridPoints(block);
	return count;
}

std::size_t BlockSet::sourceCellCount() const
{
	std::size_t count = 0;
	for (const Block& block : blocks)
	{
		const auto* grid = std::get_if<UnstructuredGrid>(&block.grid);
		count += grid ? grid->sourceCellCount() : cellsOf(block);
	}
	return count;
}

std::size_t BlockSet::sourcePointCount() const
{
	std::size_t count = 0;
	for (const Block& block : blocks)
	{
		const auto* grid = std::get_if<UnstructuredGrid>(&block.grid);
		count += grid ? grid->sourcePointCount() : gridPoints(block);
	}
	return count;
}

Box BlockSet::bounds() const
{
	Box box;
	for (const Block& block : blocks)
		box.include(block.bounds);
	return box;
}

Imaging BlockSet::imaging() const
{
	const auto is_same = [this](const Block& block) { return block.imaging == blocks.front().imaging; };
	return !blocks.empty() && std::ranges::all_of(blocks, is_same) ? blocks.front().imaging : Imaging{};
}

const char* BlockSet::kind() const
{
	// In the order of AnyGrid.
	constexpr const char* kinds[] = {"image", "rectilinear", "curvilinear", "unstructured"};
	constexpr std::size_t unstructured = 3;
	const auto isUnstructured = [](const Block& block) { return block.grid.index() == unstructured; };
	if (std::ranges::all_of(blocks, isUnstructured))
		return kinds[unstructured];
	if (std::ranges::any_of(blocks, isUnstructured))
		return "hybrid";
	return blocks.size() == 1 ? kinds[blocks[0].grid.index()] : "block-structured";
}

} // namespace vp::grid
