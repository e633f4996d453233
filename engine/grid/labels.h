#pragma once

#include "grid/field.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::grid
{

constexpr std::size_t kMaxCategories = 1024; // as many as a color map takes

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

/// Returns the different values of an array of one component, but gives up at more than `most`, which is at most
/// kMaxCategories. Uses all cores.
Distinct distinctValues(const Field& field, std::size_t most);

/// Counts changes, in runs of tuples that are spread evenly. values: ascending, of this array and perhaps of others.
Changes changesOf(const Field& field, std::span<const double> values);

} // namespace vp::grid
