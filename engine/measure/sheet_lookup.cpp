#include "measure/sheet_lookup.h"

#include "base/cross2.h"
#include "measure/plane_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::measure
{

namespace
{

// With as many bins as polygons at most, and so many entries a polygon, at 4 bytes: kLookupBytes.
constexpr std::size_t kMaxEntries = 4;

// Nearer to a polygon than this part of the mesh's extent a place still counts where none holds it: at the rim, and
// where two blocks' seam differs by rounding.
constexpr double kRim = 1e-12;

// A weight is that much off zero by rounding.
constexpr double kOutside = -1e-9;

std::array<double, 3> weightsIn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& p)
{
	const double whole = cross(a - c, b - c);
	const double of_a = cross(p - c, b - c) / whole;
	const double of_b = cross(a - c, p - c) / whole;
	return {of_a, of_b, 1.0 - of_a - of_b};
}

// Rounding may leave weights a little outside.
void bound(std::array<double, 3>& weight)
{
	double sum = 0.0;
	for (double& w : weight)
		sum += w = std::clamp(w, 0.0, 1.0);
	for (double& w : weight)
		w /= sum;
}

} // namespace

SheetLookup::SheetLookup(const mesh::SheetMesh& mesh, const probe::Frame& content) : mesh_(&mesh), frame_(content)
{
	const std::vector<Rect> rects = takeRects();
	if (rects.empty())
		return;
	chooseBins(rects);
	fill(rects);
}

glm::dvec2 SheetLookup::place(std::uint32_t vertex) const
{
	return planePoint(mesh_->positions[vertex], frame_);
}

std::vector<SheetLookup::Rect> SheetLookup::takeRects()
{
	constexpr double kFar = std::numeric_limits<double>::infinity();
	const Rect none{glm::dvec2(kFar), glm::dvec2(-kFar)};
	const std::vector<glm::dvec2> points = planePoints(*mesh_, frame_);
	std::vector<Rect> rects(mesh_->polygons(), none);
	rect_ = none;
	for (std::size_t i = 0; i < rects.size(); ++i)
	{
		for (const std::uint32_t v : mesh_->polygon(i))
		{
			rects[i].lo = glm::min(rects[i].lo, points[v]);
			rects[i].hi = glm::max(rects[i].hi, points[v]);
		}
		rect_.lo = glm::min(rect_.lo, rects[i].lo);
		rect_.hi = glm::max(rect_.hi, rects[i].hi);
	}
	return rects;
}

// As large as a polygon is on average, so that long cells get long bins; no more than there are polygons.
SheetLookup::Bins SheetLookup::firstBins(std::span<const Rect> rects) const
{
	glm::dvec2 sum(0.0);
	for (const Rect& rect : rects)
		sum += rect.hi - rect.lo;
	const auto n = static_cast<double>(rects.size());
	glm::dvec2 bins(1.0);
	for (int axis = 0; axis < 2; ++axis)
		if (sum[axis] > 0.0)
			bins[axis] = std::clamp((rect_.hi - rect_.lo)[axis] * n / sum[axis], 1.0, n);
	const double too_many = bins.x * bins.y / n;
	if (too_many > 1.0)
		bins = glm::clamp(bins / std::sqrt(too_many), glm::dvec2(1.0), glm::dvec2(n));
	bins.y = std::min(bins.y, std::max(1.0, n / bins.x));
	return Bins(bins);
}

void SheetLookup::setBins(const Bins& bins)
{
	bins_ = bins;
	// A mesh without width is one bin wide.
	const glm::dvec2 size = glm::max(rect_.hi - rect_.lo, glm::dvec2(std::numeric_limits<double>::min()));
	per_length_ = glm::min(glm::dvec2(bins) / size, glm::dvec2(std::numeric_limits<double>::max()));
}

SheetLookup::Bins SheetLookup::binOf(const glm::dvec2& uv) const
{
	return Bins(glm::clamp((uv - rect_.lo) * per_length_, glm::dvec2(0.0), glm::dvec2(bins_) - 1.0));
}

std::size_t SheetLookup::entries(std::span<const Rect> rects) const
{
	std::size_t sum = 0;
	for (const Rect& rect : rects)
	{
		const Bins span = binOf(rect.hi) - binOf(rect.lo) + Bins(1);
		sum += std::size_t(span.x) * span.y;
	}
	return sum;
}

// Slivers across the axes fill their rectangles with bins that they miss: fewer bins then.
void SheetLookup::chooseBins(std::span<const Rect> rects)
{
	setBins(firstBins(rects));
	while (entries(rects) > kMaxEntries * rects.size())
		setBins(bins_.x >= bins_.y ? Bins((bins_.x + 1) / 2, bins_.y) : Bins(bins_.x, (bins_.y + 1) / 2));
}

