#include "foam_field.h"

#include "vprobe-read/base/is_one_of.h"

#include "base/real_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace vp::reader::codes
{

namespace
{

// Walks through the tokens of a value.
class FoamValueReader
{
public:
	FoamValueReader(const std::vector<FoamToken>& tokens, int components) : tokens_(tokens), components_(components)
	{
		for (const FoamToken& token : tokens)
			if (token.kind == FoamToken::Kind::macro)
				throw FoamUnknown(fmt::format("${} is a dictionary", token.text.substr(0, 40)));
	}

	std::shared_ptr<const FoamList> read()
	{
		const FoamToken& first = next();
		std::shared_ptr<const FoamList> list;
		if (first.text == "uniform")
		{
			skipDimensions();
			FoamList one;
			one.components = components_;
			one.is_uniform = true;
			element(one.numbers);
			list = std::make_shared<const FoamList>(std::move(one));
		}
		else if (first.text == "nonuniform")
			list = readList();
		else
			throw FoamUnknown(fmt::format("\"{}\" where uniform or nonuniform is wanted", first.text.substr(0, 20)));
		if (at_ != tokens_.size())
			throw damaged(fmt::format("\"{}\" behind a value", next().text.substr(0, 20)));
		return list;
	}

	// A value behind "uniform" or the like, or one by itself.
	void element(std::vector<double>& numbers)
	{
		const bool in_parentheses = take('(');
		if (components_ > 1 && !in_parentheses)
			throw damaged("it has no \"(\" where one is wanted");
		for (int c = 0; c < components_; ++c)
		{
			const std::string_view word = next().text;
			const std::optional<double> number = parseReal(word);
			if (!number)
				throw damaged(fmt::format("\"{}\" where a number is wanted", word.substr(0, 20)));
			numbers.push_back(*number);
		}
		if (in_parentheses)
			expect(')');
	}

private:
	const FoamToken& next()
	{
		if (at_ >= tokens_.size())
			throw damaged("a value ends early");
		return tokens_[at_++];
	}

	bool take(char mark)
	{
		if (at_ >= tokens_.size() || !tokens_[at_].isMark(mark))
			return false;
		++at_;
		return true;
	}

	void expect(char mark)
	{
		if (!take(mark))
			throw damaged(fmt::format("it has no \"{}\" where one is wanted", mark));
	}

	// "[0 1 -1 0 0 0 0]" only tells the dimensions; a unit in words would be another number.
	void skipDimensions()
	{
		if (!take('['))
			return;
		while (!take(']'))
			if (const std::string_view word = next().text; !parseReal(word))
				throw FoamUnknown(fmt::format("its unit [{}] is not converted", word.substr(0, 20)));
	}

	std::shared_ptr<const FoamList> readList()
	{
		if (at_ < tokens_.size() && tokens_[at_].kind == FoamToken::Kind::list)
		{
			const FoamToken& token = next();
			if (!token.list || token.list->components != components_)
				throw damaged(fmt::format("it has a {} where another list is wanted", token.text.substr(0, 40)));
			return token.list;
		}
		// Without its type, as early versions wrote it.
		FoamList list;
		list.components = components_;
		std::size_t announced = FoamList::kAny;
		if (at_ < tokens_.size() && !tokens_[at_].isMark('('))
		{
			const std::string_view word = next().text;
			const std::optional<double> count = parseReal(word);
			if (!count || !(*count >= 0) || *count > 1e18)
				throw damaged(fmt::format("\"{}\" where a list is wanted", word.substr(0, 40)));
			announced = static_cast<std::size_t>(*count);
		}
		if (take('{'))
		{
			list.is_uniform = true;
			list.announced = announced;
			element(list.numbers);
			expect('}');
		}
		else if (announced != 0 || (at_ < tokens_.size() && tokens_[at_].isMark('(')))
		{
			expect('(');
			while (!take(')'))
				element(list.numbers);
			if (announced != FoamList::kAny && !list.fits(announced))
				throw damaged(fmt::format("a list of {} has {} elements", announced, list.size()));
		}
		return std::make_shared<const FoamList>(std::move(list));
	}

	const std::vector<FoamToken>& tokens_;
	int components_;
	std::size_t at_ = 0;
};

std::shared_ptr<const FoamList> foamValueOf(const FoamEntry& entry, int components)
{
	if (!entry.unknown.empty())
		throw FoamUnknown(entry.unknown);
	if (entry.dictionary)
		throw FoamUnknown(fmt::format("its {} is a dictionary", entry.key.substr(0, 40)));
	return FoamValueReader(entry.tokens, components).read();
}

std::shared_ptr<const FoamList> uniformOf(std::vector<double> numbers)
{
	FoamList list;
	list.components = static_cast<int>(numbers.size());
	list.is_uniform = true;
	list.numbers = std::move(numbers);
	return std::make_shared<const FoamList>(std::move(list));
}

// "uniformValue 3;", "uniformValue constant 3;" or "uniformValue uniform 3;": all else changes with time.
std::shared_ptr<const FoamList> constantOf(const FoamEntry& entry, int components)
{
	std::vector<FoamToken> tokens = entry.tokens;
	if (!tokens.empty() && isOneOf(tokens[0].text, {"constant", "uniform"}))
		tokens.erase(tokens.begin());
	const bool is_number = !tokens.empty() && (tokens[0].isMark('(') || parseReal(tokens[0].text));
	if (!entry.unknown.empty() || !is_number)
		throw FoamUnknown("its uniformValue is no constant");
	std::vector<double> numbers;
	FoamValueReader(tokens, components).element(numbers);
	return uniformOf(std::move(numbers));
}

const FoamEntry* entryOfPatch(const FoamDictionary& boundary, const FoamPatch& patch)
{
	if (const FoamEntry* own = boundary.named(patch.name); own && !own->pattern)
		return own;
	const auto& entries = boundary.entries();
	for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) // the last group wins
		if (!entry->pattern && std::ranges::find(patch.groups, entry->key) != patch.groups.end())
			return &*entry;
	return boundary.find(patch.name);
}

// Patches that follow from the geometry, so that a file need not name them.
bool isConstraint(std::string_view type)
{
	return isOneOf(type, {"empty", "wedge", "symmetry", "symmetryPlane"}) || type.starts_with("cyclic") ||
	       type.starts_with("processor");
}

std::shared_ptr<const FoamList> valuesAtPatch(const FoamDictionary* boundary, const FoamPatch& patch, int components)
{
	const FoamEntry* entry = boundary ? entryOfPatch(*boundary, patch) : nullptr;
	if (!entry && isConstraint(patch.type))
		return nullptr;
	if (!entry || !entry->dictionary)
		throw FoamUnknown("it has no entry");
	const FoamEntry* value = entry->dictionary->find("value");
	const FoamEntry* type = entry->dictionary->find("type");
	const std::string_view kind = type && !type->tokens.empty() ? type->tokens[0].text : "";
	if (value)
	{
		std::shared_ptr<const FoamList> values = foamValueOf(*value, components);
		if (!values->fits(static_cast<std::size_t>(patch.faces)))
			throw FoamUnknown(fmt::format("it has {} values for {} faces", values->size(), patch.faces));
		return values;
	}
	if (kind == "noSlip")
		return uniformOf(std::vector<double>(static_cast<std::size_t>(components)));
	if (const FoamEntry* uniform = entry->dictionary->find("uniformValue"); uniform && kind == "uniformFixedValue")
		return constantOf(*uniform, components);
	return nullptr;
}

// Adds a level to all values of a field.
void raise(std::shared_ptr<const FoamList>& list, const std::vector<double>& level)
{
	FoamList raised = *list;
	for (std::size_t i = 0; i < raised.numbers.size(); ++i)
		raised.numbers[i] += level[i % level.size()];
	list = std::make_shared<const FoamList>(std::move(raised));
}

// That of a file whose value depends on what was left out.
std::string withSkipped(std::string reason, const FoamDocument& document)
{
	for (const std::string& each : document.skipped)
		if (reason.find(each) == reason.npos)
			reason += "; " + each;
	return reason;
}

} // namespace

