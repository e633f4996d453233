#include "foam_text.h"

#include "foam_dictionary.h"
#include "vprobe-read/base/refusal.h"

#include <charconv>

namespace vp::reader::codes
{

namespace
{

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
	if (number < 0)
		throw damaged("a patch has fewer than no faces, or no number of them");
	return number;
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
		const FoamEntry* type = entry.dictionary->find("type");
		FoamPatch patch;
		patch.name = entry.key;
		patch.type = type && !type->tokens.empty() ? type->tokens[0].text : "";
		patch.groups = wordsInParentheses(entry.dictionary->find("inGroups"));
		patch.first = wholeNumber(entry.dictionary->find("startFace"));
		patch.faces = wholeNumber(entry.dictionary->find("nFaces"));
		patches.push_back(std::move(patch));
	}
	return patches;
}

} // namespace vp::reader::codes
