#include "context_options.h"

#include "find/listed.h"
#include "mesh/boundary_surface.h"
#include "mesh/listed_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

namespace vp::app
{

namespace
{

// Faint: what is within is to be seen, and a boundary is looked through at least twice.
constexpr double kBoundaryOpacity = 0.15;

// A part of what is seen through, so it may be seen better.
constexpr double kPartOpacity = 0.3;

Error wrong(const std::string& word, const std::string& what)
{
	return {ErrorKind::usage, fmt::format("--context {}: {}", word, what)};
}

Result<mesh::SheetMesh> gridSurface(const grid::BlockSet& blocks, const ContextChoice& choice)
{
	const std::string text = fmt::format("{}={}", choice.kind->name, choice.argument);
	const Result<surface::GridIndexRange> range = surface::parseGridIndex(text);
	if (!range)
		return wrong(choice.word, range.error().message);
	if (!range->isOne())
		return wrong(choice.word, "stands still; give one index");
	if (Status fits = find::checkGridIndex(blocks, *range); !fits)
		return Error{fits.error().kind, fmt::format("--context {}: {}", choice.word, fits.error().message)};
	const surface::GridIndex at = range->at(0.0);
	return mesh::gridIndexMesh(blocks, at, find::gridIndexCells(blocks, at));
}

Result<mesh::SheetMesh> patch(const grid::BlockSet& blocks, const ContextChoice& choice)
{
	if (Status known = find::checkPatch(blocks, choice.argument); !known)
		return Error{known.error().kind, fmt::format("--context {}: {}", choice.word, known.error().message)};
	return mesh::patchMesh(blocks, choice.argument, find::patchCells(blocks, choice.argument));
}

constexpr std::array kKinds{
    ContextKind{"boundary", nullptr, kBoundaryOpacity,
                [](const grid::BlockSet& blocks, const ContextChoice&) -> Result<mesh::SheetMesh>
                { return mesh::boundarySurface(blocks); }},
    ContextKind{"i", "N", kPartOpacity, gridSurface},
    ContextKind{"j", "N", kPartOpacity, gridSurface},
    ContextKind{"k", "N", kPartOpacity, gridSurface},
    ContextKind{"patch", "NAME", kPartOpacity, patch},
};

std::optional<double> number(std::string_view text)
{
	double value = 0.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
	if (error != std::errc() || end != text.data() + text.size())
		return std::nullopt;
	return value;
}

// `what` is KIND[=ARGUMENT].
Result<ContextChoice> choose(const std::string& word, std::string_view what)
{
	const std::size_t equals = what.find('=');
	const std::string_view name = what.substr(0, equals);
	const auto* kind = std::ranges::find_if(kKinds, [&](const ContextKind& k) { return name == k.name; });
	if (kind == kKinds.end())
		return wrong(word, fmt::format("there is no such context; take {}", contextForms()));
	const std::string_view argument = equals == what.npos ? std::string_view() : what.substr(equals + 1);
	if (!kind->argument && equals != what.npos)
		return wrong(word, fmt::format("{} takes nothing behind =; leave it out", kind->name));
	if (kind->argument && argument.empty())
		return wrong(word, fmt::format("{} needs to know which; write {}={}", kind->name, kind->name, kind->argument));
	return ContextChoice{kind, std::string(argument), kind->opacity, word};
}

Result<ContextChoice> parseContext(const std::string& word)
{
	const std::string_view text = word;
	const std::size_t colon = text.rfind(':');
	const std::optional<double> opacity = colon == text.npos ? std::nullopt : number(text.substr(colon + 1));
	Result<ContextChoice> choice = choose(word, opacity ? text.substr(0, colon) : text);
	if (!choice || !opacity)
		return choice;
	if (!(*opacity >= 0.0 && *opacity <= 1.0))
		return wrong(word, "an opacity is a number from 0 to 1");
	choice->opacity = *opacity;
	return choice;
}

} // namespace

std::string contextForms()
{
	std::string forms;
	for (const ContextKind& kind : kKinds)
		forms += fmt::format("{}{}{}[:OPACITY]", forms.empty() ? "" : ", ", kind.name,
		                     kind.argument ? fmt::format("={}", kind.argument) : "");
	return forms;
}

Result<std::vector<ContextChoice>> parseContexts(const std::vector<std::string>& words)
{
	std::vector<ContextChoice> choices;
	for (const std::string& word : words)
	{
		Result<ContextChoice> choice = parseContext(word);
		if (!choice)
			return choice.error();
		choices.push_back(std::move(*choice));
	}
	return choices;
}

bool namesPatch(const std::vector<ContextChoice>& choices)
{
	return std::ranges::any_of(choices, [](const ContextChoice& c) { return c.kind->mesh == patch; });
}

} // namespace vp::app
