#include "find/rows.h"

#include "base/parallel_for.h"
#include "base/raw_vector.h"
#include "find/column_word.h"
#include "find/straight_window.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <optional>

namespace vp::find
{

namespace
{

// Finds the spans, part by part of the layers, on all cores.
template <class G>
class RowFinder
{
public:
	RowFinder(const G& grid, const surface::Plane& plane, const seed::SheetWindow* sheet_window)
	    : points_(grid.points()), cells_(grid.cells())
	{
		if (sheet_window)
			window_.emplace(grid, plane, *sheet_window);
		for (int axis = 0; axis < 3; ++axis)
			for (std::uint32_t i = 0; i < points_[axis]; ++i)
				terms_[axis].push_back(plane.normal()[axis] * (grid.coordinate(axis, i) - plane.origin()[axis]));
		rises_ = terms_[0].front() <= terms_[0].back();
		const double rise = (terms_[0].back() - terms_[0].front()) / cells_[0];
		points_per_distance_ = rise != 0.0 ? 1.0 / rise : 0.0;
	}

	SpanCut find()
	{
		for (int axis = 0; axis < 3; ++axis)
		{
			range_[axis] = window_ ? window_->cellsAlong(axis) : CellRange{0, cells_[axis]};
			if (range_[axis].begin >= range_[axis].end)
				return {};
		}
		// Besides its own rows of points, a row of cells has the rows just beyond, whose points own edges of its cells.
		const std::size_t first = range_[2].begin;
		const std::size_t layers = range_[2].end + 1 - first;
		constexpr std::size_t kLayersInPart = 12;
		std::vector<SpanCut> parts((layers + kLayersInPart - 1) / kLayersInPart);
		tracedFor(std::size_t(0), parts.size(),
		          [&](std::size_t p)
		          {
			          const auto layerOf = [&](std::size_t part)
			          { return static_cast<std::uint32_t>(first + layers * part / parts.size()); };
			          parts[p] = findPart(layerOf(p), layerOf(p + 1));
		          });
		return join(parts);
	}

private:
	// Where the signs of rows of points change: per row of neighboring layers, the first point on the same side as the
	// row's end, points_[0] if there is none.
	struct Changes
	{
		const std::uint32_t* ofLayer(std::uint32_t k) const { return &changes[std::size_t(k - first) * rows]; }

		std::uint32_t first; // layer
		std::uint32_t rows;  // in a layer
		RawVector<std::uint32_t> changes;
	};

	// The spans of the layers [begin, end) of points.
	SpanCut findPart(std::uint32_t begin, std::uint32_t end) const
	{
		// The layer beyond the cells takes its spans from the layer before it.
		Changes changes{begin < cells_[2] ? begin : begin - 1, points_[1], {}};
		const std::uint32_t behind = std::min(end + 1, points_[2]);
		changes.changes.resize(std::size_t(behind - changes.first) * points_[1]);
		std::uint32_t* of_layer = changes.changes.data();
		for (std::uint32_t k = changes.first; k < behind; ++k, of_layer += points_[1])
			findChanges(k, of_layer);
		SpanCut cut;
		for (std::uint32_t k = begin; k < end; ++k)
			addLayer(k, changes, cut);
		return cut;
	}