int foamComponentsOfField(std::string_view type)
{
	for (const std::string_view kind : {"vol", "point"})
	{
		if (!type.starts_with(kind))
			continue;
		std::string_view rest = type.substr(kind.size());
		rest = rest.substr(0, rest.find("Field"));
		if (rest.empty() || rest.size() + kind.size() == type.size())
			return 0;
		std::string name(rest);
		name[0] = static_cast<char>(name[0] - 'A' + 'a');
		return foamComponents(name);
	}
	return 0;
}

FoamField foamField(const FoamDocument& document, std::size_t elements, std::span<const FoamPatch> patches)
{
	const int components = foamComponentsOfField(document.head.type);
	if (components == 0)
		throw damaged("it is no field of cells or points");
	const FoamEntry* inside = document.root.find("internalField");
	if (!inside)
		inside = document.root.find("value"); // the field has no boundary
	if (!inside)
		throw FoamUnknown(withSkipped("it has no internalField", document));
	FoamField field;
	try
	{
		field.inside = foamValueOf(*inside, components);
	}
	catch (const FoamUnknown& unknown)
	{
		throw FoamUnknown(withSkipped(unknown.what(), document));
	}
	if (!field.inside->fits(elements))
		throw damaged(fmt::format("it has {} values, where the mesh wants {}", field.inside->size(), elements));
	std::vector<double> level;
	if (const FoamEntry* raised = document.root.find("referenceLevel"); raised && raised->unknown.empty())
		FoamValueReader(raised->tokens, components).element(level);
	else if (raised)
		throw FoamUnknown(raised->unknown);
	if (!level.empty())
		raise(field.inside, level);

	const FoamEntry* boundary = document.root.find("boundaryField");
	const bool has_boundary = document.head.type.find("::Internal") == std::string::npos && inside->key != "value";
	if (!has_boundary)
		field.patches.resize(patches.size());
	for (const FoamPatch& patch : has_boundary ? patches : patches.first(0))
	{
		FoamPatchValues values;
		try
		{
			values.values = valuesAtPatch(boundary ? boundary->dictionary.get() : nullptr, patch, components);
			if (values.values && !level.empty())
				raise(values.values, level);
		}
		catch (const FoamUnknown& unknown)
		{
			values.unknown = withSkipped(unknown.what(), document);
		}
		field.patches.push_back(std::move(values));
	}
	return field;
}

} // namespace vp::reader::codes
