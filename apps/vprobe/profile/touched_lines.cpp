#include "profile/touched_lines.h"

#include "grid/cell_shape.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace vp::app
{

namespace
{

constexpr std::uint64_t kLine = 64;

// Arrays of a block.
enum class BlockArray : std::uint32_t
{
	points,
	records,
	marks,
	ranks,
	groups,
	heads,
	count
};

template <class Values>
double sizeOf(const Values& values)
{
	return static_cast<double>(values.size() * sizeof(values[0]));
}

// Only what is in the mesh when it is done; memory that grew meanwhile was written more often.
double bytesOf(const mesh::SheetMesh& mesh)
{
	return sizeOf(mesh.positions) + sizeOf(mesh.edges) + sizeOf(mesh.rim_shares) + sizeOf(mesh.polygon_starts) +
	       sizeOf(mesh.polygon_vertices) + sizeOf(mesh.polygon_cells);
}

// Bytes that a grid holds for each of its points.
template <class G>
std::uint64_t pointSize(const G& grid)
{
	if constexpr (requires { grid.coordinates().isDouble(); })
		return grid.coordinates().isDouble() ? 24 : 12;
	else
		return 0;
}

// One stage on one block.
template <class G>
class BlockCount
{
public:
	BlockCount(const G& grid, std::uint32_t block, LineCount& count)
	    : grid_(grid), first_(block * static_cast<std::uint32_t>(BlockArray::count)), count_(count),
	      point_size_(pointSize(grid))
	{
	}

	void point(PointId p)
	{
		if (point_size_)
			touch(BlockArray::points, p * point_size_, point_size_);
	}

	void record(CellId cell)
	{
		if constexpr (std::is_same_v<G, grid::UnstructuredGrid>)
			if (grid_.hasNeighbors())
			{
				const std::uint64_t size = grid_.recordWidth() == 4 ? 32 : 56;
				touch(BlockArray::records, cell * size, size);
			}
	}

	// The search for cells, one by one. They are marked by bits (find/cell_marks.h), or by bytes in generations.
	void search(const find::CellCut& cut)
	{
		const bool has_bits = cut.steps == 0;
		const auto mark = [&](CellId cell)
		{
			if (!has_bits)
				return touch(BlockArray::marks, cell, 1);
			touch(BlockArray::marks, cell / 64 * 8, 8);
			touch(BlockArray::ranks, cell / 64 * 4, 4);
			touch(BlockArray::groups, cell / 4096 * 8, 8);
		};
		for (const CellId cell : cut.cells)
		{
			record(cell);
			for (const PointId p : grid_.cellPoints(cell))
				point(p);
			mark(cell);
		}
		constexpr double kQueue = sizeof(CellId);
		constexpr double kFound = 8.0; // cell and code, as they are found
		const double cells = static_cast<double>(cut.cells.size());
		count_.touchAll(sizeOf(cut.cells) + sizeOf(cut.codes) + (kQueue + kFound) * cells);
	}

	// The search for runs of cells. Signs are taken of four columns of four points at once.
	void search(const find::SpanCut& cut)
	{
		if constexpr (std::is_base_of_v<grid::Lattice, G>)
		{
			const auto [ni, nj, nk] = grid_.points();
			for (const find::Span& span : cut.spans)
			{
				const std::uint32_t k = span.row / nj;
				const std::uint32_t j = span.row - k * nj;
				if (j + 1 >= nj || k + 1 >= nk)
					continue;
				const std::uint32_t from = span.begin / 4 * 4;
				const std::uint32_t to = std::min(span.end / 4 * 4 + 4, ni);
				for (const std::uint32_t row : {span.row, span.row + 1, span.row + nj, span.row + nj + 1})
				{
					if (!point_size_)
						continue;
					touch(BlockArray::points, (std::uint64_t(row) * ni + from) * point_size_,
					      (to - from) * point_size_);
					touch(BlockArray::heads, row * 8, 8);
				}
			}
			constexpr double kRecord = sizeof(find::Span) + 8.0;
			const double found = sizeOf(cut.spans) + sizeOf(cut.columns);
			if (point_size_) // first as they are found (find/span_store.h), then in order
				count_.touchAll(found + kRecord * static_cast<double>(cut.spans.size()) + sizeOf(cut.columns));
			else // where the signs of each row change, and lists of parts (find/rows.h), which leave memory behind as
			     // they grow
				count_.touchAll(2.5 * found + 4.0 * nj * nk);
		}
	}

	// The mesh is made in parts (mesh/mesh_chunk.h), which stay until all are there. The memory in which a part is made
	// serves the next one.
	void emit(const find::CellCut& cut, const mesh::SheetMesh& mesh)
	{
		for (std::size_t i = 0; i < cut.cells.size(); ++i)
			if (cut.codes[i] & shared::kCodeCut)
				record(cut.cells[i]);
		count_.touchAll(sizeOf(cut.cells) + sizeOf(cut.codes));
		if (cut.cut_cells == 0)
			return;
		constexpr double kPartCells = 2048.0;
		const double parts = static_cast<double>(cut.cut_cells) / kPartCells;
		const double vertices = static_cast<double>(mesh.edges.size());
		const double corners = static_cast<double>(mesh.polygon_vertices.size());
		const double polygons = static_cast<double>(mesh.polygons());
		count_.touchAll(8.0 * vertices + 4.0 * corners + 8.0 * polygons);
		const double of_part = 1.0 / std::max(1.0, parts);
		const double slots = std::exp2(std::ceil(std::log2(2.0 * of_part * corners + 64.0)));
		constexpr double kVertex = 36.0; // place, share of the edge, number
		count_.touchAll(of_part * (8.0 * corners + kVertex * vertices) + 4.0 * slots);
	}
	void emit(const find::SpanCut& cut, const mesh::SheetMesh&)
	{
		constexpr double kOwned = 16.0; // numbers of the vertices that a column's point owns
		count_.touchAll(sizeOf(cut.spans) + sizeOf(cut.columns) + kOwned * static_cast<double>(cut.columns.size()));
	}

private:
	void touch(BlockArray array, std::uint64_t at, std::uint64_t size)
	{
		count_.touch(first_ + static_cast<std::uint32_t>(array), at, size);
	}

	const G& grid_;
	std::uint32_t first_; // number of the first array
	LineCount& count_;
	std::uint64_t point_size_;
};

template <class Use>
void forBlock(const grid::BlockSet& blocks, std::size_t number, LineCount& count, const Use& use)
{
	std::visit([&](const auto& grid) { use(BlockCount(grid, static_cast<std::uint32_t>(number), count)); },
	           blocks.blocks[number].grid);
}

Touched traversed(const grid::BlockSet& blocks, const cut::SheetCut& sheet)
{
	LineCount count;
	for (std::size_t b = 0; b < sheet.cuts.size(); ++b)
		forBlock(blocks, b, count,
		         [&](auto block) { std::visit([&](const auto& found) { block.search(found); }, sheet.cuts[b].found); });
	return count.result();
}

Touched emitted(const grid::BlockSet& blocks, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh)
{
	LineCount count;
	for (std::size_t b = 0; b < sheet.cuts.size(); ++b)
		forBlock(blocks, b, count,
		         [&](auto block)
		         {
			         std::visit([&](const auto& found) { block.emit(found, mesh); }, sheet.cuts[b].found);
			         for (const mesh::EdgePoint& edge : mesh.edges)
				         if (edge.block == b)
				         {
					         block.point(edge.lower);
					         block.point(edge.higher);
				         }
		         });
	count.touchAll(bytesOf(mesh));
	return count.result();
}

} // namespace

Touched& Touched::operator+=(const Touched& more)
{
	lines += more.lines;
	runs += more.runs;
	return *this;
}

void LineCount::touch(std::uint32_t array, std::uint64_t at, std::uint64_t size)
{
	if (size == 0)
		return;
	const std::uint64_t base = std::uint64_t(array) << 48;
	for (std::uint64_t line = base + at / kLine; line <= base + (at + size - 1) / kLine; ++line)
		if (line != last_)
			lines_.push_back(last_ = line);
}

void LineCount::touchAll(double size)
{
	if (size > 0.0)
		whole_ += {std::ceil(size / kLine), 1.0};
}

Touched LineCount::result()
{
	std::ranges::sort(lines_);
	lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
	Touched all = whole_;
	for (std::size_t i = 0; i < lines_.size(); ++i)
		all += {1.0, i == 0 || lines_[i] != lines_[i - 1] + 1 ? 1.0 : 0.0};
	return all;
}

std::map<std::string, Touched, std::less<>> touchedBy(const grid::BlockSet& blocks, const session::Frame& frame)
{
	std::map<std::string, Touched, std::less<>> stages;
	const grid::BlockSet& cut_blocks = frame.slice.blocksOf(blocks); // curved cells are cut in parts
	for (std::size_t s = 0; s < frame.slice.sheets.size(); ++s)
	{
		stages["traverse"] += traversed(cut_blocks, frame.slice.sheets[s]);
		stages["emit"] += emitted(cut_blocks, frame.slice.sheets[s], frame.sheets[s].mesh);
	}
	return stages;
}

} // namespace vp::app
