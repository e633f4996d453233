#include "read/manifest_values.h"

#include "base/ids.h"
#include "read/check_mesh.h"
#include "read/protocol.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vp::read
{

namespace
{

using grid::NumberType;
using nlohmann::json;

constexpr std::size_t kMaxWords = 300;

} // namespace

std::uint64_t countOf(const json& value)
{
	if (!value.is_number_unsigned())
		throw Unusable("a count is not a whole number");
	return value.get<std::uint64_t>();
}

double finiteOf(const json& value)
{
	if (!value.is_number() || !std::isfinite(value.get<double>()))
		throw Unusable("an origin, a spacing or a time is not a finite number");
	return value.get<double>();
}

Vec3 vectorOf(const json& value)
{
	if (!value.is_array() || value.size() != 3)
		throw Unusable("a vector does not have three numbers");
	return {finiteOf(value[0]), finiteOf(value[1]), finiteOf(value[2])};
}

std::string wordsOf(const json& value)
{
	std::string words = value.get<std::string>().substr(0, kMaxWords);
	for (char& c : words)
		if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
			c = ' ';
	return words;
}

NumberType numberTypeOf(const std::string& name)
{
	for (int type = 0; type <= static_cast<int>(NumberType::float64); ++type)
		if (name == grid::numberTypeName(static_cast<NumberType>(type)))
			return static_cast<NumberType>(type);
	throw Unusable("an array has an unknown number type");
}

Array<std::byte> bytesOf(const SharedBytes& memory, const json& array, NumberType type, std::uint64_t numbers)
{
	const std::uint64_t offset = countOf(array.at("offset"));
	const std::uint64_t bytes = countOf(array.at("bytes"));
	if (offset % kArrayAlignment != 0 || offset > memory.bytes.size() || bytes > memory.bytes.size() - offset)
		throw Unusable("an array lies outside what was handed over");
	if (bytes % byteSize(type) != 0 || (numbers != kAnyCount && bytes / byteSize(type) != numbers))
		throw Unusable("an array has another size than it should");
	return {memory.owner, memory.bytes.data() + offset, static_cast<std::size_t>(bytes)};
}

Array<std::byte> bytesOfType(const SharedBytes& memory, const json& array, NumberType type, std::uint64_t numbers)
{
	if (numberTypeOf(array.at("type").get<std::string>()) != type)
		throw Unusable("an array has another number type than it should");
	return bytesOf(memory, array, type, numbers);
}

grid::Points coordinatesOf(const SharedBytes& memory, const json& array, std::uint64_t points)
{
	const std::uint64_t numbers = points == kAnyCount ? kAnyCount : points * 3;
	const bool is_double = array.at("type") == "float64";
	grid::Points checked = is_double ? grid::Points(numbersOf<double>(memory, array, NumberType::float64, numbers))
	                                 : grid::Points(numbersOf<float>(memory, array, NumberType::float32, numbers));
	if (countOf(array.at("bytes")) != checked.size() * 3 * (is_double ? 8 : 4))
		throw Unusable("points without three coordinates");
	if (checked.size() >= kMaxBlockIds)
		throw Unusable(fmt::format("a block of {} points is too large; split it", checked.size()));
	return checked;
}

} // namespace vp::read
