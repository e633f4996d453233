#include "read/raw_layout.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>

namespace vp::read
{

namespace
{

constexpr std::uint32_t kMaxSide = 1u << 20;

// Three numbers with an x between them.
template <class Number>
std::optional<std::array<Number, 3>> threeNumbers(std::string_view text)
{
	std::array<Number, 3> numbers;
	const char* at = text.data();
	const char* end = at + text.size();
	for (std::size_t i = 0; i < 3; ++i)
	{
		if (i > 0 && (at == end || *at++ != 'x'))
			return std::nullopt;
		const auto [next, error] = std::from_chars(at, end, numbers[i]);
		if (error != std::errc())
			return std::nullopt;
		at = next;
	}
	return at == end ? std::optional(numbers) : std::nullopt;
}

} // namespace

Result<std::array<std::uint32_t, 3>> parseRawSize(const std::string& text)
{
	const auto size = threeNumbers<std::uint32_t>(text);
	if (!size)
		return Error{ErrorKind::usage, "not three numbers of values, as in 256x256x128"};
	for (const std::uint32_t side : *size)
		if (side < 2 || side > kMaxSide)
			return Error{ErrorKind::usage, fmt::format("each side has 2 to {} values", kMaxSide)};
	return *size;
}

std::string rawSizeText(const std::array<std::uint32_t, 3>& size)
{
	return size[0] == 0 ? std::string() : fmt::format("{}x{}x{}", size[0], size[1], size[2]);
}

Result<grid::NumberType> parseRawType(const std::string& text)
{
	for (int t = 0; t <= static_cast<int>(grid::NumberType::float64); ++t)
		if (text == grid::numberTypeName(static_cast<grid::NumberType>(t)))
			return static_cast<grid::NumberType>(t);
	return Error{ErrorKind::usage, "not one of int8 uint8 int16 uint16 int32 uint32 int64 uint64 float32 float64"};
}

std::string rawTypeText(grid::NumberType type)
{
	return grid::numberTypeName(type);
}

Result<Vec3> parseRawSpacing(const std::string& text)
{
	const auto numbers = threeNumbers<double>(text);
	if (!numbers)
		return Error{ErrorKind::usage, "not three distances, as in 0.5x0.5x2"};
	for (const double number : *numbers)
		if (!(number > 0.0) || !std::isfinite(number))
			return Error{ErrorKind::usage, "distances are finite and greater than 0"};
	return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

std::string rawSpacingText(const Vec3& spacing)
{
	return fmt::format("{}x{}x{}", spacing.x, spacing.y, spacing.z);
}

Result<bool> parseRawOrder(const std::string& text)
{
	if (text != "little" && text != "big")
		return Error{ErrorKind::usage, "neither little nor big"};
	return text == "big";
}

std::string rawOrderText(bool is_big_endian)
{
	return is_big_endian ? "big" : "little";
}

Result<RawLayout> parseRaw(const std::string& text)
{
	RawLayout layout;
	if (text.empty())
		return layout;
	std::istringstream words(text);
	std::string size, type, spacing, order;
	words >> size >> type >> spacing >> order;
	const auto sides = parseRawSize(size);
	const auto number = parseRawType(type);
	const auto distances = parseRawSpacing(spacing);
	const auto big = parseRawOrder(order);
	if (!sides || !number || !distances || !big)
		return Error{ErrorKind::usage, "not the layout of a raw volume"};
	return RawLayout{*sides, *number, *distances, *big};
}

std::string rawText(const RawLayout& layout)
{
	if (layout.size[0] == 0)
		return {};
	return rawSizeText(layout.size) + ' ' + rawTypeText(layout.type) + ' ' + rawSpacingText(layout.spacing) + ' ' +
	       rawOrderText(layout.is_big_endian);
}

} // namespace vp::read
