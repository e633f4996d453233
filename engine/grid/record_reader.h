#pragma once

#include "base/prefetch.h"
#include "grid/unstructured.h"

namespace vp::grid
{

// Reads an unstructured grid in a loop over cells. The compiler knows what is the same for all cells: the number of ids
// in a record, and the type of the coordinates. See readRecords().
template <int kWidth, class Number>
class RecordReader
{
public:
	static constexpr bool kTetrahedra = kWidth == 4; // alone

	explicit RecordReader(const UnstructuredGrid& grid)
	    : records_(grid.records().data()), xyz_(grid.coordinates().numbers<Number>())
	{
	}

	// Returns the ids of a cell's points, kWidth of them, and behind them what is across its faces.
	const std::uint32_t* record(CellId c) const { return records_ + std::size_t(c) * kStride; }
	static const std::uint32_t* across(const std::uint32_t* record) { return record + kWidth; }
	static CellShape shape(const std::uint32_t* record)
	{
		if constexpr (kWidth == 4)
			return CellShape::tetrahedron;
		else
		{
			const std::uint32_t last = record[kWidth - 1];
			return last >= UnstructuredGrid::kShapeMark ? static_cast<CellShape>(last - UnstructuredGrid::kShapeMark)
			                                            : CellShape::hexahedron;
		}
	}
	const Number* xyz(PointId p) const { return xyz_ + 3 * std::size_t(p); }
	Vec3 point(PointId p) const { return loadPoint(xyz(p)); }

	// Fetch what reading a cell will need: first its record, and some time later the points in it.
	void prefetchCell(CellId c) const
	{
		vp::prefetch(record(c));
		if constexpr (kWidth == 8) // most records reach into a second cache line
			vp::prefetch(record(c) + kStride - 1);
	}
	void prefetchPoints(CellId c) const
	{
		const std::uint32_t* ids = record(c);
		for (int v = 0; v < kWidth; ++v)
			vp::prefetch(xyz(ids[v])); // an entry may be a mark, not an id: any address does no harm
	}

private:
	static constexpr std::size_t kStride = kWidth == 4 ? 8 : 14;

	const std::uint32_t* records_;
	const Number* xyz_;
};

// Calls use(reader) with the reader for this grid.
template <class Use>
decltype(auto) readRecords(const UnstructuredGrid& grid, Use&& use)
{
	const bool is_double = grid.coordinates().isDouble();
	if (grid.recordWidth() == 4)
		return is_double ? use(RecordReader<4, double>(grid)) : use(RecordReader<4, float>(grid));
	return is_double ? use(RecordReader<8, double>(grid)) : use(RecordReader<8, float>(grid));
}

} // namespace vp::grid
