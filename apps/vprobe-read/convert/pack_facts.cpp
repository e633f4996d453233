#include "pack_facts.h"

#include "grid/labels.h"
#include "grid/least_positive.h"
#include "hdf5_output.h"

#include <array>
#include <cstddef>
#include <span>

namespace vp::reader::convert
{

void PackFacts::include(const grid::Field& field)
{
	for (int component = 0; component <= field.components; ++component)
	{
		const int shown = component == field.components ? grid::kMagnitude : component;
		const auto span = grid::valueSpan(field, shown);
		spans_.insert(spans_.end(),
		              {span.lo, span.hi, span.minus_infinity ? 1.0 : 0.0, span.plus_infinity ? 1.0 : 0.0});
		// Where all values are above 0, nobody needs to look again.
		least_positive_.push_back(span.empty() ? 0.0 : span.lo > 0.0 ? span.lo : grid::leastPositive(field, shown));
	}
	if (field.components > 1 || field.type >= grid::NumberType::float32)
		return;
	const grid::Distinct found = grid::distinctValues(field, grid::kMaxCategories);
	const std::span different(found.values.data(), found.count);
	values_.insert(values_.end(), different.begin(), different.end());
	value_counts_.push_back(static_cast<std::uint32_t>(found.count));
	const grid::Changes changes = grid::changesOf(field, found.all());
	changes_.insert(changes_.end(), {changes.all, changes.to_next});
}

void PackFacts::write(hid_t facts, bool with_times) const
{
	writeValues(facts, "Spans", H5T_NATIVE_DOUBLE, {spans_.size() / 4, 4}, spans_.data());
	writeValues(facts, "LeastPositive", H5T_NATIVE_DOUBLE, {least_positive_.size()}, least_positive_.data());
	if (changes_.empty())
		return;
	writeValues(facts, "Values", H5T_NATIVE_DOUBLE, {values_.size()}, values_.data());
	if (with_times)
	{
		writeValues(facts, "NumberOfValues", H5T_NATIVE_UINT32, {value_counts_.size()}, value_counts_.data());
		writeValues(facts, "Changes", H5T_NATIVE_UINT64, {changes_.size() / 2, 2}, changes_.data());
	}
	else
		writeAttribute(facts, "Changes", H5T_NATIVE_UINT64, std::array{changes_[0], changes_[1]});
}

} // namespace vp::reader::convert