void SheetLookup::fill(std::span<const Rect> rects)
{
	const auto forBins = [&](const Rect& rect, auto&& visit)
	{
		const Bins lo = binOf(rect.lo);
		const Bins hi = binOf(rect.hi);
		for (unsigned y = lo.y; y <= hi.y; ++y)
			for (unsigned x = lo.x; x <= hi.x; ++x)
				visit(std::size_t(y) * bins_.x + x);
	};
	// Counted one place on, so that filling moves each start to where it belongs.
	starts_.assign(std::size_t(bins_.x) * bins_.y + 2, 0);
	for (const Rect& rect : rects)
		forBins(rect, [&](std::size_t bin) { ++starts_[bin + 2]; });
	for (std::size_t bin = 2; bin < starts_.size(); ++bin)
		starts_[bin] += starts_[bin - 1];
	polygons_.resize(starts_.back());
	for (std::size_t i = 0; i < rects.size(); ++i)
		forBins(rects[i], [&](std::size_t bin) { polygons_[starts_[bin + 1]++] = static_cast<std::uint32_t>(i); });
	starts_.pop_back();
}

// Even-odd. Sides are reckoned from their lower vertex, so that neighbors agree.
bool SheetLookup::holds(std::uint32_t polygon, const glm::dvec2& uv) const
{
	const auto corners = mesh_->polygon(polygon);
	bool inside = false;
	for (std::size_t i = 0; i < corners.size(); ++i)
	{
		const auto [low, high] = std::minmax({corners[i], corners[(i + 1) % corners.size()]});
		const glm::dvec2 a = place(low);
		const glm::dvec2 b = place(high);
		if ((a.y > uv.y) != (b.y > uv.y) && uv.x < a.x + (uv.y - a.y) / (b.y - a.y) * (b.x - a.x))
			inside = !inside;
	}
	return inside;
}

// Returns the triangle in which the place lies. Triangles that run with the polygon go first, then the one in which the
// place lies deepest. There is one wherever a ray crosses the outline an odd number of times, since the triangles'
// outlines together are the polygon's outline.
std::optional<SheetPlace> SheetLookup::inFan(std::uint32_t polygon, const glm::dvec2& uv) const
{
	const auto corners = mesh_->polygon(polygon);
	glm::dvec2 center(0.0);
	for (const std::uint32_t v : corners)
		center += place(v);
	center /= static_cast<double>(corners.size());
	const auto area = [&](std::uint32_t a, std::uint32_t b) { return cross(place(a) - center, place(b) - center); };
	double whole = 0.0;
	std::uint32_t previous = corners.back();
	for (const std::uint32_t v : corners)
		whole += area(std::exchange(previous, v), v);
	std::optional<SheetPlace> best;
	double best_rank = 0.0;
	for (const std::uint32_t v : corners)
	{
		const std::uint32_t a = std::exchange(previous, v);
		const double part = area(a, v);
		if (part == 0.0)
			continue;
		const std::array<double, 3> weight = weightsIn(place(a), place(v), center, uv);
		const double least = std::ranges::min(weight);
		const double rank = least + (least < kOutside ? 0.0 : part * whole > 0.0 ? 2.0 : 1.0);
		if (!best || rank > best_rank)
		{
			best_rank = rank;
			best = SheetPlace{polygon, mesh_->polygon_cells[polygon], {a, v}, weight};
		}
	}
	if (best)
		bound(best->weight);
	return best;
}

std::optional<SheetPlace> SheetLookup::at(const glm::dvec2& uv) const
{
	if (polygons_.empty())
		return std::nullopt;
	const Bins bin = binOf(uv);
	const std::size_t b = std::size_t(bin.y) * bins_.x + bin.x;
	const auto listed = std::span(polygons_).subspan(starts_[b], starts_[b + 1] - starts_[b]);
	const double off = kRim * glm::length(rect_.hi - rect_.lo);
	for (const glm::dvec2& step :
	     {glm::dvec2(0.0), glm::dvec2(-off), glm::dvec2(off), glm::dvec2(off, -off), glm::dvec2(-off, off)})
		for (std::size_t i = listed.size(); i-- > 0;)
			if (holds(listed[i], uv + step))
				if (auto found = inFan(listed[i], uv))
				{
					found->inside = step == glm::dvec2(0.0);
					return found;
				}
	return std::nullopt;
}

double SheetLookup::value(const SheetPlace& place, std::span<const double> vertex_values) const
{
	const auto corners = mesh_->polygon(place.polygon);
	double mean = 0.0;
	for (const std::uint32_t v : corners)
		mean += vertex_values[v];
	mean /= static_cast<double>(corners.size());
	return place.weight[0] * vertex_values[place.corner[0]] + place.weight[1] * vertex_values[place.corner[1]] +
	       place.weight[2] * mean;
}

std::size_t SheetLookup::bytes() const
{
	return (starts_.capacity() + polygons_.capacity()) * sizeof(std::uint32_t);
}

} // namespace vp::measure
