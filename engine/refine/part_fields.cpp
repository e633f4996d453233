#include "grid/link/for_ranges.h"
#include "grid/number_types.h"
#include "refine/refine_block.h"
#include "refine/tetrahedron.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace vp::refine
{

namespace
{

/// The shape functions of a quadratic tetrahedron.
std::array<double, grid::kQuadraticTetraNodes> weightsAt(const Vec3& place)
{
	const std::array<double, 4> corner{1.0 - place.x - place.y - place.z, place.x, place.y, place.z};
	std::array<double, grid::kQuadraticTetraNodes> weights;
	for (std::size_t i = 0; i < 4; ++i)
		weights[i] = corner[i] * (2.0 * corner[i] - 1.0);
	for (std::size_t e = 0; e < 6; ++e)
		weights[4 + e] = 4.0 * corner[kEdges[e][0]] * corner[kEdges[e][1]];
	return weights;
}

/// The weights of the nodes of a point's cell.
class Weights
{
public:
	std::span<const double> at(const grid::CurvedCells& curved, const CellKinds& kinds, const PartPoint& point)
	{
		if (curved.isQuadratic(point.cell))
		{
			few_ = weightsAt(point.place);
			return few_;
		}
		const CellKind& kind = kinds.of(point.cell);
		many_.resize(2 * kind.nodes());
		const std::span<double> weights = std::span(many_).first(kind.nodes());
		const std::span<double> rational = std::span(many_).subspan(kind.nodes());
		const bool is_rational = kind.isBezier() && !curved.weights.empty();
		for (std::size_t n = 0; n < kind.nodes() && is_rational; ++n)
			rational[n] = curved.weights[curved.node(point.cell, n)];
		kind.weighNodes(point.place, is_rational ? rational : std::span<double>(), weights.data());
		return weights;
	}

private:
	std::array<double, grid::kQuadraticTetraNodes> few_;
	std::vector<double> many_;
};

template <class T>
const double kHighest = std::nextafter(std::ldexp(1.0, std::numeric_limits<T>::digits), 0.0);

template <class T>
T storedAs(double value, double lo, double hi)
{
	// As a double the highest number of 64 bits is one too high.
	if constexpr (std::is_integral_v<T>)
		return static_cast<T>(std::clamp(std::round(value), lo, std::min(hi, kHighest<T>)));
	else
		return static_cast<T>(value);
}

/// The values of one point. at(node): the values of a node of the cell.
template <class T, class At>
void interpolate(std::span<const double> weights, int components, const At& at, T* values)
{
	for (int c = 0; c < components; ++c)
	{
		double sum = 0.0;
		double lo = std::numeric_limits<double>::infinity();
		double hi = -lo;
		for (std::size_t n = 0; n < weights.size(); ++n)
		{
			const double value = at(n, c);
			lo = std::min(lo, value);
			hi = std::max(hi, value);
			if (weights[n] != 0.0) // a NaN elsewhere in the cell does not count
				sum += weights[n] * value;
		}
		values[c] = storedAs<T>(sum, lo, hi);
	}
}

} // namespace

grid::Field fieldOfParts(const grid::CurvedCells& curved, const CellKinds& kinds, const PartList& parts,
                         const grid::Field& field)
{
	grid::Field made = field;
	const auto width = static_cast<std::size_t>(field.components);
	const auto gather = [&](auto number)
	{
		using T = decltype(number);
		const std::byte* given = field.bytes.data();
		const auto values = std::make_shared<RawVector<T>>(parts.points().size() * width);
		grid::forRanges(parts.points().size(),
		                [&](std::size_t p)
		                {
			                const PartPoint& point = parts.points()[p];
			                T* of_point = values->data() + p * width;
			                if (point.cell == PartPoint::kNode)
			                {
				                std::memcpy(of_point, given + point.source[0] * width * sizeof(T), width * sizeof(T));
				                return;
			                }
			                const std::size_t first = curved.start(point.cell);
			                Weights weights;
			                interpolate(
			                    weights.at(curved, kinds, point), field.components,
			                    [&](std::size_t n, int c)
			                    {
				                    const auto node = static_cast<std::size_t>(curved.cells.connectivity[first + n]);
				                    return grid::numberAt<T>(given, node * width + static_cast<std::size_t>(c));
			                    },
			                    of_point);
		                });
		const auto* bytes = reinterpret_cast<const std::byte*>(values->data());
		made.bytes = Array<std::byte>(values, bytes, values->size() * sizeof(T));
		return 0;
	};
	grid::withNumberType(field.type, gather);
	return made;
}

} // namespace vp::refine
