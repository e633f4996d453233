#include "find/rows.h"

#include "base/raw_vector.h"
#include "find/column_word.h"
#include "find/straight_window.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <optional>

namespace vp::find
{

namespace
{

// Finds the spans layer by layer, on all cores.
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
		const CellRange k_range = range_[2];
		changes_.resize(std::size_t(points_[1]) * points_[2]);
		// Besides its own rows of points, a row of cells has the rows just beyond, whose points own edges of its cells.
		forLayers(k_range.begin, std::min(k_range.end + 2, points_[2]), [&](std::uint32_t k) { findChanges(k); });
		std::vector<SpanCut> layers(points_[2]);
		forLayers(k_range.begin, k_range.end + 1, [&](std::uint32_t k) { addLayer(k, layers[k]); });
		return join(layers);
	}

private:
	template <class Work>
	static void forLayers(std::uint32_t begin, std::uint32_t end, Work&& work)
	{
		tbb::parallel_for(tbb::blocked_range<std::uint32_t>(begin, end, 4),
		                  [&](const auto& range)
		                  {
			                  for (std::uint32_t k = range.begin(); k < range.end(); ++k)
				                  work(k);
		                  });
	}

	// The same as Plane::signedDistance() of a point: the same terms, added in the same order.
	double distance(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
	{
		return (terms_[0][i] + terms_[1][j]) + terms_[2][k];
	}
	// For each row of points of a layer: the first point on the same side as the row's end, points_[0] if there is
	// none.
	void findChanges(std::uint32_t k)
	{
		std::uint32_t* changes = &changes_[std::size_t(k) * points_[1]];
		const std::uint32_t end = std::min(range_[1].end + 2, points_[1]);
		for (std::uint32_t j = range_[1].begin; j < end; ++j)
			changes[j] = changeOf(j, k);
	}
	std::uint32_t changeOf(std::uint32_t j, std::uint32_t k) const
	{
		const auto isBehind = [&](std::uint32_t i) { return (distance(i, j, k) >= 0.0) == rises_; };
		std::uint32_t before = 0;
		std::uint32_t behind = cells_[0];
		if (isBehind(before))
			return 0;
		if (!isBehind(behind))
			return points_[0];
		// If the points are evenly spaced, it is one of the two beside the guess.
		const double guess = -distance(0, j, k) * points_per_distance_;
		for (std::uint32_t i = static_cast<std::uint32_t>(std::clamp(guess, 0.0, double(cells_[0])));
		     behind - before > 1; i = (before + behind) / 2)
		{
			for (const std::uint32_t probe : {i, i + 1})
				if (probe > before && probe < behind)
					(isBehind(probe) ? behind : before) = probe;
		}
		return behind;
	}

	// Adds the spans of the rows of points (j, k) for all j. Rows beyond the last cells take the span of the rows
	// before them. Points that do not exist take the signs of those before them.
	void addLayer(std::uint32_t k, SpanCut& cut) const
	{
		const std::uint32_t cell_k = std::min(k, cells_[2] - 1);
		for (std::uint32_t j = range_[1].begin; j <= range_[1].end; ++j)
		{
			const std::uint32_t cell_j = std::min(j, cells_[1] - 1);
			const std::uint32_t* near = &changes_[std::size_t(cell_k) * points_[1] + cell_j];
			const std::uint32_t* far = near + points_[1];
			const auto [least, most] = std::minmax({near[0], near[1], far[0], far[1]});
			if (most == 0 || least == points_[0])
				continue;
			const std::uint32_t begin = std::max(least > 0 ? least - 1 : 0, range_[0].begin);
			const std::uint32_t end = std::min(most, range_[0].end);
			if (begin >= end)
				continue;
			const std::uint32_t next_j = std::min(j + 1, cells_[1]);
			const std::uint32_t next_k = std::min(k + 1, cells_[2]);
			const auto change = [&](std::uint32_t row_j, std::uint32_t row_k)
			{ return changes_[std::size_t(row_k) * points_[1] + row_j]; };
			const std::array<std::uint32_t, 4> rows = {change(j, k), change(next_j, k), change(j, next_k),
			                                           change(next_j, next_k)};
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
		for (std::uint32_t x = 0; x < count; x += ColumnWord::kMaxCells)
			ColumnWord::ofRows(changes, rises_, span.begin + x).writeCases(columns + x);
		const unsigned last = ColumnWord::ofRows(changes, rises_, span.end).column(0);
		columns[count] = static_cast<cases::ColumnCase>(last | last << 4);
		std::size_t left_out = 0;
		if (has_cells && window_)
			for (std::uint32_t x = 0; x < count; ++x)
				if (!window_->meets(span.begin + x, span.row))
				{
					columns[x] |= cases::kLeftOut;
					++left_out;
				}
		for (std::uint32_t x = 0; x < count; ++x)
		{
			const CellSums sums = sums_[columns[x]];
			cut.counts.vertices += sums.vertices();
			if (has_cells)
				cut.counts += {0, sums.polygons(), sums.corners()};
		}
		cut.counts.vertices += sums_[columns[count]].vertices();
		if (has_cells)
			cut.cells += {count, count - left_out, 0};
		cut.columns.resize(span.columns + count + 1);
		cut.spans.push_back(span);
	}

	static SpanCut join(const std::vector<SpanCut>& layers)
	{
		// The begin of each layer's part.
		std::vector<SpanCounts> counts(layers.size());
		std::vector<std::uint32_t> spans(layers.size());
		std::vector<std::uint32_t> columns(layers.size());
		SpanCut cut;
		std::uint32_t span = 0;
		std::uint32_t column = 0;
		for (std::size_t k = 0; k < layers.size(); ++k)
		{
			counts[k] = cut.counts;
			spans[k] = span;
			columns[k] = column;
			cut.counts += layers[k].counts;
			cut.cells += layers[k].cells;
			span += static_cast<std::uint32_t>(layers[k].spans.size());
			column += static_cast<std::uint32_t>(layers[k].columns.size());
		}
		cut.spans.resize(span);
		cut.columns.resize(column);
		tbb::parallel_for(std::size_t(0), layers.size(),
		                  [&](std::size_t k)
		                  {
			                  std::ranges::copy(layers[k].columns, cut.columns.begin() + columns[k]);
			                  auto to = cut.spans.begin() + spans[k];
			                  for (Span moved : layers[k].spans)
			                  {
				                  moved.columns += columns[k];
				                  moved.counts += counts[k];
				                  *to++ = moved;
			                  }
		                  });
		return cut;
	}

	std::array<std::uint32_t, 3> points_;
	std::array<std::uint32_t, 3> cells_;
	std::optional<StraightWindow<G>> window_;
	std::array<CellRange, 3> range_; // of the cells that may be cut where it counts
	const std::array<CellSums, cases::kColumnCases>& sums_ = cellSums();
	std::array<std::vector<double>, 3> terms_; // of the distance, per axis
	bool rises_ = true;                        // the distance along i
	double points_per_distance_ = 0.0;         // along i, on the mean
	RawVector<std::uint32_t> changes_;         // per row of points
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
