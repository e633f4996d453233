#include "foam_text.h"

#include "foam_dictionary.h"
#include "vprobe-read/base/refusal.h"

#include <algorithm>
#include <charconv>

namespace vp::reader::codes
{

namespace
{

// Returns -1 if there is no such number.
std::int64_t wholeNumber(const FoamEntry* entry)
{
	std::int64_t number = -1;
	if (entry && entry->tokens.size() == 1)
	{
		const std::string_view digits = entry->tokens[0].text;
		const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
		if (error != std::errc() || end != digits.data() + digits.size())
			number = -1;
	}
	return std::max<std::int64_t>(number, -1);
}

// "inGroups 2(wall hot)", with or without the count and the type before it.
std::vector<std::string> wordsInParentheses(const FoamEntry* entry)
{
	std::vector<std::string> words;
	bool is_inside = false;
	if (entry)
		for (const FoamToken& token : entry->tokens)
		{
			if (is_inside && token.kind != FoamToken::Kind::mark)
				words.emplace_back(token.text);
			is_inside |= token.isMark('(');
		}
	if (entry && words.empty() && entry->tokens.size() == 1)
		words.emplace_back(entry->tokens[0].text);
	return words;
}

} // namespace

FoamHead foamHead(std::string_view text)
{
	FoamCursor at(text);
	return parseFoamHead(at);
}

FoamList foamPoints(std::string_view text)
{
	FoamCursor at(text);
	parseFoamHead(at);
	return at.reals(3);
}

FoamFaces foamFaces(std::string_view text)
{
	FoamCursor at(text);
	const FoamHead head = parseFoamHead(at);
	return at.faces(head.type == "faceCompactList");
}

std::vector<std::int64_t> foamLabels(std::string_view text, std::size_t most)
{
	FoamCursor at(text);
	parseFoamHead(at);
	return at.labels(most);
}

std::vector<FoamPatch> foamPatches(std::string_view text)
{
	FoamCursor at(text);
	parseFoamHead(at);
	if (at.peek() != '(')
		at.integer();
	at.expect('(');
	FoamDictionary all;
	parseFoamEntries(at, all, ')');
	at.expect(')');
	std::vector<FoamPatch> patches;
	for (const FoamEntry& entry : all.entries())
	{
		if (!entry.dictionary)
			throw damaged("a patch without its braces");
		const auto wordOf = [&](std::string_view key)
		{
			const FoamEntry* word = entry.dictionary->find(key);
			return std::string(word && !word->tokens.empty() ? word->tokens[0].text : "");
		};
		FoamPatch patch;
		patch.name = entry.key;
		patch.type = wordOf("type");
		patch.groups = wordsInParentheses(entry.dictionary->find("inGroups"));
		patch.first = wholeNumber(entry.dictionary->find("startFace"));
		patch.faces = wholeNumber(entry.dictionary->find("nFaces"));
		if (patch.first < 0 || patch.faces < 0)
			throw damaged("a patch has fewer than no faces, or no number of them");
		if (patch.type.starts_with("processor"))
		{
			patch.part_behind = wholeNumber(entry.dictionary->find("neighbProcNo"));
			patch.cyclic = wordOf("referPatch");
		}
		patches.push_back(std::move(patch));
	}
	return patches;
}

} // namespace vp::reader::codes
