#pragma once

#include "view/view_spec.h"

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::view
{

// How the typed values of a ViewSpec are written in state files, on a command line and in a text field. Each type has
//     Result<T> parse(std::string_view text, T* = nullptr)   a usage error that names neither the setting nor the text
//     std::string text(const T& value)                       read again it is the same value

/// The words of an enumeration: pairs of a value and its word.
template <class Enum>
struct Names;

template <>
struct Names<seed::SeedMode>
{
	static constexpr std::array kWords{std::pair{seed::SeedMode::automatic, "auto"},
	                                   std::pair{seed::SeedMode::hotspot, "hotspot"},
	                                   std::pair{seed::SeedMode::boundary, "boundary"}};
};
template <>
struct Names<seed::OutsidePolicy>
{
	static constexpr std::array kWords{std::pair{seed::OutsidePolicy::nearest, "nearest"},
	                                   std::pair{seed::OutsidePolicy::refuse, "refuse"},
	                                   std::pair{seed::OutsidePolicy::report, "report"}};
};
template <>
struct Names<mesh::Corners>
{
	static constexpr std::array kWords{std::pair{mesh::Corners::keep, "keep"}, std::pair{mesh::Corners::skip, "skip"}};
};
template <>
struct Names<mesh::Hanging>
{
	static constexpr std::array kWords{std::pair{mesh::Hanging::keep, "keep"},
	                                   std::pair{mesh::Hanging::interpolate, "interpolate"}};
};
template <>
struct Names<find::VisitedSet>
{
	static constexpr std::array kWords{std::pair{find::VisitedSet::stamps, "stamps"},
	                                   std::pair{find::VisitedSet::octants, "octants"}};
};
template <>
struct Names<find::Strategy>
{
	static constexpr std::array kWords{
	    std::pair{find::Strategy::rows, "rows"},     std::pair{find::Strategy::spans, "spans"},
	    std::pair{find::Strategy::cells, "cells"},   std::pair{find::Strategy::generations, "generations"},
	    std::pair{find::Strategy::listed, "listed"}, std::pair{find::Strategy::scan, "scan"}};
};
template <>
struct Names<Classify>
{
	static constexpr std::array kWords{std::pair{Classify::automatic, "auto"}, std::pair{Classify::gpu, "gpu"},
	                                   std::pair{Classify::cpu, "cpu"}};
};
template <>
struct Names<ProbeShape> // an own probe has no word
{
	static constexpr std::array kWords{
	    std::pair{ProbeShape::single, "single"}, std::pair{ProbeShape::trihedral, "trihedral"},
	    std::pair{ProbeShape::paddlewheel, "paddlewheel"}, std::pair{ProbeShape::stack, "stack"}};
};
template <>
struct Names<std::optional<TraceKind>>
{
	using Kind = std::optional<TraceKind>;
	static constexpr std::array kWords{std::pair{Kind(), "none"}, std::pair{Kind(TraceKind::tufts), "tufts"},
	                                   std::pair{Kind(TraceKind::lines), "lines"},
	                                   std::pair{Kind(TraceKind::ribbons), "ribbons"},
	                                   std::pair{Kind(TraceKind::tubes), "tubes"}};
};
template <>
struct Names<vectors::Direction>
{
	static constexpr std::array kWords{std::pair{vectors::Direction::forward, "forward"},
	                                   std::pair{vectors::Direction::backward, "backward"},
	                                   std::pair{vectors::Direction::both, "both"}};
};
template <>
struct Names<vectors::VectorPart>
{
	static constexpr std::array kWords{std::pair{vectors::VectorPart::whole, "whole"},
	                                   std::pair{vectors::VectorPart::tangential, "tangential"},
	                                   std::pair{vectors::VectorPart::normal, "normal"}};
};
template <>
struct Names<ColorBy>
{
	static constexpr std::array kWords{std::pair{ColorBy::array, "array"},
	                                   std::pair{ColorBy::generation, "generation"}};
};
template <>
struct Names<Interpolate>
{
	static constexpr std::array kWords{std::pair{Interpolate::automatic, "auto"},
	                                   std::pair{Interpolate::nearest, "nearest"},
	                                   std::pair{Interpolate::linear, "linear"}};
};

template <>
struct Names<RangeOf>
{
	static constexpr std::array kWords{std::pair{RangeOf::automatic, "auto"}, std::pair{RangeOf::data, "data"},
	                                   std::pair{RangeOf::slice, "slice"}, std::pair{RangeOf::times, "times"}};
};
template <>
struct Names<AxesStyle>
{
	static constexpr std::array kWords{std::pair{AxesStyle::corner, "corner"}, std::pair{AxesStyle::box, "box"},
	                                   std::pair{AxesStyle::none, "none"}};
};
template <>
struct Names<read::InputsAs>
{
	static constexpr std::array kWords{
	    std::pair{read::InputsAs::automatic, "auto"}, std::pair{read::InputsAs::blocks, "blocks"},
	    std::pair{read::InputsAs::times, "times"}, std::pair{read::InputsAs::stack, "stack"}};
};
template <>
struct Names<render::Projection>
{
	static constexpr std::array kWords{std::pair{render::Projection::perspective, "perspective"},
	                                   std::pair{render::Projection::parallel, "parallel"}};
};
template <>
struct Names<render::Outline>
{
	static constexpr std::array kWords{std::pair{render::Outline::none, "none"}, std::pair{render::Outline::box, "box"},
	                                   std::pair{render::Outline::edges, "edges"}};
};

template <class T>
concept Named = requires
{
	Names<T>::kWords;
};

template <Named T>
std::vector<std::string> wordsOf()
{
	std::vector<std::string> words;
	for (const auto& [value, word] : Names<T>::kWords)
		words.emplace_back(word);
	return words;
}

template <Named T>
const char* text(const T& value)
{
	for (const auto& [known, word] : Names<T>::kWords)
		if (known == value)
			return word;
	return "";
}

/// Returns a usage error: "takes A, B or C".
Error noneOf(const std::vector<std::string>& words);

template <Named T>
Result<T> parse(std::string_view text, T* = nullptr)
{
	for (const auto& [value, word] : Names<T>::kWords)
		if (text == word)
			return value;
	return noneOf(wordsOf<T>());
}

/// Three numbers that are not all zero, or x, y, z, -x, -y or -z.
Result<Vec3> parseDirection(std::string_view text);
std::string directionText(const Vec3& direction); // three numbers, so that programs can read them

/// A surface other than planes (implicit_surface.h, grid_index.h), or "patch=NAME".
Result<SurfaceSpec> parseSurface(const std::string& text);
std::string surfaceText(const SurfaceSpec& surface); // empty for planes

Result<PictureSize> parseSize(std::string_view text); // WxH
std::string sizeText(const PictureSize& size);

std::optional<std::string> textSizeText(double size); // nothing if the size follows from the picture

} // namespace vp::view
