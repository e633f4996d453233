#include "view/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>
#include <string_view>

namespace vp::view
{

namespace
{

constexpr std::string_view kPatch = "patch=";

bool namesGridIndex(const std::string& text)
{
	return text.size() > 1 && text[1] == '=' && text[0] >= 'i' && text[0] <= 'k';
}

} // namespace

Error noneOf(const std::vector<std::string>& words)
{
	const auto last = words.end() - 1;
	return {ErrorKind::usage, fmt::format("takes {} or {}", fmt::join(words.begin(), last, ", "), *last)};
}

Result<Vec3> parseDirection(std::string_view text)
{
	const bool is_opposite = text.starts_with('-');
	for (int axis = 0; axis < 3; ++axis)
		if (const std::string_view name = text.substr(is_opposite ? 1 : 0); name.size() == 1 && name[0] == 'x' + axis)
		{
			Vec3 direction(0.0);
			direction[axis] = is_opposite ? -1.0 : 1.0;
			return direction;
		}
	std::istringstream words{std::string(text)};
	Vec3 direction;
	std::string rest;
	if (!(words >> direction.x >> direction.y >> direction.z) || words >> rest)
		return Error{ErrorKind::usage, "takes x, y, z, -x, -y, -z or three numbers"};
	if (direction == Vec3(0.0))
		return Error{ErrorKind::usage,
		             "a zero vector is no direction; give x, y, z or three numbers that are not all zero"};
	return direction;
}

std::string directionText(const Vec3& direction)
{
	return fmt::format("{} {} {}", direction.x, direction.y, direction.z);
}

Result<SurfaceSpec> parseSurface(const std::string& text)
{
	if (text.starts_with(kPatch))
		return SurfaceSpec(find::PatchName{text.substr(kPatch.size())});
	if (namesGridIndex(text))
	{
		Result<surface::GridIndexRange> range = surface::parseGridIndex(text);
		return range ? Result<SurfaceSpec>(SurfaceSpec(*range)) : range.error();
	}
	Result<surface::ImplicitSurface> surface = surface::ImplicitSurface::parse(text);
	return surface ? Result<SurfaceSpec>(SurfaceSpec(std::move(*surface))) : surface.error();
}

std::string surfaceText(const SurfaceSpec& surface)
{
	if (const auto* implicit = implicitSurface(surface))
		return implicit->text();
	if (const auto* range = std::get_if<surface::GridIndexRange>(&surface))
		return range->text();
	if (const auto* patch = std::get_if<find::PatchName>(&surface))
		return std::string(kPatch) + patch->name;
	return {};
}

Result<PictureSize> parseSize(std::string_view text)
{
	const auto size = render::parseSize(text);
	if (!size)
		return size.error();
	return PictureSize{size->first, size->second};
}

std::string sizeText(const PictureSize& size)
{
	return fmt::format("{}x{}", size.width, size.height);
}

std::optional<std::string> textSizeText(double size)
{
	return size > 0.0 ? std::optional(fmt::format("{}", size)) : std::nullopt;
}

bool replacesSheets(const SurfaceSpec& surface)
{
	return std::holds_alternative<surface::GridIndexRange>(surface) || std::holds_alternative<find::PatchName>(surface);
}

const surface::ImplicitSurface* implicitSurface(const SurfaceSpec& surface)
{
	return std::get_if<surface::ImplicitSurface>(&surface);
}

} // namespace vp::view
