#include "grid/labels.h"

#include "base/parallel_reduce.h"
#include "grid/number_types.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace vp::grid
{

namespace
{

constexpr std::size_t kTuplesAtOnce = 1 << 20;

// Notes values. Those of 8 and 16 bits have a place each, since a scan may have a thousand million of them.
template <class Number>
class Noted
{
public:
	explicit Noted(std::size_t most) : most_(most) {}

	bool isEnough() const { return count_ > most_; }
	void take(const std::byte* bytes, std::size_t begin, std::size_t end)
	{
		for (std::size_t t = begin; t < end && !isEnough(); t += kAtOnce)
		{
			const std::size_t stop = std::min(end, t + kAtOnce);
			for (std::size_t i = t; i < stop; ++i)
				note(bytes, i);
			// To count the places takes as long as to note so many values, and runs may be short.
			if (not_counted_ += stop - t; kHasPlaces && not_counted_ >= kAtOnce)
				countPlaces();
		}
	}
	void take(const Noted& other)
	{
		for (std::size_t place = 0; place < kPlaces; ++place)
			places_[place] |= other.places_[place];
		found_.include(other.found_);
		if (kHasPlaces)
			countPlaces();
		else
			count_ = found_.count;
	}
	Distinct values() const
	{
		if constexpr (!kHasPlaces)
			return found_;
		else
		{
			Distinct values;
			for (std::size_t place = 0; place < places_.size() && !values.isFull(); ++place)
				if (places_[place])
					values.include(static_cast<double>(place) + kLeast);
			return values;
		}
	}

private:
	static constexpr bool kHasPlaces = std::is_integral_v<Number> && sizeof(Number) <= 2;
	static constexpr double kLeast = kHasPlaces ? static_cast<double>(std::numeric_limits<Number>::min()) : 0.0;
	static constexpr std::size_t kPlaces = !kHasPlaces ? 0 : sizeof(Number) == 1 ? 256 : 65536;
	static constexpr std::size_t kAtOnce = kHasPlaces ? 1 << 16 : 1024;

	void countPlaces()
	{
		count_ = static_cast<std::size_t>(std::ranges::count(places_, 1));
		not_counted_ = 0;
	}

	void note(const std::byte* bytes, std::size_t i)
	{
		if constexpr (kHasPlaces)
		{
			Number number;
			std::memcpy(&number, bytes + i * sizeof(Number), sizeof(Number));
			places_[static_cast<std::size_t>(number - std::numeric_limits<Number>::min())] = 1;
		}
		else if (const double value = numberAt<Number>(bytes, i); count_ == 0 || value != last_)
		{
			found_.include(value);
			count_ = found_.count;
			last_ = value;
		}
	}

	std::size_t most_;
	std::size_t count_ = 0;
	std::size_t not_counted_ = 0; // values noted since the places were counted
	std::vector<std::uint8_t> places_ = std::vector<std::uint8_t>(kPlaces);
	Distinct found_;
	double last_ = 0.0;
};

// Most scans show more values than labels have within their first parts, and no more is read.
template <class Number>
Distinct valuesOfStored(const Field& field, std::size_t most)
{
	tbb::enumerable_thread_specific<Noted<Number>> of_threads{Noted<Number>(most)};
	std::atomic<bool> is_enough = false;
	field.stored->forEachRun(
	    [&](std::uint64_t, const std::byte* bytes, std::size_t count)
	    {
		    Noted<Number>& here = of_threads.local();
		    here.take(bytes, 0, count);
		    if (here.isEnough())
			    is_enough = true;
	    },
	    [&] { return is_enough.load(); });
	Noted<Number> found(most);
	for (const Noted<Number>& each : of_threads)
		found.take(each);
	return found.values();
}

} // namespace

Distinct distinctValues(const Field& field, std::size_t most)
{
	const auto scan = [&](auto number)
	{
		using Found = Noted<decltype(number)>;
		if (field.stored)
			return valuesOfStored<decltype(number)>(field, most);
		const auto take = [&](const tbb::blocked_range<std::size_t>& tuples, Found found)
		{
			found.take(field.bytes.data(), tuples.begin(), tuples.end());
			return found;
		};
		const auto join = [](Found a, const Found& b)
		{
			a.take(b);
			return a;
		};
		return parallelReduce(field.tuples(), kTuplesAtOnce, Found(most), take, join).values();
	};
	return withNumberType(field.type, scan);
}

Changes changesOf(const Field& field, std::span<const double> values)
{
	constexpr std::size_t kRuns = 64;
	constexpr std::size_t kRunLength = 1 << 14;
	const std::size_t apart = std::max<std::size_t>(field.tuples() / kRuns, kRunLength);
	Changes changes;
	const auto look = [&](auto number)
	{
		using Number = decltype(number);
		for (std::size_t begin = 0; begin < field.tuples(); begin += apart)
		{
			double last = numberAt<Number>(field.tuple(begin), 0);
			for (std::size_t t = begin + 1; t < std::min(field.tuples(), begin + kRunLength); ++t)
			{
				const double value = numberAt<Number>(field.tuple(t), 0);
				if (value == last)
					continue;
				++changes.all;
				const auto [lower, upper] = std::minmax(value, last);
				const auto next = std::ranges::upper_bound(values, lower);
				changes.to_next += next != values.end() && *next == upper;
				last = value;
			}
		}
	};
	withNumberType(field.type, look);
	return changes;
}

} // namespace vp::grid
