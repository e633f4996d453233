#include "session/categories.h"

#include "grid/array_facts.h"

#include <algorithm>

namespace vp::session
{

namespace
{

constexpr std::size_t kMostLabels = 32;  // values of an array that nothing but its values tells from others
constexpr std::size_t kFewLabels = 8;    // so few are no ramp
constexpr std::size_t kTuplesALabel = 8; // at least
constexpr double kOfRamp = 0.9;          // part of the changes that lead to the next value

bool isInteger(const grid::Field& field)
{
	return field.type < grid::NumberType::float32;
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

bool isRamp(const OverBlocks& array, const grid::Distinct& found, const ranks::Ranks& ranks)
{
	if (found.count <= kFewLabels)
		return false;
	grid::Changes changes;
	for (const grid::Field* field : array.fields)
		changes.include(field->facts ? field->facts->changes : grid::changesOf(*field, found.all()));
	changes = ranks.sum(changes, [](grid::Changes& sum, const grid::Changes& other) { sum.include(other); });
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
		grid::Distinct found;
		std::size_t tuples = 0;
		for (const grid::Field* field : array.fields)
		{
			found.include(field->facts
			                  ? field->facts->values
			                  : grid::distinctValues(*field, array.is_named ? grid::kMaxCategories : kMostLabels));
			tuples += field->facts ? field->facts->tuples : field->tuples();
		}
		found = ranks.sum(found, [](grid::Distinct& sum, const grid::Distinct& other) { sum.include(other); });
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
