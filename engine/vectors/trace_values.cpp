#include "vectors/trace_values.h"

#include "base/parallel_for.h"
#include "grid/shown_value.h"
#include "locate/interpolate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::vectors
{

namespace
{

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// Share of the cell's size. Differences over less would be rounding. Differences over more would reach into the
// neighbors.
constexpr double kShare = 0.05;

// Returns true if this process has the block's cells. Each process has only the cells of its own blocks.
bool holdsCells(const grid::Block& block)
{
	return std::visit([](const auto& grid) { return grid.cellCount() > 0; }, block.grid);
}

// One component of an array at a place in a cell whose weights are known.
template <grid::Grid G>
double component(const G& grid, const grid::Field& field, const locate::CellWeights& at, CellId cell, int c)
{
	if (field.association == grid::Association::cell)
		return field.value(grid.sourceCell(cell), c);
	if (at.points.empty())
		return kNothing;
	if (field.categorical)
		return field.value(grid.sourcePoint(at.points[std::ranges::max_element(at.weights) - at.weights.begin()]), c);
	double value = 0.0;
	for (std::size_t i = 0; i < at.points.size(); ++i)
		if (at.weights[i] != 0.0) // a NaN there does not reach here
			value += at.weights[i] * field.value(grid.sourcePoint(at.points[i]), c);
	return value;
}

double componentAt(const grid::Block& block, const grid::Field& field, const locate::CellWeights& at, CellId cell,
                   int c)
{
	return std::visit([&](const auto& grid) { return component(grid, field, at, cell, c); }, block.grid);
}

double shownValue(const grid::Block& block, const grid::Field& field, const locate::CellWeights& at, CellId cell,
                  int shown)
{
	if (shown != grid::kMagnitude)
		return componentAt(block, field, at, cell, shown);
	double square = 0.0;
	for (int c = 0; c < field.components; ++c)
		square += grid::magnitudeWeight(field.components, c) * std::pow(componentAt(block, field, at, cell, c), 2);
	return std::sqrt(square);
}

// A vector array's in one cell, anywhere about it.
class CellVectors
{
public:
	CellVectors(const grid::Block& block, const grid::Field& field, CellId cell)
	    : block_(block), field_(field), cell_(cell)
	{
	}

	Vec3 at(const Vec3& place)
	{
		locate::weighCell(block_, cell_, place, weights_);
		Vec3 vector;
		for (int c = 0; c < 3; ++c)
			vector[c] = componentAt(block_, field_, weights_, cell_, c);
		return vector;
	}
	double size() // returns the cell's rough size
	{
		Box box;
		std::visit(
		    [&](const auto& grid)
		    {
			    for (const PointId p : weights_.points)
				    box.include(grid.point(p));
		    },
		    block_.grid);
		return box.empty() ? 0.0 : glm::length(box.hi - box.lo);
	}

private:
	const grid::Block& block_;
	const grid::Field& field_;
	CellId cell_;
	locate::CellWeights weights_;
};

// Radians a unit of time.
double turnRate(const grid::Block& block, const grid::Field& field, CellId cell, const Vec3& place, const Vec3& along)
{
	const double length = glm::length(along);
	if (!(length > 0.0) || !std::isfinite(length))
		return 0.0;
	const Vec3 t = along / length;
	const Vec3 x = glm::normalize(glm::cross(t, std::abs(t.x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0)));
	const Vec3 y = glm::cross(t, x);
	CellVectors vectors(block, field, cell);
	vectors.at(place);
	const double step = kShare * vectors.size();
	if (!(step > 0.0))
		return 0.0;
	const Vec3 over_x = (vectors.at(place + step * x) - vectors.at(place - step * x)) / (2.0 * step);
	const Vec3 over_y = (vectors.at(place + step * y) - vectors.at(place - step * y)) / (2.0 * step);
	const double rate = 0.5 * (glm::dot(over_x, y) - glm::dot(over_y, x));
	return std::isfinite(rate) ? rate : 0.0;
}

} // namespace

std::vector<double> valuesAt(const grid::BlockSet& blocks, const grid::FieldChoice& choice, const Traces& traces)
{
	const std::vector<const grid::Field*> fields = choice.inEach(blocks);
	std::vector<double> values(traces.points.size(), kNothing);
	tracedFor(tbb::blocked_range<std::size_t>(0, values.size(), 256),
	          [&](const tbb::blocked_range<std::size_t>& range)
	          {
		          locate::CellWeights weights;
		          for (std::size_t i = range.begin(); i < range.end(); ++i)
		          {
			          const std::uint32_t b = traces.blocks[i];
			          if (!fields[b] || !holdsCells(blocks.blocks[b]))
				          continue;
			          const grid::Block& block = blocks.blocks[b];
			          if (fields[b]->association == grid::Association::point)
				          locate::weighCell(block, traces.cells[i], traces.points[i], weights);
			          values[i] = shownValue(block, *fields[b], weights, traces.cells[i], choice.component);
		          }
	          });
	return values;
}

std::vector<double> turnRates(const grid::BlockSet& blocks, const grid::FieldChoice& vectors, const Traces& traces)
{
	std::vector<double> rates(traces.points.size(), 0.0);
	if (vectors.association == grid::Association::cell)
		return rates;
	const std::vector<const grid::Field*> fields = vectors.inEach(blocks);
	tracedFor(std::size_t(0), rates.size(),
	          [&](std::size_t i)
	          {
		          const std::uint32_t b = traces.blocks[i];
		          if (fields[b] && holdsCells(blocks.blocks[b]))
			          rates[i] =
			              turnRate(blocks.blocks[b], *fields[b], traces.cells[i], traces.points[i], traces.vectors[i]);
	          });
	return rates;
}

std::vector<double> turnsAlong(std::span<const double> rates, const Traces& traces)
{
	std::vector<double> turns(traces.points.size(), 0.0);
	const auto over = [&](std::size_t a, std::size_t b)
	{ return 0.5 * (rates[a] + rates[b]) * (traces.times[b] - traces.times[a]); };
	for (std::size_t t = 0; t < traces.count(); ++t)
	{
		const std::size_t launch = traces.launches[t];
		for (std::size_t i = launch + 1; i < traces.first(t) + traces.size(t); ++i)
			turns[i] = turns[i - 1] + over(i - 1, i);
		for (std::size_t i = launch; i > traces.first(t); --i)
			turns[i - 1] = turns[i] - over(i - 1, i);
	}
	return turns;
}

} // namespace vp::vectors
