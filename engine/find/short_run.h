#pragma once

#include "cases/lattice_cases.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace vp::find
{

// What the cells of a run give to a mesh, a byte each, so that one addition adds them all.
struct RunSums
{
	std::uint32_t packed = 0;

	static constexpr RunSums of(const cases::LatticeCase& entry)
	{
		return {entry.owned_count | std::uint32_t(entry.edges) << 8 | std::uint32_t(entry.edges != 0) << 16 |
		        std::uint32_t(entry.needs_walk) << 24};
	}
	std::uint32_t vertices() const { return packed & 0xFF; }
	std::uint32_t corners() const { return packed >> 8 & 0xFF; }
	std::uint32_t polygons() const { return packed >> 16 & 0xFF; }
	std::uint32_t walked() const { return packed >> 24; }
};

// A run of cut cells so short that its columns fit into a word, four bits each, as most do. Then a step with all bits
// takes the place of one for each cell. In masks, bit 4 x is that of cell x or column x.
class ShortRun
{
public:
	static constexpr std::uint32_t kMaxCells = 14;

	// columns: the run's cells + 1, and readable up to the sixteenth.
	ShortRun(const cases::Column* columns, std::uint32_t cells)
	    : columns_(pack(columns) & ((std::uint64_t(1) << (4 * cells + 4)) - 1)), cells_(cells),
	      every_(kOnes & ((std::uint64_t(1) << 4 * cells) - 1)), along_i_(columns_ ^ columns_ >> 4)
	{
	}

	RunSums sums() const
	{
		static const std::array<RunSums, 256> of_case = []
		{
			std::array<RunSums, 256> made;
			for (std::size_t c = 0; c < made.size(); ++c)
				made[c] = RunSums::of(cases::latticeCases()[c]);
			return made;
		}();
		// The point of the last column has no edge along i.
		const auto last = static_cast<std::uint32_t>(columns_ >> 4 * cells_);
		RunSums sums{((last ^ last >> 1) & 1) + ((last ^ last >> 2) & 1)};
		for (std::uint32_t x = 0; x < cells_; ++x)
			sums.packed += of_case[columns_ >> 4 * x & 0xFF].packed;
		return sums;
	}

	// The columns whose two points on a side (0 to 3: -j, +j, -k, +k) have different signs.
	std::uint64_t mixedColumns(unsigned side) const
	{
		const unsigned first = kFirstRow[side];
		return (columns_ >> first ^ columns_ >> (first + kToSecondRow[side])) & kOnes;
	}
	// The cells whose face on the side is cut. mixed: mixedColumns(side).
	std::uint64_t cutFaces(unsigned side, std::uint64_t mixed) const
	{
		const unsigned first = kFirstRow[side];
		return (mixed | along_i_ >> first | along_i_ >> (first + kToSecondRow[side])) & every_;
	}

private:
	static constexpr std::uint64_t kOnes = 0x1111111111111111u;
	// Rows 0 to 3 of points are (j, k), (j + 1, k), (j, k + 1), (j + 1, k + 1).
	static constexpr std::array<std::uint8_t, 4> kFirstRow{0, 1, 0, 2};
	static constexpr std::array<std::uint8_t, 4> kToSecondRow{2, 2, 1, 1};

	static std::uint64_t pack(const cases::Column* columns)
	{
		std::uint64_t packed = 0;
		if constexpr (std::endian::native == std::endian::little)
			for (int half = 1; half >= 0; --half)
			{
				std::uint64_t bytes;
				std::memcpy(&bytes, columns + 8 * half, 8);
				bytes &= 0x0F0F0F0F0F0F0F0Fu;
				bytes = (bytes | bytes >> 4) & 0x00FF00FF00FF00FFu;
				bytes = (bytes | bytes >> 8) & 0x0000FFFF0000FFFFu;
				packed = packed << 32 | ((bytes | bytes >> 16) & 0xFFFFFFFFu);
			}
		else
			for (int x = 15; x >= 0; --x)
				packed = packed << 4 | (columns[x] & 15u);
		return packed;
	}

	std::uint64_t columns_;
	std::uint32_t cells_;
	std::uint64_t every_;   // cell of the run
	std::uint64_t along_i_; // rows of a cell whose edge along i is cut
};

} // namespace vp::find
