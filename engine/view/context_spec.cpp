#include "view/context_spec.h"

#include "surface/grid_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace vp::view
{

namespace
{

// Faint: what is within is to be seen, and a boundary is looked through at least twice.
constexpr double kBoundaryOpacity = 0.15;

// A part of what is seen through, so it may be seen better.
constexpr double kPartOpacity = 0.3;

struct KindWords
{
	ContextKind kind;
	std::string_view name;
	const char* argument; // what stands behind = in the help, as "N"; null: takes none
	double opacity;
};

constexpr std::array kKinds{
    KindWords{ContextKind::boundary, "boundary", nullptr, kBoundaryOpacity},
    KindWords{ContextKind::i, "i", "N", kPartOpacity},
    KindWords{ContextKind::j, "j", "N", kPartOpacity},
    KindWords{ContextKind::k, "k", "N", kPartOpacity},
    KindWords{ContextKind::patch, "patch", "NAME", kPartOpacity},
};

const KindWords& wordsOf(ContextKind kind)
{
	return kKinds[static_cast<std::size_t>(kind)];
}

Error refused(const std::string& why)
{
	return {ErrorKind::usage, why};
}

std::optional<double> number(std::string_view text)
{
	double value = 0.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
	if (error != std::errc() || end != text.data() + text.size())
		return std::nullopt;
	return value;
}

// `what` is KIND[=ARGUMENT].
Result<ContextSpec> choose(std::string_view what)
{
	const std::size_t equals = what.find('=');
	const std::string_view name = what.substr(0, equals);
	const auto* kind = std::ranges::find(kKinds, name, &KindWords::name);
	if (kind == kKinds.end())
		return refused(fmt::format("there is no such context; take {}", contextForms()));
	const std::string_view argument = equals == what.npos ? std::string_view() : what.substr(equals + 1);
	if (!kind->argument && equals != what.npos)
		return refused(fmt::format("{} takes nothing behind =; leave it out", name));
	if (kind->argument && argument.empty())
		return refused(fmt::format("{} needs to know which; write {}={}", name, name, kind->argument));
	if (kind->kind == ContextKind::i || kind->kind == ContextKind::j || kind->kind == ContextKind::k)
	{
		const Result<surface::GridIndexRange> range = surface::parseGridIndex(std::string(what));
		if (!range)
			return refused(range.error().message);
		if (!range->isOne())
			return refused("stands still; give one index");
	}
	return ContextSpec{kind->kind, std::string(argument), kind->opacity};
}

} // namespace

ContextSpec contextOf(ContextKind kind)
{
	return {kind, {}, wordsOf(kind).opacity};
}

std::string contextForms()
{
	std::string forms;
	for (const KindWords& kind : kKinds)
		forms += fmt::format("{}{}{}[:OPACITY]", forms.empty() ? "" : ", ", kind.name,
		                     kind.argument ? fmt::format("={}", kind.argument) : "");
	return forms;
}

Result<ContextSpec> parseContext(std::string_view text)
{
	const std::size_t colon = text.rfind(':');
	const std::optional<double> opacity = colon == text.npos ? std::nullopt : number(text.substr(colon + 1));
	if (!opacity)
		return choose(text);
	Result<ContextSpec> context = choose(text.substr(0, colon));
	if (!context)
		return context;
	context->opacity = *opacity;
	if (!(context->opacity >= 0.0 && context->opacity <= 1.0))
		return refused("an opacity is a number from 0 to 1");
	return context;
}

std::string contextText(const ContextSpec& context)
{
	std::string text(wordsOf(context.kind).name);
	if (!context.argument.empty())
		text += "=" + context.argument;
	// A name may end in a colon and a number, so that its opacity has to be told.
	if (context.opacity != wordsOf(context.kind).opacity || context.argument.find(':') != context.argument.npos)
		text += fmt::format(":{}", context.opacity);
	return text;
}

} // namespace vp::view
