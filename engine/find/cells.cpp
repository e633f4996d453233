#include "find/cells.h"

#include "base/parallel_for.h"
#include "base/raw_vector.h"
#include "find/flood_sharing.h"
#include "find/record_signs.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <mutex>
#include <numeric>
#include <vector>

namespace vp::find
{

namespace
{

struct CodedCell
{
	CellId cell;
	std::uint32_t code;
};

// The part of one thread in a flood.
template <int kWidth, class Number>
class CellFlooder
{
public:
	using Reader = grid::RecordReader<kWidth, Number>;

	CellFlooder(const grid::UnstructuredGrid& grid, const Reader& reader, const surface::Plane& plane,
	            const seed::SheetWindow* window, const RecordSigns<kWidth, Number>& signs, CellMarks& marks)
	    : grid_(grid), reader_(reader), plane_(plane), window_(window), signs_(signs), pen_(marks)
	{
		for (int s = 0; s < grid::kTableShapes; ++s)
			codes_of_[s] = caseCodes(static_cast<grid::CellShape>(s));
	}

	void follow(std::vector<CellId>& queue, std::size_t at)
	{
		if (at + kAhead < queue.size())
			reader_.prefetchCell(queue[at + kAhead]);
		if (at + kAhead / 2 < queue.size())
			reader_.prefetchPoints(queue[at + kAhead / 2]);
		const CellId cell = queue[at];
		const std::uint32_t* record = reader_.record(cell);
		const grid::CellShape shape = reader_.shape(record);
		if (kWidth == 8 && shape == grid::CellShape::polyhedron)
			return walk(queue, cell);
		const std::uint32_t code = codes_of_[static_cast<std::size_t>(shape)][signs_.of(record, shape)];
		if (kWidth == 8 && code & shared::kCodeWalk)
			return walk(queue, cell);
		const Reach reach = window_ ? reachOf(cell, record, shape) : Reach::within;
		if (reach == Reach::outside)
			return leaveOut(cell, code);
		unsigned faces = code >> shared::kCodeFacesShift & 0xFFu;
		if (reach == Reach::rim)
			faces = facesWithin(faces);
		enterAcross(queue, cell, reader_.across(record), faces);
		found_.push_back({cell, code});
	}

	RawVector<CodedCell> takeFound() { return std::move(found_); }

private:
	static constexpr std::size_t kAhead = 32; // cells, whose record is fetched; their points at half the way

	unsigned facesWithin(unsigned faces) const
	{
		unsigned within = 0;
		for (unsigned bits = faces; bits; bits &= bits - 1)
			if (const int face = std::countr_zero(bits); window_->meetsFace(grid_, plane_, faces_[face]))
				within |= 1u << face;
		return within;
	}

	// Queues the cells across some faces. Which of them are marked cannot be foreseen: so where every face has a cell
	// across, all are asked, without a branch, and only those that are new are gone through.
	void enterAcross(std::vector<CellId>& queue, CellId cell, const std::uint32_t* across, unsigned faces)
	{
		constexpr int kFaces = kWidth == 4 ? 4 : 6;
		const CellMarks::Pen pen = pen_;
		bool are_cells = true;
		for (int face = 0; face < kFaces; ++face)
			are_cells &= across[face] < kMaxBlockIds;
		if (are_cells) [[likely]]
		{
			unsigned marked = 0;
			for (int face = 0; face < kFaces; ++face)
				marked |= unsigned(pen.isMarked(across[face])) << face;
			faces &= ~marked;
		}
		for (; faces; faces &= faces - 1)
		{
			const int face = std::countr_zero(faces);
			if (across[face] >= kMaxBlockIds) [[unlikely]]
				cross(queue, cell, face);
			else if (pen.mark(across[face]))
				queue.push_back(across[face]);
		}
	}

	void cross(std::vector<CellId>& queue, CellId cell, int face)
	{
		grid_.forEachNeighbor(cell, face,
		                      [&](CellId across)
		                      {
			                      if (pen_.mark(across))
				                      queue.push_back(across);
		                      });
	}
	// Marks a cell whose section lies outside, as the traversal does with cells of generation 0.
	void leaveOut(CellId cell, std::uint32_t code) { found_.push_back({cell, code & (0xFFu | shared::kCodeWalk)}); }

