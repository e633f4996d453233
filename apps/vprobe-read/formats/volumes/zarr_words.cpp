#include "zarr_words.h"

#include <fmt/format.h>

#include <string_view>

namespace vp::reader::volumes
{

using nlohmann::json;

Refusal notFollowedZarr(const std::string& name)
{
	return damaged(fmt::format("the JSON of {} cannot be followed", name));
}

std::vector<std::size_t> zarrSides(const json& given, const std::string& name)
{
	std::vector<std::size_t> sides;
	if (!given.is_array() || given.size() > kMaxSidesOfZarr)
		throw notFollowedZarr(name);
	for (const json& side : given)
	{
		if (!side.is_number_integer() || side < 0 || side > std::int64_t(1) << 40)
			throw notFollowedZarr(name);
		sides.push_back(side.get<std::size_t>());
	}
	return sides;
}

ZarrType zarrTypeNamed(const std::string& name)
{
	if (name == "bool")
		return {'b', 1, false};
	for (const std::string_view kind : {"int", "uint", "float"})
		for (const std::size_t width : {1, 2, 4, 8})
			if (name == fmt::format("{}{}", kind, 8 * width) && (kind != "float" || width > 1))
				return {kind[0], width, false};
	return {};
}

} // namespace vp::reader::volumes
