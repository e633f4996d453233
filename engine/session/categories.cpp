#include "session/categories.h"

#include "grid/number_types.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

namespace vp::session
{

namespace
{

constexpr std::size_t kMostLabels = 32;  // values of an array that nothing but its values tells from others
constexpr std::size_t kFewLabels = 8;    // so few are no ramp
constexpr std::size_t kTuplesALabel = 8; // at least
constexpr double kOfRamp = 0.9;          // part of the changes that lead to the next value
constexpr std::size_t kTuplesAtOnce = 1 << 20;

// Different values in ascending order, up to one more than are counted. A plain struct, which may be sent as bytes.
struct Distinct
{
	std::size_t count = 0;
	std::array<double, kMaxCategories + 1> values{};

	bool isFull() const { return count == values.size(); }
	std::span<const double> all() const { return std::span(values).first(count); }
	void include(double value)
	{
		const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
		const auto place = std::lower_bound(values.begin(), end, value);
		if (isFull() || (place != end && *place == value))
			return;
		std::move_backward(place, end, end + 1);
		*place = value;
		++count;
	}
	void include(const Distinct& other)
	{
		for (const double value : other.all())
			include(value);
	}
};

// Changes from one tuple to the next.
struct Changes
{
	std::uint64_t all = 0;
	std::uint64_t to_next = 0; // to the value above or below

	void include(const Changes& other)
	{
		all += other.all;
		to_next += other.to_next;
	}
};

bool isInteger(const grid::Field& field)
{
	return field.type < grid::NumberType::float32;
}

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
		else if (const double value = grid::numberAt<Number>(bytes, i); count_ == 0 || value != last_)
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
Distinct valuesOfStored(const grid::Field& field, std::size_t most)
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

// Returns the values of an array, but gives up at more than `most`.
Distinct distinctValues(const grid::Field& field, std::size_t most)
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
		return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, field.tuples(), kTuplesAtOnce), Found(most),
		                            take, join)
		    .values();
	};
	return grid::withNumberType(field.type, scan);
}

// Looks at runs of tuples that are spread evenly.
Changes changesOf(const grid::Field& field, std::span<const double> values)
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
			double last = grid::numberAt<Number>(field.tuple(begin), 0);
			for (std::size_t t = begin + 1; t < std::min(field.tuples(), begin + kRunLength); ++t)
			{
				const double value = grid::numberAt<Number>(field.tuple(t), 0);
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
	grid::withNumberType(field.type, look);
	return changes;
}

// An array over all blocks.
struct OverBlocks
{
	std::string name;
	grid::Association association;
	std::vector<const grid::Field*> fields{};
	bool is_named = true;     // in every block a name or the file says what it is
	bool has_integers = true; // in every block; or the file says that they are labels
	bool is_scalar = true;
};

std::vector<OverBlocks> arraysOf(const grid::BlockSet& blocks)
{
	std::vector<OverBlocks> arrays;
	for (const grid::Block& block : blocks.blocks)
		for (const grid::Field& field : block.fields)
		{
			auto known =
			    std::ranges::find_if(arrays, [&](const OverBlocks& array)
			                         { return array.name == field.name && array.association == field.association; });
			if (known == arrays.end())
				known = arrays.insert(arrays.end(), {field.name, field.association});
			known->fields.push_back(&field);
			known->is_named = known->is_named && (block.imaging.labels || grid::namesCategories(field));
			known->has_integers = known->has_integers && (isInteger(field) || block.imaging.labels);
			known->is_scalar = known->is_scalar && field.components == 1;
		}
	return arrays;
}

bool isRamp(const OverBlocks& array, const Distinct& found, const ranks::Ranks& ranks)
{
	if (found.count <= kFewLabels)
		return false;
	Changes changes;
	for (const grid::Field* field : array.fields)
		changes.include(changesOf(*field, found.all()));
	changes = ranks.sum(changes, [](Changes& sum, const Changes& other) { sum.include(other); });
	return static_cast<double>(changes.to_next) >= kOfRamp * static_cast<double>(changes.all);
}

} // namespace

std::vector<CategoryArray> findCategories(const grid::BlockSet& blocks, const ranks::Ranks& ranks)
{
	std::vector<CategoryArray> categories;
	for (const OverBlocks& array : arraysOf(blocks))
	{
		if (!array.has_integers)
			continue;
		if (!array.is_scalar)
		{
			if (array.is_named)
				categories.push_back({array.name, array.association, {}});
			continue;
		}
		Distinct found;
		std::size_t tuples = 0;
		for (const grid::Field* field : array.fields)
		{
			found.include(distinctValues(*field, array.is_named ? kMaxCategories : kMostLabels));
			tuples += field->tuples();
		}
		found = ranks.sum(found, [](Distinct& sum, const Distinct& other) { sum.include(other); });
		tuples = ranks.sum(tuples, [](std::size_t& sum, std::size_t other) { sum += other; });
		const bool may_be = found.count <= kMostLabels && tuples >= kTuplesALabel * found.count && found.count > 1;
		if (array.is_named || (may_be && !isRamp(array, found, ranks)))
			categories.push_back(
			    {array.name, array.association,
			     found.isFull() ? std::vector<double>() : std::vector(found.all().begin(), found.all().end())});
	}
	return categories;
}

std::vector<std::pair<double, std::string>> labelNames(const grid::BlockSet& blocks, const grid::FieldChoice& field)
{
	const std::vector<const grid::Field*> fields = field.inEach(blocks);
	for (std::size_t b = 0; b < fields.size(); ++b)
		if (fields[b] && !blocks.blocks[b].imaging.label_names.empty())
			return blocks.blocks[b].imaging.label_names;
	return {};
}

bool markCategories(grid::BlockSet& blocks, const std::vector<CategoryArray>& found, view::Interpolate interpolate)
{
	const auto isFound = [&](const grid::Field& field)
	{
		return std::ranges::any_of(found, [&](const CategoryArray& array)
		                           { return array.name == field.name && array.association == field.association; });
	};
	bool has_changed = false;
	for (grid::Block& block : blocks.blocks)
		for (grid::Field& field : block.fields)
		{
			const bool is_marked = interpolate == view::Interpolate::automatic
			                           ? isFound(field)
			                           : interpolate == view::Interpolate::nearest;
			if (field.categorical == is_marked)
				continue; // other threads may read it
			field.categorical = is_marked;
			has_changed = true;
		}
	return has_changed;
}

} // namespace vp::session