	// Where the section of a cell lies. For most cells the box of the points decides. For cells on the rim faces_ is
	// filled.
	enum class Reach
	{
		outside,
		rim,
		within
	};
	Reach reachOf(CellId cell, const std::uint32_t* record, grid::CellShape shape)
	{
		bool within = true;
		for (int axis = 0; axis < 2; ++axis)
		{
			double low = std::numeric_limits<double>::infinity();
			double high = -low;
			for (int v = 0; v < grid::topology(shape).points; ++v)
			{
				const double along = glm::dot(reader_.point(record[v]) - window_->origin(), window_->axis(axis));
				low = std::min(low, along);
				high = std::max(high, along);
			}
			if (high < window_->lo()[axis] || low > window_->hi()[axis])
				return Reach::outside;
			within = within && low >= window_->lo()[axis] && high <= window_->hi()[axis];
		}
		if (within)
			return Reach::within;
		grid_.cellFaces(cell, faces_);
		return window_->meetsCell(grid_, plane_, faces_) ? Reach::rim : Reach::outside;
	}

	// Handles a cell without an entry in the tables.
	void walk(std::vector<CellId>& queue, CellId cell)
	{
		const std::uint32_t code = classifyByWalk(grid_, plane_, cell, faces_);
		if (window_ && !window_->meetsCell(grid_, plane_, faces_))
			return leaveOut(cell, code);
		if (code & shared::kCodeCut)
			for (int f = 0; f < faces_.size(); ++f)
				if (window_ ? window_->meetsFace(grid_, plane_, faces_[f]) : seed::isFaceCut(grid_, plane_, faces_[f]))
					cross(queue, cell, f);
		found_.push_back({cell, code});
	}

	const grid::UnstructuredGrid& grid_;
	const Reader& reader_;
	const surface::Plane& plane_;
	const seed::SheetWindow* window_;
	const RecordSigns<kWidth, Number>& signs_;
	CellMarks::Pen pen_;
	std::array<const std::uint32_t*, grid::kTableShapes> codes_of_;
	grid::CellFaces faces_;
	RawVector<CodedCell> found_;
};

using Found = std::vector<RawVector<CodedCell>>; // by each part of the work

template <int kWidth, class Number>
Found flood(const grid::UnstructuredGrid& grid, const grid::RecordReader<kWidth, Number>& reader,
            const surface::Plane& plane, const Box& bounds, const seed::SheetWindow* window,
            std::span<const CellId> first, CellMarks& marks)
{
	const RecordSigns<kWidth, Number> signs(reader, plane, bounds);
	std::mutex mutex;
	Found found;
	shareFlood(first,
	           [&](FloodQueue<CellId>& queue)
	           {
		           CellFlooder flooder(grid, reader, plane, window, signs, marks);
		           queue.run([&](std::vector<CellId>& cells, std::size_t at) { flooder.follow(cells, at); });
		           const std::lock_guard lock(mutex);
		           found.push_back(flooder.takeFound());
	           });
	return found;
}

// Some cells may have been found twice.
CellCut inOrder(const Found& found, CellMarks& marks)
{
	const auto forFound = [&](auto&& visit)
	{
		tracedFor(std::size_t(0), found.size(),
		          [&](std::size_t part)
		          {
			          for (const CodedCell& known : found[part])
				          visit(known);
		          });
	};
	forFound([&](const CodedCell& known) { marks.settle(known.cell); });
	CellCut cut;
	cut.cells = marks.list();
	cut.codes.resize(cut.cells.size());
	forFound([&](const CodedCell& known)
	         { std::atomic_ref(cut.codes[marks.rank(known.cell)]).store(known.code, std::memory_order_relaxed); });
	marks.clear();
	for (const std::uint32_t code : cut.codes)
		cut.cut_cells += (code & shared::kCodeCut) != 0;
	return cut;
}

} // namespace

CellCut floodCells(const grid::UnstructuredGrid& grid, const surface::Plane& plane, const Box& bounds,
                   const seed::SheetWindow* window, std::span<const CellId> seeds, CellMarks& marks)
{
	const CellMarks::Pen pen(marks);
	std::vector<CellId> first;
	for (const CellId seed : seeds)
		if (pen.mark(seed))
			first.push_back(seed);
	const Found found = grid::readRecords(grid, [&](const auto& reader)
	                                      { return flood(grid, reader, plane, bounds, window, first, marks); });
	CellCut cut = inOrder(found, marks);
	cut.closed = !grid.hasLinks() && !window;
	return cut;
}

} // namespace vp::find
