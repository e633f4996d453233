#pragma once

#include "base/result.h"
#include "base/vec.h"
#include "grid/field.h"

#include <array>
#include <cstdint>
#include <string>

namespace vp::read
{

// How the values of a raw volume lie in its file, which does not say it: x runs fastest. What precedes them is skipped,
// since they end with the file.
struct RawLayout
{
	std::array<std::uint32_t, 3> size{0, 0, 0}; // zeros if there is no layout
	grid::NumberType type = grid::NumberType::uint8;
	Vec3 spacing{1.0, 1.0, 1.0};
	bool is_big_endian = false;

	bool operator==(const RawLayout&) const = default;
};

// Each reads what the other writes. Errors are usage errors that do not name the setting.
Result<std::array<std::uint32_t, 3>> parseRawSize(const std::string& text); // 256x256x128
std::string rawSizeText(const std::array<std::uint32_t, 3>& size);          // empty if there is none
Result<grid::NumberType> parseRawType(const std::string& text);             // uint16
std::string rawTypeText(grid::NumberType type);
Result<Vec3> parseRawSpacing(const std::string& text); // 0.5x0.5x2
std::string rawSpacingText(const Vec3& spacing);
Result<bool> parseRawOrder(const std::string& text); // little or big; whether it is big
std::string rawOrderText(bool is_big_endian);

// All of it in one text; empty if there is no size.
Result<RawLayout> parseRaw(const std::string& text);
std::string rawText(const RawLayout& layout);

} // namespace vp::read
