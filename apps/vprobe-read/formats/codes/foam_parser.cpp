// Entries with their macros, included files and conditions, as OpenFOAM reads them.
#include "foam_dictionary.h"
#include "foam_pattern.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include "base/real_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace fs = std::filesystem;

namespace
{

constexpr int kMaxNesting = 64;             // of braces and of included files
constexpr std::size_t kMaxIncluded = 256;   // files
constexpr std::size_t kMaxPatterns = 256;   // in a dictionary; each name is held against all of them
constexpr std::size_t kMaxWork = 4'000'000; // tokens and entries that macros bring, and patterns that are tried

constexpr std::string_view kHeadName = "FoamFile";

// The bytes of a number of this kind, as in "LSB;label=32;scalar=64".
int bytesOf(std::string_view arch, std::string_view name, int otherwise)
{
	const std::size_t found = arch.find(name);
	if (found == arch.npos)
		return otherwise;
	const std::string_view bits = arch.substr(std::min(found + name.size(), arch.size()), 2);
	return bits == "64" ? 8 : bits == "32" ? 4 : otherwise;
}

// A text and the file that it is of.
struct Input
{
	FoamCursor& at;
	const fs::path& file;
};

bool isInclude(std::string_view directive)
{
	return isOneOf(directive, {"#include", "#includeIfPresent", "#sinclude", "#includeEtc", "#sincludeEtc"});
}

bool needsFile(std::string_view directive)
{
	return directive == "#include" || directive == "#includeEtc";
}

bool isTrue(std::string_view word)
{
	if (isOneOf(word, {"true", "yes", "on", "y", "t"}))
		return true;
	if (isOneOf(word, {"false", "no", "off", "n", "f", "none"}))
		return false;
	if (const std::optional<double> number = vp::parseReal(word))
		return *number != 0;
	throw Refusal(fmt::format("its condition #if {} is not read", word.substr(0, 20)));
}

class FoamParser
{
public:
	FoamParser(const FoamFiles& files, std::vector<FoamSource>& included, std::vector<std::string>& skipped)
	    : files_(files), included_(included), skipped_(skipped)
	{
	}

	// Up to the closing mark, which stays, or the end.
	void readEntries(Input& in, FoamDictionary& into, char end)
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

private:
	enum class Mode
	{
		merge,
		overwrite,
		keep_first
	};

	void work(std::size_t steps)
	{
		work_ += steps;
		if (work_ > kMaxWork)
			throw Refusal("its macros make more of it than can be meant; write the values out");
	}

	const FoamEntry* ofMacro(std::string_view name, const FoamDictionary& from, bool with_patterns = false)
	{
		for (const FoamDictionary* at = &from; at; at = at->parent())
			work(1 + at->patterns());
		return from.ofMacro(name, with_patterns);
	}

	void put(FoamDictionary& into, FoamEntry entry)
	{
		work(1);
		if (mode_ == Mode::keep_first && into.named(entry.key))
			return;
		into.put(std::move(entry));
		if (into.patterns() > kMaxPatterns)
			throw Refusal(fmt::format("it has more than {} patterns, which is not read", kMaxPatterns));
	}

