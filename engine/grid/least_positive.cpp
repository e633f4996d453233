#include "grid/least_positive.h"

#include "base/parallel_reduce.h"
#include "grid/array_facts.h"
#include "grid/shown_value.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <limits>

namespace vp::grid
{

namespace
{

constexpr double kNoValueAbove = std::numeric_limits<double>::infinity();

double leastOfStored(const Field& field, int component)
{
	tbb::enumerable_thread_specific<double> least(kNoValueAbove);
	const std::size_t width = field.stored->layout().item_bytes;
	const auto include = [&](std::uint64_t, const std::byte* bytes, std::size_t count)
	{
		for (std::size_t t = 0; t < count; ++t)
			if (const double value = shownValue(field, bytes + t * width, component); value > 0.0)
				least.local() = std::min(least.local(), value);
	};
	field.stored->forEachRun(include);
	return least.combine([](double a, double b) { return std::min(a, b); });
}

double leastInMemory(const Field& field, int component)
{
	const auto scan = [&](const tbb::blocked_range<std::size_t>& tuples, double result)
	{
		for (std::size_t t = tuples.begin(); t < tuples.end(); ++t)
			if (const double value = shownValue(field, t, component); value > 0.0)
				result = std::min(result, value);
		return result;
	};
	return parallelReduce(field.tuples(), 65536, kNoValueAbove, scan,
	                      [](double a, double b) { return std::min(a, b); });
}

} // namespace

bool knowsLeastPositive(const Field& field)
{
	return field.facts && !field.facts->least_positive.empty();
}

double leastPositive(const Field& field, int component)
{
	if (knowsLeastPositive(field))
		return field.facts
		    ->least_positive[static_cast<std::size_t>(component == kMagnitude ? field.components : component)];
	const double least = field.stored ? leastOfStored(field, component) : leastInMemory(field, component);
	return least < kNoValueAbove ? least : 0.0;
}

} // namespace vp::grid
