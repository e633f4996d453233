#include "grid/field_choice.h"

#include <fmt/format.h>

#include <array>
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

// The names of all components of an array of several.
std::string componentNames(int components)
{
	std::vector<std::string> names;
	for (int c = 0; c < components; ++c)
		names.push_back(componentName(c, components));
	return components > 9 ? fmt::format("0 to {}", components - 1) : fmt::format("{}", fmt::join(names, ", "));
}

// A component of a tensor by its row and column, before the array is known.
constexpr int tensorComponent(int row, int column)
{
	return grid::kMagnitude - 1 - 3 * row - column;
}

// Components of symmetric tensors, by row and column.
constexpr std::array<std::array<int, 3>, 3> kSymmetric = {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};

Result<int> chooseComponent(const grid::Field& field, std::optional<int> component)
{
	if (!component)
		return field.components == 1 ? 0 : grid::kMagnitude;
	int chosen = *component;
	if (chosen < grid::kMagnitude && (field.components == 6 || field.components == 9))
	{
		const int at = grid::kMagnitude - 1 - chosen;
		chosen = field.components == 9 ? at : kSymmetric[at / 3][at % 3];
	}
	if (chosen == grid::kMagnitude || (chosen >= 0 && chosen < field.components && field.components > 1))
		return chosen;
	const std::string which = field.components == 1
	                              ? "leave it out, or use magnitude for its absolute value"
	                              : fmt::format("use {}, or magnitude", componentNames(field.components));
	return Error{ErrorKind::usage,
	             fmt::format("`component` {}: array {} has {} component{}; {}", componentText(*component), field.name,
	                         field.components, field.components == 1 ? "" : "s", which)};
}

} // namespace

std::string componentName(int component, int components)
{
	if (component == grid::kMagnitude)
		return "magnitude";
	if (components <= 3)
		return std::string(1, "xyz"[component]);
	if (components == 6 || components == 9)
		for (int row = 0; row < 3; ++row)
			for (int column = 0; column < 3; ++column)
				if (component == (components == 9 ? 3 * row + column : kSymmetric[row][column]))
					return {"xyz"[row], "xyz"[column]};
	return fmt::to_string(component);
}

bool isCategorical(const BlockSet& blocks, const std::optional<FieldChoice>& field)
{
	return field && std::ranges::any_of(field->inEach(blocks),
	                                    [](const Field* of_block) { return of_block && of_block->categorical; });
}

std::optional<int> parseComponent(std::string_view text)
{
	if (text == "magnitude")
		return grid::kMagnitude;
	if (text.size() == 2 && text.find_first_not_of("xyz") == text.npos)
		return tensorComponent(text[0] - 'x', text[1] - 'x');
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
	if (component < grid::kMagnitude)
		return componentName(grid::kMagnitude - 1 - component, 9);
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
	return fmt::format("{} {}", name, componentName(component, field->components));
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
