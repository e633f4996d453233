// Directives of OpenFOAM's files: included files, conditions, modes.
#include "foam_parser.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include "base/real_text.h"

#include <fmt/format.h>

#include <cctype>

namespace vp::reader::codes
{

namespace fs = std::filesystem;

namespace
{

constexpr std::size_t kMaxIncluded = 256; // files

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
	if (const std::optional<double> number = parseReal(word))
		return *number != 0;
	throw Refusal(fmt::format("its condition #if {} is not read", word.substr(0, 20)));
}

} // namespace

void FoamParser::readDirective(std::string_view name, FoamInput& in, FoamDictionary& into)
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

void FoamParser::setMode(std::string_view mode)
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

void FoamParser::removeEntries(FoamCursor& at, FoamDictionary& into)
{
	if (!at.take('('))
		return into.remove(at.token().text);
	while (at.peek() != ')')
		into.remove(at.token().text);
	at.expect(')');
}

std::string FoamParser::wordOfCondition(FoamCursor& at, const FoamDictionary& from)
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

void FoamParser::readCondition(std::string_view name, FoamCursor& at, const FoamDictionary& from)
{
	const std::string first = wordOfCondition(at, from);
	const bool holds = name == "#ifeq" ? first == wordOfCondition(at, from) : isTrue(first);
	++conditions_;
	if (!holds)
		skipBranch(at, true);
}

void FoamParser::skipBranch(FoamCursor& at, bool to_else)
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

void FoamParser::skipDirective(std::string_view name, FoamInput& in, const FoamDictionary& from)
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

std::optional<FoamSource> FoamParser::opened(std::string_view directive, FoamInput& in, const FoamDictionary& from)
{
	const std::string name(in.at.token().text);
	std::optional<FoamSource> source;
	if (files_.open && !directive.ends_with("Etc")) // those lie with OpenFOAM, not with the case
		source = files_.open(pathOf(name, in.file, from));
	if (source)
	{
		included_.push_back(*source);
		if (++depth_ > kMaxFoamNesting || included_.size() > kMaxIncluded)
			throw damaged("its files include each other without end");
	}
	return source;
}

std::string FoamParser::lackOf(std::string_view directive)
{
	return fmt::format("a file of {} is not there", directive);
}

fs::path FoamParser::pathOf(std::string name, const fs::path& file, const FoamDictionary& from)
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

FoamCursor FoamParser::inside(const FoamSource& source)
{
	FoamCursor at(source.text);
	FoamCursor ahead = at;
	if (ahead.peek() != 0 && ahead.token().text == kFoamHeadName)
		at.setHead(foamHead(source.text));
	return at;
}

void FoamParser::includeEntries(std::string_view directive, FoamInput& in, FoamDictionary& into)
{
	const std::optional<FoamSource> source = opened(directive, in, into);
	if (source)
	{
		FoamCursor at = inside(*source);
		FoamInput included = {at, source->path};
		readEntries(included, into, 0);
		--depth_;
	}
	else if (needsFile(directive))
		skipped_.push_back(lackOf(directive));
}

void FoamParser::includeValue(std::string_view directive, FoamInput& in, const FoamDictionary& from, FoamEntry& entry)
{
	const std::optional<FoamSource> source = opened(directive, in, from);
	if (source)
	{
		FoamCursor at = inside(*source);
		FoamInput included = {at, source->path};
		readValue(included, from, entry, true);
		--depth_;
	}
	else if (needsFile(directive))
		entry.unknown = lackOf(directive);
}

} // namespace vp::reader::codes
