#include "grid/field_choice.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace vp::grid
{

namespace
{

const grid::Field* findField(const grid::Block& block, const std::string& name,
                             std::optional<grid::Association> association)
{
	for (const grid::Field& field : block.fields)
		if (field.name == name && (!association || field.association == *association))
			return &field;
	return nullptr;
}

// Point arrays come first, as everywhere a name is looked for.
const grid::Field* findField(const grid::BlockSet& blocks, const std::string& name,
                             std::optional<grid::Association> association)
{
	for (const grid::Association wanted : {grid::Association::point, grid::Association::cell})
		if (!association || association == wanted)
			for (const grid::Block& block : blocks.blocks)
				if (const grid::Field* field = findField(block, name, wanted))
					return field;
	return nullptr;
}

const grid::Field* firstField(const grid::BlockSet& blocks)
{
	for (const grid::Association wanted : {grid::Association::point, grid::Association::cell})
		for (const grid::Block& block : blocks.blocks)
			for (const grid::Field& field : block.fields)
				if (field.association == wanted)
					return &field;
	return nullptr;
}

std::string listFields(const grid::BlockSet& blocks)
{
	std::vector<std::string> names;
	const auto add = [&](std::string name)
	{
		if (std::find(names.begin(), names.end(), name) == names.end())
			names.push_back(std::move(name));
	};
	for (const grid::Block& block : blocks.blocks)
	{
		for (const grid::Field& field : block.fields)
			add(fmt::format("{}:{}", grid::associationName(field.association), field.name));
		for (const std::string& name : block.arrays_left_out)
			add(name);
	}
	return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

// Returns true if some shown value is not NaN.
bool hasNumber(const grid::Field& field, int component)
{
	const int first = component == grid::kMagnitude ? 0 : component;
	const int last = component == grid::kMagnitude ? field.components - 1 : component;
	for (std::size_t t = 0; t < field.tuples(); ++t)
	{
		bool number = true;
		for (int c = first; c <= last; ++c)
			number = number && !std::isnan(field.value(t, c));
		if (number)
			return true;
	}
	return false;
}

Result<int> chooseComponent(const grid::Field& field, std::optional<int> component)
{
	if (!component)
		return field.components == 1 ? 0 : grid::kMagnitude;
	if (*component >= field.components)
		return Error{
		    ErrorKind::usage,
		    fmt::format("`component` {}: array {} has {} component{}; use {}", componentText(*component), field.name,
		                field.components, field.components == 1 ? "" : "s",
		                field.components == 1 ? "0" : fmt::format("0 to {} or magnitude", field.components - 1))};
	return *component;
}

} // namespace

std::optional<int> parseComponent(std::string_view text)
{
	if (text == "magnitude")
		return grid::kMagnitude;
	if (text == "x" || text == "y" || text == "z")
		return text[0] - 'x';
	int component = -1;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), component);
	if (error != std::errc() || end != text.data() + text.size() || component < 0)
		return std::nullopt;
	return component;
}

std::string componentText(int component)
{
	if (component == grid::kMagnitude)
		return "magnitude";
	return component < 3 ? std::string(1, "xyz"[component]) : fmt::to_string(component);
}

const grid::Field* FieldChoice::in(const grid::Block& block) const
{
	const grid::Field* field = findField(block, name, association);
	return field && component < field->components ? field : nullptr;
}

std::vector<const grid::Field*> FieldChoice::inEach(const grid::BlockSet& blocks) const
{
	std::vector<const grid::Field*> fields;
	for (const grid::Block& block : blocks.blocks)
		fields.push_back(in(block));
	return fields;
}

std::string FieldChoice::title(const grid::BlockSet& blocks) const
{
	const grid::Field* field = findField(blocks, name, association);
	if (!field || (field->components == 1 && component == 0))
		return name;
	if (component == grid::kMagnitude)
		return name + " magnitude";
	return component < 3 && field->components <= 3 ? fmt::format("{} {}", name, "xyz"[component])
	                                               : fmt::format("{} {}", name, component);
}

Result<std::optional<FieldChoice>> chooseField(const grid::BlockSet& blocks, const std::string& array,
                                               std::optional<int> component, const char* setting)
{
	std::optional<grid::Association> association;
	std::string name = array;
	// An array may have a colon in its own name, so the whole text is tried before a prefix is taken off.
	if (!array.empty() && !findField(blocks, array, {}))
		for (const grid::Association candidate : {grid::Association::point, grid::Association::cell})
			if (const std::string prefix = std::string(grid::associationName(candidate)) + ":";
			    array.starts_with(prefix))
			{
				association = candidate;
				name = array.substr(prefix.size());
			}
	const grid::Field* field = array.empty() ? firstField(blocks) : findField(blocks, name, association);
	if (!field && array.empty())
	{
		if (component)
			return Error{ErrorKind::input,
			             fmt::format("`component` {}: the input has no array", componentText(*component))};
		return std::optional<FieldChoice>{};
	}
	if (!field)
		return Error{ErrorKind::input,
		             fmt::format("{} {}: no such array; there are: {}", setting, array, listFields(blocks))};
	Result<int> chosen = chooseComponent(*field, component);
	if (!chosen)
		return chosen.error();
	return std::optional<FieldChoice>{{field->name, field->association, *chosen}};
}

std::pair<double, double> fieldRange(const grid::BlockSet& blocks, const FieldChoice& choice)
{
	// A block without values (all NaN, or none at all) reports {0, 0} and must not widen the range of the others.
	std::pair<double, double> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
	for (const grid::Block& block : blocks.blocks)
		if (const grid::Field* field = choice.in(block); field)
		{
			const auto [lo, hi] = grid::fieldRange(*field, choice.component);
			if (lo == 0.0 && hi == 0.0 && !hasNumber(*field, choice.component))
				continue;
			range.first = std::min(range.first, lo);
			range.second = std::max(range.second, hi);
		}
	return range.first <= range.second ? range : std::pair{0.0, 0.0};
}

} // namespace vp::grid
