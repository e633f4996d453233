// Entries and their macros, as OpenFOAM reads them.
#include "foam_parser.h"

#include "foam_pattern.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vp::reader::codes
{

namespace
{

constexpr std::size_t kMaxPatterns = 256;   // in a dictionary; each name is held against all of them
constexpr std::size_t kMaxWork = 4'000'000; // tokens and entries that macros bring, and patterns that are tried

// The bytes of a number of this kind, as in "LSB;label=32;scalar=64".
int bytesOf(std::string_view arch, std::string_view name, int otherwise)
{
	const std::size_t found = arch.find(name);
	if (found == arch.npos)
		return otherwise;
	const std::string_view bits = arch.substr(std::min(found + name.size(), arch.size()), 2);
	return bits == "64" ? 8 : bits == "32" ? 4 : otherwise;
}

} // namespace

void FoamParser::readEntries(FoamInput& in, FoamDictionary& into, char end)
{
	const int conditions = std::exchange(conditions_, 0);
	while (in.at.peek() != 0 && in.at.peek() != end)
	{
		const FoamToken key = in.at.token();
		if (key.kind == FoamToken::Kind::directive)
			readDirective(key.text, in, into);
		else if (key.kind == FoamToken::Kind::macro)
			substitute(key.text, in, into);
		else if (key.kind == FoamToken::Kind::word || key.kind == FoamToken::Kind::text)
			readEntry(std::string(key.text), key.kind == FoamToken::Kind::text, in, into);
		else if (!key.isMark(';'))
			throw damaged(fmt::format("\"{}\" where an entry begins", key.text.substr(0, 20)));
	}
	if (conditions_ > 0)
		throw damaged("an #if without its #endif");
	conditions_ = conditions;
}

void FoamParser::work(std::size_t steps)
{
	work_ += steps;
	if (work_ > kMaxWork)
		throw Refusal("its macros make more of it than can be meant; write the values out");
}

const FoamEntry* FoamParser::ofMacro(std::string_view name, const FoamDictionary& from, bool with_patterns)
{
	for (const FoamDictionary* at = &from; at; at = at->parent())
		work(1 + at->patterns());
	return from.ofMacro(name, with_patterns);
}

void FoamParser::put(FoamDictionary& into, FoamEntry entry)
{
	work(1);
	if (mode_ == Mode::keep_first && into.named(entry.key))
		return;
	into.put(std::move(entry));
	if (into.patterns() > kMaxPatterns)
		throw Refusal(fmt::format("it has more than {} patterns, which is not read", kMaxPatterns));
}

void FoamParser::readEntry(const std::string& key, bool is_pattern, FoamInput& in, FoamDictionary& into)
{
	FoamEntry entry;
	entry.key = key;
	if (is_pattern)
		entry.pattern = std::make_shared<const FoamPattern>(key);
	if (in.at.take('{'))
	{
		if (++depth_ > kMaxFoamNesting)
			throw damaged("its braces are nested deeper than any are");
		entry.dictionary = dictionaryFor(key, into);
		readEntries(in, *entry.dictionary, '}');
		in.at.expect('}');
		--depth_;
	}
	else
	{
		readValue(in, into, entry, false);
		if (const FoamEntry* whole = wholeDictionary(entry, into))
		{
			entry.tokens.clear();
			entry.dictionary = copyOf(*whole->dictionary, &into);
		}
	}
	put(into, std::move(entry));
}

const FoamEntry* FoamParser::wholeDictionary(const FoamEntry& entry, const FoamDictionary& from)
{
	if (entry.tokens.size() != 1 || entry.tokens[0].kind != FoamToken::Kind::macro)
		return nullptr;
	const FoamEntry* found = ofMacro(entry.tokens[0].text, from);
	return found && found->dictionary ? found : nullptr;
}

void FoamParser::readValue(FoamInput& in, const FoamDictionary& from, FoamEntry& entry, bool to_end)
{
	std::size_t depth = 0;
	while (!to_end || in.at.peek() != 0)
	{
		FoamToken token = in.at.token();
		if (token.isMark(';') && depth == 0)
			return;
		if (token.isMark('(') || token.isMark('{') || token.isMark('['))
			++depth;
		else if ((token.isMark(')') || token.isMark('}') || token.isMark(']')) && depth-- == 0)
			throw damaged("a bracket closes what none has opened");
		if (token.kind == FoamToken::Kind::directive && token.text.starts_with("#include"))
			includeValue(token.text, in, from, entry);
		else if (token.kind == FoamToken::Kind::directive)
			entry.unknown = fmt::format("{} is not run", token.text.substr(0, 20));
		else if (token.kind == FoamToken::Kind::macro)
			expand(token, from, entry);
		else
			entry.tokens.push_back(std::move(token));
	}
}

void FoamParser::expand(const FoamToken& macro, const FoamDictionary& from, FoamEntry& entry)
{
	std::string_view name = macro.text, otherwise;
	bool has_other = false;
	if (const std::size_t mark = name.find(":-"); mark != name.npos)
	{
		otherwise = name.substr(mark + 2);
		name = name.substr(0, mark);
		has_other = true;
	}
	const FoamEntry* found = ofMacro(name, from);
	if (found && found->dictionary)
		entry.tokens.push_back(macro); // see wholeDictionary()
	else if (found)
	{
		work(found->tokens.size());
		entry.tokens.insert(entry.tokens.end(), found->tokens.begin(), found->tokens.end());
		if (entry.unknown.empty())
			entry.unknown = found->unknown;
	}
	else if (has_other)
	{
		FoamCursor words(otherwise);
		while (words.peek() != 0)
			entry.tokens.push_back(words.token());
	}
	else if (entry.unknown.empty())
		entry.unknown = fmt::format("${} is not defined", name.substr(0, 40));
}

void FoamParser::substitute(std::string_view name, FoamInput& in, FoamDictionary& into)
{
	const FoamEntry* found = ofMacro(name, into, true);
	if (found && found->dictionary)
	{
		const auto copy = copyOf(*found->dictionary, nullptr); // it may be one around, which grows meanwhile
		for (const FoamEntry& entry : copy->entries())
			merge(into, entry);
	}
	else if (found && found->tokens.size() == 1 && in.at.peek() != ';' && in.at.peek() != '}')
		readEntry(std::string(found->tokens[0].text), false, in, into);
	else
		skipped_.push_back(fmt::format("${} is not defined", name.substr(0, 40)));
}

void FoamParser::merge(FoamDictionary& into, FoamEntry entry)
{
	if (entry.dictionary)
	{
		const auto given = std::exchange(entry.dictionary, dictionaryFor(entry.key, into));
		for (const FoamEntry& each : given->entries())
			merge(*entry.dictionary, each);
	}
	put(into, std::move(entry));
}

std::shared_ptr<FoamDictionary> FoamParser::dictionaryFor(const std::string& key, const FoamDictionary& in) const
{
	const FoamEntry* before = mode_ == Mode::merge ? in.named(key) : nullptr;
	return before && before->dictionary ? before->dictionary : std::make_shared<FoamDictionary>(&in);
}

std::shared_ptr<FoamDictionary> FoamParser::copyOf(const FoamDictionary& dictionary, const FoamDictionary* parent)
{
	auto copy = std::make_shared<FoamDictionary>(parent);
	for (const FoamEntry& entry : dictionary.entries())
	{
		work(1 + entry.tokens.size());
		FoamEntry own = entry;
		if (own.dictionary)
			own.dictionary = copyOf(*own.dictionary, copy.get());
		copy->put(std::move(own));
	}
	return copy;
}

FoamHead parseFoamHead(FoamCursor& at)
{
	if (at.token().text != kFoamHeadName)
		throw damaged("it does not begin with FoamFile");
	at.expect('{');
	FoamDictionary entries;
	parseFoamEntries(at, entries, '}');
	at.expect('}');
	FoamHead head;
	const auto wordOf = [&](std::string_view key)
	{
		const FoamEntry* entry = entries.named(key);
		return entry && !entry->tokens.empty() ? std::string(entry->tokens[0].text) : std::string();
	};
	head.type = wordOf("class");
	head.object = wordOf("object");
	head.is_binary = wordOf("format") == "binary";
	const std::string arch = wordOf("arch");
	head.is_big_endian = arch.starts_with("MSB");
	head.label_bytes = bytesOf(arch, "label=", head.label_bytes);
	head.scalar_bytes = bytesOf(arch, "scalar=", head.scalar_bytes);
	at.setHead(head);
	return head;
}

void parseFoamEntries(FoamCursor& at, FoamDictionary& into, char end)
{
	const FoamFiles none;
	std::vector<FoamSource> included;
	std::vector<std::string> skipped;
	FoamInput in = {at, none.file};
	FoamParser(none, included, skipped).readEntries(in, into, end);
}

std::unique_ptr<FoamDocument> parseFoam(std::string_view text, const FoamFiles& files)
{
	auto document = std::make_unique<FoamDocument>();
	FoamCursor at(text);
	document->head = parseFoamHead(at);
	FoamInput in = {at, files.file};
	FoamParser(files, document->included, document->skipped).readEntries(in, document->root, 0);
	return document;
}

} // namespace vp::reader::codes
