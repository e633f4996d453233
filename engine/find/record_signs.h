#pragma once

#include "grid/record_reader.h"
#include "surface/sign_filter.h"

namespace vp::find
{

// S at the points of a cell's record, the same bits as isPositive().
template <int kWidth, class Number>
class RecordSigns
{
public:
	using Reader = grid::RecordReader<kWidth, Number>;

	// bounds: of the points.
	RecordSigns(const Reader& reader, const surface::Plane& plane, const Box& bounds)
	    : reader_(reader), plane_(plane), filter_(plane, bounds)
	{
	}

	// Bit v: S at point v of the cell, which is of a table shape.
	unsigned of(const std::uint32_t* record, grid::CellShape shape) const
	{
		const unsigned low = four(record[0], record[1], record[2], record[3]);
		if constexpr (kWidth == 4)
			return low != surface::SignFilter::kInDoubt ? low : inDouble(record, 4);
		// A shape of fewer points has ids to spare, but for the last one, which is a mark.
		const bool full = shape == grid::CellShape::hexahedron;
		const unsigned high = four(record[4], record[5], record[6], full ? record[7] : record[6]);
		if (low != surface::SignFilter::kInDoubt && high != surface::SignFilter::kInDoubt)
			return (low | high << 4) & ((1u << grid::topology(shape).points) - 1);
		return inDouble(record, grid::topology(shape).points);
	}

private:
	unsigned inDouble(const std::uint32_t* record, int points) const
	{
		unsigned bits = 0;
		for (int v = 0; v < points; ++v)
			bits |= static_cast<unsigned>(plane_.signedDistance(reader_.point(record[v])) >= 0.0) << v;
		return bits;
	}

	unsigned four(PointId a, PointId b, PointId c, PointId d) const
	{
		return filter_.four(surface::gatherFour({reader_.xyz(a), reader_.xyz(b), reader_.xyz(c), reader_.xyz(d)}));
	}

	const Reader& reader_;
	const surface::Plane& plane_;
	surface::SignFilter filter_;
};

} // namespace vp::find