	void readEntry(const std::string& key, bool is_pattern, Input& in, FoamDictionary& into)
	{
		FoamEntry entry;
		entry.key = key;
		if (is_pattern)
			entry.pattern = std::make_shared<const FoamPattern>(key);
		if (in.at.take('{'))
		{
			if (++depth_ > kMaxNesting)
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

	// The dictionary that is all of a value, as in "outlet $inlet;".
	const FoamEntry* wholeDictionary(const FoamEntry& entry, const FoamDictionary& from)
	{
		if (entry.tokens.size() != 1 || entry.tokens[0].kind != FoamToken::Kind::macro)
			return nullptr;
		const FoamEntry* found = ofMacro(entry.tokens[0].text, from);
		return found && found->dictionary ? found : nullptr;
	}

	// The tokens up to the semicolon; of an included file those up to its end.
	void readValue(Input& in, const FoamDictionary& from, FoamEntry& entry, bool to_end)
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

	void expand(const FoamToken& macro, const FoamDictionary& from, FoamEntry& entry)
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

	// An entry by itself that is a macro: the entries of a dictionary, or a key.
	void substitute(std::string_view name, Input& in, FoamDictionary& into)
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

	void merge(FoamDictionary& into, FoamEntry entry)
	{
		if (entry.dictionary)
		{
			const auto given = std::exchange(entry.dictionary, dictionaryFor(entry.key, into));
			for (const FoamEntry& each : given->entries())
				merge(*entry.dictionary, each);
		}
		put(into, std::move(entry));
	}

	// The one that is there already, if dictionaries are merged.
	std::shared_ptr<FoamDictionary> dictionaryFor(const std::string& key, const FoamDictionary& in) const
	{
		const FoamEntry* before = mode_ == Mode::merge ? in.named(key) : nullptr;
		return before && before->dictionary ? before->dictionary : std::make_shared<FoamDictionary>(&in);
	}

	std::shared_ptr<FoamDictionary> copyOf(const FoamDictionary& dictionary, const FoamDictionary* parent)
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

	void readDirective(std::string_view name, Input& in, FoamDictionary& into)
	{
		if (isInclude(name))
			includeEntries(name, in, into);
		else if (name == "#inputMode")
			setMode(in.at.token().text);
		else if (name == "#remove")
			removeEntries(in.at, into);
		else if (name == "#if" || name == "#ifeq")
			readCondition(name, in.at, into);
		else if (name == "#else" && conditions_ > 0)
			skipBranch(in.at, false);
		else if (name == "#endif" && conditions_ > 0)
			--conditions_;
		else
			skipDirective(name, in, into);
	}

	void setMode(std::string_view mode)
	{
		if (mode == "merge" || mode == "default")
			mode_ = Mode::merge;
		else if (mode == "overwrite")
			mode_ = Mode::overwrite;
		else if (mode == "protect" || mode == "warn" || mode == "error")
			mode_ = Mode::keep_first;
		else
			throw Refusal(fmt::format("its #inputMode {} is not read", mode.substr(0, 20)));
	}

	void removeEntries(FoamCursor& at, FoamDictionary& into)
	{
		if (!at.take('('))
			return into.remove(at.token().text);
		while (at.peek() != ')')
			into.remove(at.token().text);
		at.expect(')');
	}

	// What stands for one word of a condition.
	std::string wordOfCondition(FoamCursor& at, const FoamDictionary& from)
	{
		const FoamToken token = at.token();
		FoamEntry entry;
		if (token.kind == FoamToken::Kind::macro)
			expand(token, from, entry);
		else if (token.kind == FoamToken::Kind::directive)
			throw Refusal(fmt::format("its condition {} is not run", token.text.substr(0, 20)));
		else
			entry.tokens.push_back(token);
		std::string words;
		for (const FoamToken& each : entry.tokens)
			(words += words.empty() ? "" : " ") += each.text;
		return words;
	}

	void readCondition(std::string_view name, FoamCursor& at, const FoamDictionary& from)
	{
		const std::string first = wordOfCondition(at, from);
		const bool holds = name == "#ifeq" ? first == wordOfCondition(at, from) : isTrue(first);
		++conditions_;
		if (!holds)
			skipBranch(at, true);
	}

	// Behind the #endif, or behind the #else if it is wanted.
	void skipBranch(FoamCursor& at, bool to_else)
	{
		for (int inner = 0;;)
		{
			const FoamToken token = at.token();
			if (token.kind != FoamToken::Kind::directive)
				continue;
			if (token.text == "#if" || token.text == "#ifeq")
				++inner;
			else if (token.text == "#endif" && inner-- == 0)
			{
				--conditions_;
				return;
			}
			else if (token.text == "#else" && inner == 0 && to_else)
				return;
		}
	}

	// Those that run code: the line with its block.
	void skipDirective(std::string_view name, Input& in, const FoamDictionary& from)
	{
		FoamEntry none;
		if (in.at.peek() == '{' || in.at.peek() == '"')
		{
			in.at.restOfLine();
			if (in.at.take('{'))
				readValue(in, from, none, false);
		}
		else
			in.at.restOfLine();
		skipped_.push_back(fmt::format("{} is not run", name.substr(0, 20)));
	}

	// The file that is named next; nothing if it is not there.
	std::optional<FoamSource> opened(std::string_view directive, Input& in, const FoamDictionary& from)
	{
		const std::string name(in.at.token().text);
		std::optional<FoamSource> source;
		if (files_.open && !directive.ends_with("Etc")) // those lie with OpenFOAM, not with the case
			source = files_.open(pathOf(name, in.file, from));
		if (source)
		{
			included_.push_back(*source);
			if (++depth_ > kMaxNesting || included_.size() > kMaxIncluded)
				throw damaged("its files include each other without end");
		}
		return source;
	}

	static std::string lackOf(std::string_view directive)
	{
		return fmt::format("a file of {} is not there", directive);
	}

	fs::path pathOf(std::string name, const fs::path& file, const FoamDictionary& from)
	{
		for (std::size_t at = name.find('$'); at != name.npos; at = name.find('$', at + 1))
		{
			const bool in_braces = name.substr(at + 1, 1) == "{";
			std::size_t end = at + 1 + in_braces;
			while (end < name.size() && (std::isalnum(static_cast<unsigned char>(name[end])) || name[end] == '_'))
				++end;
			const std::string variable = name.substr(at + 1 + in_braces, end - at - 1 - in_braces);
			const FoamEntry* found = ofMacro(variable, from);
			std::string value = variable == "FOAM_CASE" ? files_.case_folder.string() : "";
			if (found && found->tokens.size() == 1)
				value = std::string(found->tokens[0].text);
			if (value.find('$') == value.npos)
				name.replace(at, end + in_braces - at, value);
		}
		for (const std::string_view folder : {"case", "constant", "system"})
			if (const std::string mark = fmt::format("<{}>", folder); name.starts_with(mark))
				name = (files_.case_folder / (folder == "case" ? "" : folder)).string() + name.substr(mark.size());
		const fs::path path = name;
		return path.is_absolute() ? path : file.parent_path() / path;
	}

	static FoamCursor inside(const FoamSource& source)
	{
		FoamCursor at(source.text);
		FoamCursor ahead = at;
		if (ahead.peek() != 0 && ahead.token().text == kHeadName)
			at.setHead(foamHead(source.text));
		return at;
	}

	void includeEntries(std::string_view directive, Input& in, FoamDictionary& into)
	{
		const std::optional<FoamSource> source = opened(directive, in, into);
		if (source)
		{
			FoamCursor at = inside(*source);
			Input included = {at, source->path};
			readEntries(included, into, 0);
			--depth_;
		}
		else if (needsFile(directive))
			skipped_.push_back(lackOf(directive));
	}

	void includeValue(std::string_view directive, Input& in, const FoamDictionary& from, FoamEntry& entry)
	{
		const std::optional<FoamSource> source = opened(directive, in, from);
		if (source)
		{
			FoamCursor at = inside(*source);
			Input included = {at, source->path};
			readValue(included, from, entry, true);
			--depth_;
		}
		else if (needsFile(directive))
			entry.unknown = lackOf(directive);
	}

	const FoamFiles& files_;
	std::vector<FoamSource>& included_;
	std::vector<std::string>& skipped_;
	Mode mode_ = Mode::merge;
	int depth_ = 0;
	int conditions_ = 0; // open ones
	std::size_t work_ = 0;
};

} // namespace

FoamHead parseFoamHead(FoamCursor& at)
{
	if (at.token().text != kHeadName)
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
	Input in = {at, none.file};
	FoamParser(none, included, skipped).readEntries(in, into, end);
}

std::unique_ptr<FoamDocument> parseFoam(std::string_view text, const FoamFiles& files)
{
	auto document = std::make_unique<FoamDocument>();
	FoamCursor at(text);
	document->head = parseFoamHead(at);
	Input in = {at, files.file};
	FoamParser(files, document->included, document->skipped).readEntries(in, document->root, 0);
	return document;
}
