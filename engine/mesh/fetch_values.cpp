#include "mesh/fetch_values.h"

#include "base/parallel_for.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace vp::mesh
{

namespace
{

constexpr std::size_t kGrain = 4096;

// Which parts are needed: per block, null where the array is in memory or absent.
class NeededParts
{
public:
	NeededParts(const grid::BlockSet& blocks, std::span<const grid::Field* const> fields)
	    : blocks_(blocks), fields_(fields)
	{
		for (const grid::Field* field : fields)
			needs_.push_back(field && field->stored ? std::make_unique<parts::PartStore::Needs>(*field->stored)
			                                        : nullptr);
	}

	void addPoint(std::uint32_t block, PointId point)
	{
		if (takes(block, grid::Association::point))
			needs_[block]->add(std::visit([&](const auto& grid) { return std::uint64_t(grid.sourcePoint(point)); },
			                              blocks_.blocks[block].grid));
	}
	void addCell(std::uint32_t block, CellId cell)
	{
		if (takes(block, grid::Association::cell))
			needs_[block]->add(std::visit([&](const auto& grid) { return std::uint64_t(grid.sourceCell(cell)); },
			                              blocks_.blocks[block].grid));
	}
	void fetch() const
	{
		for (std::size_t b = 0; b < fields_.size(); ++b)
			if (needs_[b])
				fields_[b]->stored->fetch(*needs_[b]);
	}

private:
	bool takes(std::uint32_t block, grid::Association association) const
	{
		return needs_[block] && fields_[block]->association == association;
	}

	const grid::BlockSet& blocks_;
	std::span<const grid::Field* const> fields_;
	std::vector<std::unique_ptr<parts::PartStore::Needs>> needs_;
};

} // namespace

void fetchValues(const grid::BlockSet& blocks, const SheetMesh& mesh, std::span<const grid::Field* const> fields)
{
	if (std::ranges::none_of(fields, [](const grid::Field* field) { return field && field->stored; }))
		return;
	NeededParts needed(blocks, fields);
	const auto forAll = [](std::size_t count, auto&& add)
	{
		tracedFor(tbb::blocked_range<std::size_t>(0, count, kGrain),
		          [&](const tbb::blocked_range<std::size_t>& some)
		          {
			          for (std::size_t i = some.begin(); i < some.end(); ++i)
				          add(i);
		          });
	};
	forAll(mesh.edges.size(),
	       [&](std::size_t v)
	       {
		       needed.addPoint(mesh.edges[v].block, mesh.edges[v].lower);
		       needed.addPoint(mesh.edges[v].block, mesh.edges[v].higher);
	       });
	forAll(mesh.rim_shares.size(),
	       [&](std::size_t s) { needed.addPoint(mesh.rim_shares[s].block, mesh.rim_shares[s].point); });
	forAll(mesh.polygon_cells.size(),
	       [&](std::size_t p) { needed.addCell(mesh.polygon_cells[p].block, mesh.polygon_cells[p].cell); });
	needed.fetch();
}

} // namespace vp::mesh
