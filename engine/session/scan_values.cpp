#include "session/scan_values.h"

#include "grid/shown_value.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <variant>

namespace vp::session
{

namespace
{

constexpr std::size_t kBins = 8192;         // more than a CT has values
constexpr std::size_t kMaxLooked = 4 << 20; // values of an array; of larger ones as many are taken at equal distances
constexpr double kOutside = 0.005;          // the part of the values on either side of the window

using Histogram = std::array<std::uint64_t, kBins>;

bool isSmallInteger(grid::NumberType type)
{
	return type <= grid::NumberType::uint16;
}

void add(const Histogram& other, Histogram& sum)
{
	for (std::size_t i = 0; i < kBins; ++i)
		sum[i] += other[i];
}

void count(const grid::Field& field, int component, const std::pair<double, double>& ends, Histogram& bins)
{
	const auto [lo, hi] = ends;
	const std::size_t step = field.tuples() / kMaxLooked + 1;
	const auto include = [&, lo = lo, hi = hi](double value, Histogram& to)
	{
		if (value >= lo && value <= hi)
			++to[static_cast<std::size_t>(std::lround((value - lo) / (hi - lo) * (kBins - 1)))];
	};
	if (!field.stored)
	{
		for (std::size_t t = 0; t < field.tuples(); t += step)
			include(grid::shownValue(field, t, component), bins);
		return;
	}
	tbb::enumerable_thread_specific<Histogram> of_threads(Histogram{});
	const std::size_t width = field.stored->layout().item_bytes;
	field.stored->forEachRun(
	    [&](std::uint64_t first, const std::byte* bytes, std::size_t count)
	    {
		    for (std::size_t t = (step - first % step) % step; t < count; t += step)
			    include(grid::shownValue(field, bytes + t * width, component), of_threads.local());
	    });
	for (const Histogram& other : of_threads)
		add(other, bins);
}

// Returns the place from 0 to 1 up to which this part of the values lies.
double placeOf(const Histogram& bins, double part)
{
	std::uint64_t all = 0;
	for (const std::uint64_t bin : bins)
		all += bin;
	const auto wanted = static_cast<std::uint64_t>(std::lround(part * static_cast<double>(all - 1)));
	std::uint64_t below = 0;
	for (std::size_t i = 0; i < kBins; ++i)
		if (below += bins[i]; below > wanted)
			return static_cast<double>(i) / (kBins - 1);
	return 1.0;
}

} // namespace

bool beginsGray(const grid::BlockSet& blocks, const std::optional<grid::FieldChoice>& field)
{
	if (!field)
		return false;
	const std::vector<const grid::Field*> each = field->inEach(blocks);
	for (std::size_t b = 0; b < each.size(); ++b)
	{
		if (!each[b])
			continue;
		const bool is_small_image =
		    std::holds_alternative<grid::UniformGrid>(blocks.blocks[b].grid) && isSmallInteger(each[b]->type);
		if (each[b]->categorical || !(blocks.blocks[b].imaging.gray || is_small_image))
			return false;
	}
	return true;
}

std::optional<std::pair<double, double>> windowOfScan(const Session& session, const grid::FieldChoice& field,
                                                      const grid::ValueSpan& span)
{
	const grid::BlockSet& blocks = session.blocks();
	const auto [lo, hi] = span.range();
	if (span.empty() || !(lo < hi) || !std::isfinite(hi - lo) || !beginsGray(blocks, field))
		return std::nullopt;
	if (const auto window = blocks.imaging().window)
		return window;
	Histogram bins{};
	bool rounds = true;
	for (const grid::Field* each : field.inEach(blocks))
		if (each)
		{
			count(*each, field.component, {lo, hi}, bins);
			rounds = rounds && each->type < grid::NumberType::float32 && field.component != grid::kMagnitude;
		}
	bins = session.ranks().sum(bins, [](Histogram& sum, const Histogram& other) { add(other, sum); });
	const auto valueAt = [rounds, &bins, lo = lo, hi = hi](double part)
	{
		const double value = lo + placeOf(bins, part) * (hi - lo);
		return rounds ? std::round(value) : value;
	};
	const std::pair window{valueAt(kOutside), valueAt(1.0 - kOutside)};
	return window.first < window.second ? std::optional(window) : std::nullopt;
}

} // namespace vp::session
