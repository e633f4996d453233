#include "seed/row_seeds.h"

#include "base/parallel_for.h"

#include <bit>
#include <cstdint>

namespace vp::seed
{

namespace
{

/// A bit for each point of a row: whether it is positive. Rows begin with a word of their own.
class PointSigns
{
public:
	PointSigns(const grid::CurvilinearGrid& grid, const surface::Plane& plane)
	    : points_i_(grid.points()[0]), words_((points_i_ + 63) / 64),
	      bits_(words_ * grid.points()[1] * std::size_t(grid.points()[2]))
	{
		const grid::Points& points = grid.coordinates();
		tracedFor(std::size_t(0), bits_.size() / words_,
		          [&](std::size_t row) {
			          points.isDouble() ? takeRow(points.doubles(), plane, row) : takeRow(points.floats(), plane, row);
		          });
	}

	std::size_t words() const { return words_; }
	const std::uint64_t* row(std::size_t number) const { return &bits_[number * words_]; }

private:
	template <class Number>
	void takeRow(const Number* xyz, const surface::Plane& plane, std::size_t row)
	{
		xyz += 3 * row * points_i_;
		for (std::size_t i = 0; i < points_i_; ++i, xyz += 3)
			bits_[row * words_ + i / 64] |= std::uint64_t(plane.signedDistance({xyz[0], xyz[1], xyz[2]}) >= 0.0)
			                                << i % 64;
	}

	std::size_t points_i_;
	std::size_t words_;
	std::vector<std::uint64_t> bits_;
};

} // namespace

std::vector<CellId> rowSeeds(const grid::CurvilinearGrid& grid, const surface::Plane& plane)
{
	const std::array<std::uint32_t, 3> cells = grid.cells();
	if (grid.cellCount() == 0)
		return {};
	const PointSigns signs(grid, plane);
	const std::size_t points_j = grid.points()[1];
	std::vector<std::vector<CellId>> of_layer(cells[2]);
	tracedFor(std::size_t(0), std::size_t(cells[2]),
	          [&](std::size_t k)
	          {
		          for (std::size_t j = 0; j < cells[1]; ++j)
		          {
			          const std::uint64_t* rows[] = {signs.row(k * points_j + j), signs.row(k * points_j + j + 1),
			                                         signs.row((k + 1) * points_j + j),
			                                         signs.row((k + 1) * points_j + j + 1)};
			          const auto any = [&](std::size_t w)
			          { return w < signs.words() ? rows[0][w] | rows[1][w] | rows[2][w] | rows[3][w] : 0; };
			          const auto all = [&](std::size_t w)
			          { return w < signs.words() ? rows[0][w] & rows[1][w] & rows[2][w] & rows[3][w] : 0; };
			          std::uint64_t before = 0; // whether the last cell of the word before is cut
			          for (std::size_t w = 0; w < signs.words(); ++w)
			          {
				          // Cell i has the points i and i + 1 of four rows.
				          const std::uint64_t some = any(w) | any(w) >> 1 | any(w + 1) << 63;
				          const std::uint64_t every = all(w) & (all(w) >> 1 | all(w + 1) << 63);
				          std::uint64_t cut = some & ~every;
				          if (const std::size_t left = cells[0] - w * 64; w * 64 >= cells[0])
					          cut = 0;
				          else if (left < 64)
					          cut &= (std::uint64_t(1) << left) - 1;
				          for (std::uint64_t starts = cut & ~(cut << 1 | before); starts; starts &= starts - 1)
					          of_layer[k].push_back(
					              grid.cell(static_cast<std::uint32_t>(64 * w + std::countr_zero(starts)),
					                        static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(k)));
				          before = cut >> 63;
			          }
		          }
	          });
	std::vector<CellId> seeds;
	for (const std::vector<CellId>& layer : of_layer)
		seeds.insert(seeds.end(), layer.begin(), layer.end());
	return seeds;
}

} // namespace vp::seed
