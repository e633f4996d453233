#include "measure/finite_fields.h"

#include "base/parallel_reduce.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace vp::measure
{

namespace
{

// Squares of up to 1e7 components do not overflow.
constexpr double kMaxOrdinary = 1e150;

// To interpolate a value at a vertex takes some 20 ns, to look at a number of an array 0.5.
constexpr std::size_t kNumbersPerLookup = 32;

template <class T>
bool areOrdinary(const std::byte* bytes, std::size_t count)
{
	constexpr double kMax = sizeof(T) == 4 ? std::numeric_limits<float>::max() : kMaxOrdinary;
	const auto all = [&](const tbb::blocked_range<std::size_t>& part, bool so_far)
	{
		if (!so_far)
			return false;
		bool ordinary = true; // without a way out, so that several numbers are looked at together
		for (std::size_t i = part.begin(); i < part.end(); ++i)
		{
			T number; // mapped files give no promise about alignment
			std::memcpy(&number, bytes + i * sizeof(T), sizeof(T));
			ordinary &= std::abs(number) <= static_cast<T>(kMax);
		}
		return ordinary;
	};
	return parallelReduce(count, 65536, true, all, std::logical_and<>());
}

} // namespace

bool hasOrdinaryNumbersOnly(const grid::Field& field)
{
	const std::size_t count = field.tuples() * static_cast<std::size_t>(field.components);
	if (field.type == grid::NumberType::float32)
		return areOrdinary<float>(field.bytes.data(), count);
	if (field.type == grid::NumberType::float64)
		return areOrdinary<double>(field.bytes.data(), count);
	return true;
}

FiniteFields::Known& FiniteFields::entryOf(const grid::Field& field)
{
	std::erase_if(known_, [](const Known& known) { return known.owner.expired(); });
	const auto at =
	    std::ranges::find_if(known_, [&](const Known& known)
	                         { return known.data == field.bytes.data() && known.owner.lock() == field.bytes.owner(); });
	return at != known_.end() ? *at
	                          : known_.emplace_back(Known{field.bytes.owner(), field.bytes.data(), 0, std::nullopt});
}

bool FiniteFields::holds(const grid::Field& field, std::size_t lookups)
{
	if (field.stored || field.is_in_runs)
		return false; // to look would read all of it
	const std::lock_guard lock(mutex_);
	Known& known = entryOf(field);
	if (known.finite)
		return *known.finite;
	known.lookups += lookups;
	const std::size_t numbers = field.tuples() * static_cast<std::size_t>(field.components);
	if (known.lookups < numbers / kNumbersPerLookup)
		return false;
	known.finite = hasOrdinaryNumbersOnly(field);
	return *known.finite;
}

} // namespace vp::measure
