#include "render/scene/least_positive.h"

#include "base/parallel_reduce.h"
#include "grid/shown_value.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::render
{

namespace
{

double leastOfStored(const grid::Field& field, int component)
{
	tbb::enumerable_thread_specific<double> least(std::numeric_limits<double>::infinity());
	const std::size_t width = field.stored->layout().item_bytes;
	const auto include = [&](std::uint64_t, const std::byte* bytes, std::size_t count)
	{
		for (std::size_t t = 0; t < count; ++t)
			if (const double value = grid::shownValue(field, bytes + t * width, component);
			    value > 0.0 && std::isfinite(value))
				least.local() = std::min(least.local(), value);
	};
	field.stored->forEachRun(include);
	return least.combine([](double a, double b) { return std::min(a, b); });
}

} // namespace

double leastPositive(const grid::BlockSet& blocks, const grid::FieldChoice& choice)
{
	double least = std::numeric_limits<double>::infinity();
	for (const grid::Block& block : blocks.blocks)
	{
		const grid::Field* field = choice.in(block);
		if (!field)
			continue;
		if (field->stored)
		{
			least = std::min(least, leastOfStored(*field, choice.component));
			continue;
		}
		const auto scan = [&](const tbb::blocked_range<std::size_t>& tuples, double result)
		{
			for (std::size_t t = tuples.begin(); t < tuples.end(); ++t)
			{
				const double value = grid::shownValue(*field, t, choice.component);
				if (value > 0.0 && std::isfinite(value))
					result = std::min(result, value);
			}
			return result;
		};
		least = parallelReduce(field->tuples(), 65536, least, scan, [](double a, double b) { return std::min(a, b); });
	}
	return std::isfinite(least) ? least : 0.0;
}

} // namespace vp::render
