#pragma once

#include "cases/lattice_cases.h"

#include <array>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace vp::find
{

// Numbers of vertices, polygons and corners that cells of a lattice add to a mesh. Each is a byte, so that one addition
// adds them all.
struct CellSums
{
	std::uint32_t packed = 0;

	std::uint32_t vertices() const { return packed & 0xFF; }
	std::uint32_t corners() const { return packed >> 8 & 0xFF; }
	std::uint32_t polygons() const { return packed >> 16 & 0xFF; }
	std::uint32_t walked() const { return packed >> 24; }
};

// By ColumnCase: of a cell and the point where it begins; of the point alone where the cell is left out.
inline const std::array<CellSums, cases::kColumnCases>& cellSums()
{
	static const std::array<CellSums, cases::kColumnCases> table = []
	{
		std::array<CellSums, cases::kColumnCases> made;
		for (unsigned c = 0; c < made.size(); ++c)
		{
			const cases::LatticeCase& entry = cases::latticeCases()[c & 0xFF];
			made[c].packed = entry.owned_count;
			if (!(c & cases::kLeftOut))
				made[c].packed |= std::uint32_t(entry.edges) << 8 | std::uint32_t(entry.edges != 0) << 16 |
				                  std::uint32_t(entry.needs_walk) << 24;
		}
		return made;
	}();
	return table;
}

// Columns of a lattice that follow each other along i, four bits each: bit 4 x + r is S at point x of row r. Rows 0 to
// 3 are (j, k), (j + 1, k), (j, k + 1), (j + 1, k + 1). A step with the bits of all cells takes the place of one for
// each. In masks, bit 4 x is that of cell x or column x.
class ColumnWord
{
public:
	static constexpr std::uint32_t kColumns = 16;
	static constexpr std::uint32_t kMaxCells = 12; // in a word that may begin at any column of a quad (see at())

	explicit ColumnWord(std::uint64_t bits) : bits_(bits), along_i_(bits ^ bits >> 4) {}

	// The columns from i on, from quads of four of them.
	static ColumnWord at(const std::uint16_t* quads, std::uint32_t i)
	{
		const std::uint16_t* from = quads + i / 4;
		const std::uint64_t bits = std::uint64_t(from[3]) << 48 | std::uint64_t(from[2]) << 32 |
		                           std::uint64_t(from[1]) << 16 | std::uint64_t(from[0]);
		return ColumnWord(bits >> 4 * (i % 4));
	}

	// The columns from i on, of rows whose points from changes[r] on have S as `rises` says, and those before the
	// other.
	static ColumnWord ofRows(const std::array<std::uint32_t, 4>& changes, bool rises, std::uint32_t i)
	{
		std::uint64_t bits = 0;
		for (int r = 0; r < 4; ++r)
		{
			const std::uint32_t before = changes[r] > i ? changes[r] - i : 0;
			if (before < kColumns)
				bits |= kOnes << 4 * before << r;
		}
		return ColumnWord(rises ? bits : ~bits);
	}

	unsigned column(std::uint32_t x) const { return bits_ >> 4 * x & 15; }

	// The columns of points beyond: those at j + 1 (bit 0 of `beyond`), at k + 1 (bit 1). The grid ends there. The
	// points that follow get the bits of those before them.
	ColumnWord beyond(unsigned beyond) const
	{
		std::uint64_t bits = bits_;
		if (beyond & 1)
			bits = (bits & 10 * kOnes) | (bits & 10 * kOnes) >> 1;
		if (beyond & 2)
			bits = (bits & 12 * kOnes) | (bits & 12 * kOnes) >> 2;
		return ColumnWord(bits);
	}

	// Writes the cases of fifteen cells, and a sixteenth number without meaning.
	void writeCases(cases::ColumnCase* to) const
	{
#ifdef __SSE2__
		// Cells 0, 2, 4 ... are the bytes of the bits, cells 1, 3, 5 ... those of the bits moved by a column.
		const __m128i bytes = _mm_unpacklo_epi8(_mm_cvtsi64_si128(static_cast<std::int64_t>(bits_)),
		                                        _mm_cvtsi64_si128(static_cast<std::int64_t>(bits_ >> 4)));
		_mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_unpacklo_epi8(bytes, _mm_setzero_si128()));
		_mm_storeu_si128(reinterpret_cast<__m128i*>(to + 8), _mm_unpackhi_epi8(bytes, _mm_setzero_si128()));
#else
		for (std::uint32_t x = 0; x < kColumns; ++x)
			to[x] = static_cast<cases::ColumnCase>(bits_ >> 4 * x & 0xFF);
#endif
	}

	static constexpr std::uint64_t firstCells(std::uint32_t count) // at most 15
	{
		return kOnes & ((std::uint64_t(1) << 4 * count) - 1);
	}

	// The columns whose two points on a side (0 to 3: -j, +j, -k, +k) have different signs.
	template <unsigned side>
	std::uint64_t mixedColumns() const
	{
		return (bits_ >> kRows[side][0] ^ bits_ >> kRows[side][1]) & kOnes;
	}
	// The cells of a mask whose face on the side is cut. mixed: mixedColumns().
	template <unsigned side>
	std::uint64_t cutFaces(std::uint64_t mixed, std::uint64_t cells) const
	{
		return (mixed | along_i_ >> kRows[side][0] | along_i_ >> kRows[side][1]) & cells;
	}
	// The cells of a mask whose edge along i in the farthest row is cut.
	std::uint64_t cutInFarthestRow(std::uint64_t cells) const
	{
		return along_i_ >> 3 & cells;
	}

private:
	static constexpr std::uint64_t kOnes = 0x1111111111111111u;
	static constexpr std::array<std::array<std::uint8_t, 2>, 4> kRows{{{0, 2}, {1, 3}, {0, 1}, {2, 3}}};

	std::uint64_t bits_;
	std::uint64_t along_i_; // rows of a cell whose edge along i is cut
};

// Whether the four points of columns agree: bit 4 x for column x of a quad.
constexpr unsigned uniformColumns(unsigned quad)
{
	const unsigned differ = (quad ^ quad >> 1) & 0x7777;
	return ~(differ | differ >> 1 | differ >> 2) & 0x1111;
}

} // namespace vp::find
