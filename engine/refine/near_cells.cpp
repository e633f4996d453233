#include "refine/near_cells.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::refine
{

namespace
{

constexpr std::size_t kNearAtOnce = 256; // whatever the number of threads

/// The share of what a part may be off that a flat cell may be off as a whole.
constexpr double kFlat = 0.25;

} // namespace

double NearCell::bendWithin(const Vec3& lo, const Vec3& hi) const
{
	if (pyramid)
		return pyramid->within(lo, hi);
	// Weights of the corners that make a place have a variance of at most a quarter of the squared width.
	const Vec3 w = hi - lo;
	return 0.125 * (second[0] * w.x * w.x + second[1] * w.y * w.y + second[2] * w.z * w.z +
	                2.0 * (second[3] * w.x * w.y + second[4] * w.x * w.z + second[5] * w.y * w.z));
}

double NearCell::sizeOf(unsigned support) const
{
	const grid::ShapeTopology& shape = grid::topology(kind->shape());
	float size = 0.0f;
	for (int e = 0; e < shape.edges; ++e)
		if ((support >> shape.edge[e][0] & 1u) && (support >> shape.edge[e][1] & 1u))
			size = std::max(size, edge_sizes[e]);
	return size;
}

NearCells::NearCells(const grid::CurvedCells& curved, const CellKinds& kinds, const Sheets& sheets, double slack,
                     std::span<const ShownArray> shown)
    : curved_(curved), kinds_(kinds), sheets_(sheets), slack_(slack), shown_(shown), rational_(!curved.weights.empty())
{
	for (const ShownArray& array : shown)
		width_ += static_cast<std::size_t>(array.width());
}

void NearCells::valuesOf(std::size_t node, double* values) const
{
	for (const ShownArray& array : shown_)
		for (int c = 0; c < array.width(); ++c)
			*values++ =
			    array.field->value(node, array.component == grid::kMagnitude ? c : array.component) / array.allowed;
}

void NearCells::add(std::span<const std::uint32_t> cells)
{
	ranges_.resize((cells.size() + kNearAtOnce - 1) / kNearAtOnce);
	tracedFor(std::size_t(0), ranges_.size(),
	          [&](std::size_t r)
	          {
		          Scratch scratch;
		          for (const std::uint32_t cell :
		               cells.subspan(r * kNearAtOnce, std::min(kNearAtOnce, cells.size() - r * kNearAtOnce)))
			          if (curved_.isCut(cell))
				          look(cell, ranges_[r], scratch);
	          });
	for (std::uint32_t r = 0; r < ranges_.size(); ++r)
	{
		curved_looked_at_ += ranges_[r].curved_looked_at;
		for (std::uint32_t c = 0; c < ranges_[r].cells.size(); ++c)
		{
			curved_met_ += curved_.isCurved(ranges_[r].cells[c].cell);
			order_.push_back({r, c});
		}
	}
	// The first of the cells about an edge says how it bends.
	std::ranges::stable_sort(order_, std::ranges::greater(),
	                         [&](const Place& at) { return ranges_[at.range].cells[at.place].kind->degree(); });
}

void NearCells::look(std::uint32_t cell, Range& range, Scratch& scratch) const
{
	const CellKind& kind = kinds_.of(cell);
	range.curved_looked_at += curved_.isCurved(cell);
	const std::size_t stride = this->stride();
	scratch.nodes.resize(kind.nodes() * stride);
	for (std::size_t n = 0; n < kind.nodes(); ++n)
	{
		const Vec3 at = curved_.points[curved_.node(cell, n)];
		std::copy_n(&at.x, 3, &scratch.nodes[n * stride]);
	}
	// Positions alone tell whether a sheet meets it.
	scratch.positions.resize(kind.lattice());
	std::vector<double>& lattice = range.lattice;
	const std::size_t begin = lattice.size();
	lattice.resize(begin + kind.lattice() * stride);
	const std::span<double> own = std::span(lattice).subspan(begin);
	const auto toLattice = [&]
	{
		kind.toLattice(scratch.nodes.data(), stride, own.data());
		for (std::size_t v = 0; v < kind.lattice(); ++v)
			scratch.positions[v] = {own[v * stride], own[v * stride + 1], own[v * stride + 2]};
	};
	toLattice();
	kind.controlPoints(scratch.positions, scratch.control);
	if (!sheets_.meetHull(scratch.control, slack_))
		return lattice.resize(begin);

	NearCell near;
	near.cell = cell;
	near.kind = &kind;
	near.lattice = begin;
	for (std::size_t n = 0; n < kind.nodes(); ++n)
	{
		double* of_node = &scratch.nodes[n * stride];
		const std::size_t node = curved_.node(cell, n);
		valuesOf(node, of_node + 3);
		if (rational_)
			of_node[stride - 1] = kind.isBezier() ? curved_.weights[node] : 1.0;
	}
	toLattice();
	bound(near, own, scratch);
	measure(near, own);
	near.is_flat = isFlat(near, own);
	if (rational_)
		for (std::size_t v = 0; v < kind.lattice(); ++v)
			for (std::size_t i = 0; i + 1 < stride; ++i)
				own[v * stride + i] *= own[(v + 1) * stride - 1];
	range.cells.push_back(std::move(near));
}

/// Bounds of the second derivatives, from differences of control points; of rational cells by the rule for quotients.
void NearCells::bound(NearCell& near, std::span<const double> lattice, Scratch& scratch) const
{
	const CellKind& kind = *near.kind;
	if (kind.isPyramid())
	{
		near.pyramid.emplace(scratch.positions);
		return;
	}
	const bool rational = rational_ && kind.isBezier();
	const auto weight = [&](std::size_t v) { return rational ? lattice[(v + 1) * stride() - 1] : 1.0; };
	std::vector<Vec3>& points = scratch.control;
	const Vec3 center = points[0];
	double radius = 0.0;
	double least = 1.0;
	for (std::size_t v = 0; v < points.size() && rational; ++v)
	{
		points[v] -= center;
		radius = std::max(radius, glm::length(points[v]));
		points[v] *= weight(v);
		least = v == 0 ? weight(v) : std::min(least, weight(v));
	}
	std::array<double, 3> slope{};        // slope of the position
	std::array<double, 3> weight_slope{}; // slope of the sum of weights
	for (std::size_t a = 0; a < 3 && rational; ++a)
	{
		double numerator = 0.0;
		for (const auto& [p, q, r, s] : kind.first(a).points)
		{
			numerator = std::max(numerator, glm::length(points[p] - points[q]));
			weight_slope[a] = std::max(weight_slope[a], std::abs(weight(p) - weight(q)));
		}
		weight_slope[a] *= kind.first(a).factor;
		slope[a] = (kind.first(a).factor * numerator + radius * weight_slope[a]) / least;
	}
	constexpr std::array<std::array<std::size_t, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
	for (std::size_t i = 0; i < 6; ++i)
	{
		const CellKind::Stencils& stencils = kind.second(i);
		double most = 0.0;
		double of_weights = 0.0;
		for (const auto& [p, q, r, s] : stencils.points)
		{
			const Vec3 bend = points[p] - points[q] - points[r] + points[s];
			most = std::max(most, glm::dot(bend, bend));
			if (rational)
				of_weights = std::max(of_weights, std::abs(weight(p) - weight(q) - weight(r) + weight(s)));
		}
		near.second[i] = stencils.factor * std::sqrt(most);
		const auto [j, k] = pairs[i];
		if (rational)
			near.second[i] = (near.second[i] + weight_slope[j] * slope[k] + weight_slope[k] * slope[j] +
			                  radius * stencils.factor * of_weights) /
			                 least;
	}
}

void NearCells::measure(NearCell& near, std::span<const double> lattice) const
{
	const CellKind& kind = *near.kind;
	const grid::ShapeTopology& shape = grid::topology(kind.shape());
	std::array<double, kMaxLattice> weights;
	for (int e = 0; e < shape.edges; ++e)
	{
		const auto [a, b] = shape.edge[e];
		kind.weigh(0.5 * (kind.cornerPlace(a) + kind.cornerPlace(b)), weights.data());
		const double* first = &lattice[kind.cornerValue(a) * stride()];
		const double* second = &lattice[kind.cornerValue(b) * stride()];
		Vec3 chord;
		Vec3 bend;
		for (int i = 0; i < 3; ++i)
		{
			chord[i] = first[i] - second[i];
			bend[i] = -0.5 * (first[i] + second[i]);
			for (std::size_t v = 0; v < kind.lattice(); ++v)
				bend[i] += weights[v] * lattice[v * stride() + static_cast<std::size_t>(i)];
		}
		near.edge_sizes[e] = static_cast<float>(std::max(glm::length(chord), glm::length(bend)));
	}
}

/// Returns true if no node is far from the linear cell, so that edges tell how the cell bends.
bool NearCells::isFlat(const NearCell& near, std::span<const double> lattice) const
{
	const CellKind& kind = *near.kind;
	const std::size_t stride = this->stride();
	const auto edges = static_cast<std::size_t>(grid::topology(kind.shape()).edges);
	const double allowed =
	    kFlat * curved_.tolerance * *std::ranges::min_element(std::span(near.edge_sizes).first(edges));
	for (std::size_t v = 0; v < kind.lattice(); ++v)
	{
		const std::span<const double> weights = kind.linearWeights(v);
		const auto off = [&](std::size_t i)
		{
			double linear = 0.0;
			for (std::size_t c = 0; c < weights.size(); ++c)
				linear += weights[c] * lattice[kind.cornerValue(c) * stride + i];
			return lattice[v * stride + i] - linear;
		};
		double values = 0.0;
		for (std::size_t i = 3; i < width_; ++i)
			values += off(i) * off(i);
		if (off(0) * off(0) + off(1) * off(1) + off(2) * off(2) > allowed * allowed || values > kFlat * kFlat ||
		    (rational_ && lattice[(v + 1) * stride - 1] != lattice[stride - 1]))
			return false;
	}
	return true;
}

void NearCells::evaluate(std::size_t i, const Vec3& place, double* weights, double* numbers) const
{
	const Range& range = ranges_[order_[i].range];
	const NearCell& near = range.cells[order_[i].place];
	near.kind->weigh(place, weights);
	const double* value = range.lattice.data() + near.lattice;
	const std::size_t stride = this->stride();
	std::array<double, 3 + kMaxShownNumbers + 1> sum{};
	for (std::size_t v = 0; v < near.kind->lattice(); ++v, value += stride)
		if (weights[v] != 0.0) // a NaN elsewhere in the cell does not count
			for (std::size_t n = 0; n < stride; ++n)
				sum[n] += weights[v] * value[n];
	const double scale = rational_ ? 1.0 / sum[width_] : 1.0;
	for (std::size_t n = 0; n < width_; ++n)
		numbers[n] = scale * sum[n];
}

} // namespace vp::refine
