#include "npy_header.h"

#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

namespace vp::reader::volumes
{

using grid::NumberType;

namespace
{

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::uint32_t kMaxComponents = 64;
constexpr std::uint32_t kMaxSide = 1u << 30;

// Returns the text behind 'key': in the header's dictionary, to its end.
std::string_view valueOf(std::string_view header, std::string_view key)
{
	const auto at = header.find(fmt::format("'{}'", key));
	const auto colon = at == header.npos ? at : header.find(':', at);
	if (colon == header.npos)
		throw damaged(fmt::format("its header has no {}", key));
	header.remove_prefix(std::min(header.find_first_not_of(' ', colon + 1), header.size()));
	return header;
}

NumberType typeOf(std::string_view description)
{
	constexpr std::string_view names[] = {"i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"};
	if (description == "b1")
		return NumberType::uint8;
	const auto found = std::ranges::find(names, description);
	if (found == std::end(names))
		throw UnreadNpyType(fmt::format("an array of type {}, which is not read; convert it with astype('float32')",
		                                description.substr(0, 8)));
	return static_cast<NumberType>(found - std::begin(names));
}

std::vector<std::uint32_t> shapeOf(std::string_view text)
{
	std::vector<std::uint32_t> shape;
	const auto close = text.find(')');
	if (!text.starts_with('(') || close == text.npos)
		throw damaged("its header has no shape");
	text = text.substr(1, close - 1);
	while (!text.empty())
	{
		if (text[0] == ' ' || text[0] == ',')
		{
			text.remove_prefix(1);
			continue;
		}
		const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), shape.emplace_back());
		if (error != std::errc() || shape.back() > kMaxSide)
			throw damaged("its shape cannot be");
		text.remove_prefix(static_cast<std::size_t>(end - text.data()));
	}
	return shape;
}

} // namespace

std::optional<NpyArray> parseNpy(std::string_view file, bool takes_pictures)
{
	if (!file.starts_with(kMagic) || file.size() < 12)
		throw damaged("its first bytes are not those of a NumPy array");
	const std::size_t length_bytes = file[6] == 1 ? 2 : 4;
	const std::size_t start = 8 + length_bytes;
	const std::uint64_t length = integerAt(file.data() + 8, length_bytes);
	if (length > file.size() - start)
		throw damaged("its header runs past its end");
	const std::string_view header = file.substr(start, length);
	const std::string_view description = valueOf(header, "descr");
	if (description.size() < 5 || description[0] != '\'')
		throw UnreadNpyType("an array of records, which is not read; save one field of it");
	const auto close = description.find('\'', 1);
	std::vector<std::uint32_t> shape = shapeOf(valueOf(header, "shape"));
	if (!valueOf(header, "fortran_order").starts_with("True"))
		std::reverse(shape.begin(), shape.end());

	NpyArray array;
	array.values = file.substr(start + length);
	array.layout.type = typeOf(description.substr(2, close == description.npos ? close : close - 2));
	array.layout.is_big_endian = description[1] == '>';
	if (takes_pictures && shape.size() == 2)
		shape.push_back(1);
	if (shape.size() == 4)
	{
		array.layout.components = shape[0];
		shape.erase(shape.begin());
		if (array.layout.components < 1 || array.layout.components > kMaxComponents)
			throw Refusal(fmt::format("an array of {} components; save fewer, or one volume", array.layout.components));
	}
	if (shape.size() != 3)
		return std::nullopt;
	std::copy(shape.begin(), shape.end(), array.layout.points.begin());
	return array;
}

} // namespace vp::reader::volumes