	// The same as Plane::signedDistance() of a point: the same terms, added in the same order.
	double distance(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
	{
		return (terms_[0][i] + terms_[1][j]) + terms_[2][k];
	}
	void findChanges(std::uint32_t k, std::uint32_t* changes) const
	{
		const std::uint32_t end = std::min(range_[1].end + 2, points_[1]);
		for (std::uint32_t j = range_[1].begin; j < end; ++j)
			changes[j] = changeOf(j, k);
	}
	std::uint32_t changeOf(std::uint32_t j, std::uint32_t k) const
	{
		const auto isBehind = [&](std::uint32_t i) { return (distance(i, j, k) >= 0.0) == rises_; };
		// If the points are evenly spaced, it is the one behind the guess.
		const double guess = -distance(0, j, k) * points_per_distance_;
		const std::uint32_t next = guess < 0.0         ? 0
		                           : guess < cells_[0] ? static_cast<std::uint32_t>(guess) + 1
		                                               : points_[0];
		if ((next == 0 || !isBehind(next - 1)) && (next == points_[0] || isBehind(next))) [[likely]]
			return next;
		if (isBehind(0))
			return 0;
		std::uint32_t before = 0;
		std::uint32_t behind = points_[0];
		while (behind - before > 1)
		{
			const std::uint32_t i = (before + behind) / 2;
			(isBehind(i) ? behind : before) = i;
		}
		return behind;
	}

	// Adds the spans of the rows of points (j, k) for all j. Rows beyond the last cells take the span of the rows
	// before them. Points that do not exist take the signs of those before them.
	void addLayer(std::uint32_t k, const Changes& changes, SpanCut& cut) const
	{
		const std::uint32_t* const cells_near = changes.ofLayer(std::min(k, cells_[2] - 1));
		const std::uint32_t* const points_near = changes.ofLayer(k);
		const std::uint32_t* const points_far = changes.ofLayer(std::min(k + 1, cells_[2]));
		for (std::uint32_t j = range_[1].begin; j <= range_[1].end; ++j)
		{
			const std::uint32_t cell_j = std::min(j, cells_[1] - 1);
			const std::uint32_t* near = cells_near + cell_j;
			const std::uint32_t* far = near + points_[1];
			const auto [least, most] = std::minmax({near[0], near[1], far[0], far[1]});
			if (most == 0 || least == points_[0])
				continue;
			const std::uint32_t begin = std::max(least > 0 ? least - 1 : 0, range_[0].begin);
			const std::uint32_t end = std::min(most, range_[0].end);
			if (begin >= end)
				continue;
			const std::uint32_t next_j = std::min(j + 1, cells_[1]);
			const std::array<std::uint32_t, 4> rows = {points_near[j], points_near[next_j], points_far[j],
			                                           points_far[next_j]};
			addSpan({k * points_[1] + j, begin, end, 0, {}}, rows, j < cells_[1] && k < cells_[2], cut);
		}
	}

	void addSpan(Span span, const std::array<std::uint32_t, 4>& changes, bool has_cells, SpanCut& cut) const
	{
		const std::uint32_t count = span.end - span.begin;
		span.columns = static_cast<std::uint32_t>(cut.columns.size());
		span.counts = cut.counts;
		cut.columns.resize(span.columns + count + ColumnWord::kColumns);
		cases::ColumnCase* columns = &cut.columns[span.columns];
		constexpr std::uint32_t kCells = ColumnWord::kColumns - 1; // cells of a word
		unsigned last = 0;                                         // column
		for (std::uint32_t x = 0; x < count; x += kCells)
		{
			const ColumnWord word = ColumnWord::ofRows(changes, rises_, span.begin + x);
			word.writeCases(columns + x);
			last = word.column(std::min(count - x, kCells));
		}
		columns[count] = static_cast<cases::ColumnCase>(last | last << 4);
		std::size_t left_out = 0;
		if (has_cells && window_)
			for (std::uint32_t x = 0; x < count; ++x)
				if (!window_->meets(span.begin + x, span.row))
				{
					columns[x] |= cases::kLeftOut;
					++left_out;
				}
		cut.counts.vertices += sums_[columns[count]].vertices();
		for (std::uint32_t x = 0; x < count;)
		{
			std::uint32_t packed = 0;
			for (const std::uint32_t end = std::min(x + kCells, count); x < end; ++x)
				packed += sums_[columns[x]].packed;
			const CellSums sums{packed};
			cut.counts.vertices += sums.vertices();
			if (has_cells)
				cut.counts += {0, sums.polygons(), sums.corners()};
		}
		if (has_cells)
			cut.cells += {count, count - left_out, 0};
		cut.columns.resize(span.columns + count + 1);
		cut.spans.push_back(span);
	}

	static SpanCut join(const std::vector<SpanCut>& parts)
	{
		// Where each part begins.
		std::vector<SpanCounts> counts(parts.size());
		std::vector<std::uint32_t> spans(parts.size());
		std::vector<std::uint32_t> columns(parts.size());
		SpanCut cut;
		std::uint32_t span = 0;
		std::uint32_t column = 0;
		for (std::size_t p = 0; p < parts.size(); ++p)
		{
			counts[p] = cut.counts;
			spans[p] = span;
			columns[p] = column;
			cut.counts += parts[p].counts;
			cut.cells += parts[p].cells;
			span += static_cast<std::uint32_t>(parts[p].spans.size());
			column += static_cast<std::uint32_t>(parts[p].columns.size());
		}
		cut.spans.resize(span);
		cut.columns.resize(column);
		tracedFor(std::size_t(0), parts.size(),
		          [&](std::size_t p)
		          {
			          std::ranges::copy(parts[p].columns, cut.columns.begin() + columns[p]);
			          auto to = cut.spans.begin() + spans[p];
			          for (Span moved : parts[p].spans)
			          {
				          moved.columns += columns[p];
				          moved.counts += counts[p];
				          *to++ = moved;
			          }
		          });
		return cut;
	}

	std::array<std::uint32_t, 3> points_;
	std::array<std::uint32_t, 3> cells_;
	std::optional<StraightWindow<G>> window_;
	std::array<CellRange, 3> range_; // per axis: the cells that may be cut inside the window
	const std::array<CellSums, cases::kColumnCases>& sums_ = cellSums();
	std::array<std::vector<double>, 3> terms_; // terms of the distance, per axis
	bool rises_ = true;                        // the distance grows along i
	double points_per_distance_ = 0.0;         // along i, on average
};

template <class G>
SpanCut find(const G& grid, const surface::Plane& plane, const seed::SheetWindow* window)
{
	return grid.cellCount() == 0 ? SpanCut{} : RowFinder<G>(grid, plane, window).find();
}

} // namespace

SpanCut rowSpans(const grid::UniformGrid& grid, const surface::Plane& plane, const seed::SheetWindow* window)
{
	return find(grid, plane, window);
}

SpanCut rowSpans(const grid::RectilinearGrid& grid, const surface::Plane& plane, const seed::SheetWindow* window)
{
	return find(grid, plane, window);
}

bool hasStraightRows(const grid::RectilinearGrid& grid)
{
	for (int axis = 0; axis < 3; ++axis)
	{
		bool rises = true;
		bool falls = true;
		for (std::uint32_t i = 1; i < grid.points()[axis]; ++i)
		{
			rises = rises && grid.coordinate(axis, i) >= grid.coordinate(axis, i - 1);
			falls = falls && grid.coordinate(axis, i) <= grid.coordinate(axis, i - 1);
		}
		if (!rises && !falls)
			return false;
	}
	return true;
}

} // namespace vp::find
