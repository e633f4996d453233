#include "traverse/cell_flood.h"

#include "traverse/flood_sharing.h"

#include <bit>
#include <mutex>
#include <vector>

namespace vp::traverse
{

namespace
{

struct WordOf
{
	CellId cell;
	std::uint32_t word;
};

class CellFlooder
{
public:
	CellFlooder(const grid::UnstructuredGrid& grid, const surface::Plane& plane, CellMarks& marks)
	    : grid_(grid), plane_(plane), marks_(marks)
	{
	}

	void follow(std::vector<CellId>& queue, std::size_t at)
	{
		if (at + kAhead < queue.size())
			grid_.prefetchCell(queue[at + kAhead]);
		if (at + kAhead / 2 < queue.size())
			grid_.prefetchPoints(queue[at + kAhead / 2]);
		const CellId cell = queue[at];
		const grid::CellShape shape = grid_.shape(cell);
		std::uint32_t word =
		    shape == grid::CellShape::polyhedron ? shared::kWordWalk : classifyByTable(grid_, plane_, cell, shape);
		const auto enter = [&](CellId neighbour)
		{
			if (marks_.mark(neighbour))
				queue.push_back(neighbour);
		};
		if (word & shared::kWordWalk)
		{
			word = classifyByWalk(grid_, plane_, cell, faces_);
			if (word & shared::kWordCut)
				for (int f = 0; f < faces_.size(); ++f)
					if (isFaceCut(grid_, plane_, faces_[f]))
						grid_.forEachNeighbour(cell, f, enter);
		}
		else if (word & shared::kWordCut)
			for (std::uint32_t bits = (word >> shared::kWordFacesShift) & 0xFFu; bits; bits &= bits - 1)
				grid_.forEachNeighbour(cell, std::countr_zero(bits), enter);
		words_.push_back({cell, word});
	}

	std::vector<WordOf> takeWords() { return std::move(words_); }

private:
	static constexpr std::size_t kAhead = 24; // cells, whose record is fetched; their points at half the way

	const grid::UnstructuredGrid& grid_;
	const surface::Plane& plane_;
	CellMarks& marks_;
	grid::CellFaces faces_;
	std::vector<WordOf> words_;
};

} // namespace

LaneCut floodCells(const grid::UnstructuredGrid& grid, const surface::Plane& plane, std::span<const CellId> seeds,
                   CellMarks& marks)
{
	std::vector<CellId> first;
	for (const CellId seed : seeds)
		if (marks.mark(seed))
			first.push_back(seed);

	std::mutex mutex;
	std::vector<std::vector<WordOf>> words;
	shareFlood(std::span<const CellId>(first),
	           [&](FloodQueue<CellId>& queue)
	           {
		           CellFlooder flooder(grid, plane, marks);
		           queue.run([&](std::vector<CellId>& cells, std::size_t at) { flooder.follow(cells, at); });
		           const std::lock_guard lock(mutex);
		           words.push_back(flooder.takeWords());
	           });

	LaneCut cut;
	cut.cells = marks.list();
	cut.words.resize(cut.cells.size());
	for (const std::vector<WordOf>& of_thread : words)
		for (const WordOf& known : of_thread)
		{
			cut.words[marks.rank(known.cell)] = known.word;
			cut.cut_cells += (known.word & shared::kWordCut) != 0;
		}
	marks.clear();
	return cut;
}

} // namespace vp::traverse
