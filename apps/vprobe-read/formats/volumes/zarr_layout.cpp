#include "zarr_layout.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/json_text.h"
#include "zarr_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

using Sides = std::vector<std::size_t>;

constexpr std::size_t kMaxBytesOfChunk = std::size_t(1) << 40;

std::uint16_t halfOf(double number)
{
	const std::uint16_t sign = std::signbit(number) ? 0x8000 : 0;
	if (std::isnan(number))
		return 0x7E00;
	if (number == 0.0)
		return sign;
	if (std::abs(number) >= 65520.0)
		return static_cast<std::uint16_t>(sign | 0x7C00);
	int exponent = 0;
	std::frexp(number, &exponent);
	const int shift = std::max(exponent - 11, -24);
	const auto digits = static_cast<std::uint16_t>(std::nearbyint(std::ldexp(std::abs(number), -shift)));
	return static_cast<std::uint16_t>(sign + std::max(0, shift + 24) * 1024 + digits);
}

// "0x7fc00000" gives the bits.
std::optional<std::uint64_t> bitsIn(const std::string& text)
{
	std::uint64_t bits = 0;
	if (!text.starts_with("0x"))
		return std::nullopt;
	const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), bits, 16);
	return error == std::errc() && end == text.data() + text.size() ? std::optional(bits) : std::nullopt;
}

std::uint64_t bitsOfReal(const json& given, const ZarrType& type, const std::string& name)
{
	const std::string text = given.is_string() ? given.get<std::string>() : std::string();
	const double number = text == "NaN"         ? std::numeric_limits<double>::quiet_NaN()
	                      : text == "Infinity"  ? std::numeric_limits<double>::infinity()
	                      : text == "-Infinity" ? -std::numeric_limits<double>::infinity()
	                      : given.is_number()   ? given.get<double>()
	                                            : 0.0;
	if (given.is_string() && std::isfinite(number))
	{
		const auto written = bitsIn(text);
		if (!written)
			throw Refusal(
			    fmt::format("the fill_value {} of {} is not understood; write a number", text.substr(0, 40), name));
		return *written;
	}
	return type.width == 2   ? halfOf(number)
	       : type.width == 4 ? std::bit_cast<std::uint32_t>(static_cast<float>(number))
	                         : std::bit_cast<std::uint64_t>(number);
}

std::optional<std::vector<std::byte>> fillOf(const json& given, const ZarrType& type, const std::string& name)
{
	if (type.kind == 0 || given.is_null())
		return std::nullopt;
	std::uint64_t bits = 0;
	if (type.kind == 'f')
		bits = bitsOfReal(given, type, name);
	else if (given.is_boolean())
		bits = given.get<bool>() ? 1 : 0;
	else if (given.is_number_unsigned())
		bits = given.get<std::uint64_t>();
	else if (given.is_number())
		bits = static_cast<std::uint64_t>(given.is_number_integer() ? given.get<std::int64_t>()
		                                                            : std::llround(given.get<double>()));
	else
		throw notFollowedZarr(name);
	std::vector<std::byte> bytes(sizeof(bits));
	std::memcpy(bytes.data(), &bits, sizeof(bits));
	bytes.resize(type.width);
	if (type.is_big_endian)
		std::ranges::reverse(bytes);
	return bytes;
}

ZarrLayout layoutOf2(const json& about, const std::string& name)
{
	ZarrLayout layout;
	layout.shape = zarrSides(about.value("shape", json()), name);
	layout.file = layout.chunk = zarrSides(about.value("chunks", json()), name);
	layout.type = ZarrType::of(about.value("dtype", json()));
	layout.order.resize(layout.shape.size());
	std::iota(layout.order.begin(), layout.order.end(), 0);
	if (about.value("order", json("C")) == "F")
		std::ranges::reverse(layout.order);
	layout.separators = "./"; // not all writers say which
	if (layout.type.kind == 0)
		return layout;
	layout.fill = fillOf(about.value("fill_value", json()), layout.type, name);
	if (const json filters = about.value("filters", json()); filters.is_array())
		layout.codecs = filters;
	if (const json compressor = about.value("compressor", json()); !compressor.is_null())
		layout.codecs.push_back(compressor);
	return layout;
}

// An extension: a name, or an object with a name and its configuration.
struct Named
{
	std::string name;
	json configuration = json::object();

	Named(const json& given, const std::string& array)
	{
		if (given.is_string())
			name = given.get<std::string>();
		else if (given.is_object())
		{
			name = given.value("name", "");
			configuration = given.value("configuration", json::object());
		}
		if (name.empty() || !configuration.is_object())
			throw notFollowedZarr(array);
	}
};

// Whoever does not know an extension must stop, unless it says otherwise.
void refuseUnknown(const json& about, const std::string& name)
{
	for (const auto& [key, value] : about.items())
	{
		const bool is_known =
		    isOneOf(key, {"zarr_format", "node_type", "shape", "data_type", "chunk_grid", "chunk_key_encoding",
		                  "fill_value", "codecs", "attributes", "dimension_names", "consolidated_metadata"});
		const bool is_optional = value.is_object() && value.value("must_understand", json(true)) == false;
		const bool is_empty = key == "storage_transformers" && value.is_array() && value.empty();
		if (!is_known && !is_optional && !is_empty)
			throw Refusal(fmt::format("{} asks for an extension of Zarr that is not read: {}; write it without", name,
			                          key.substr(0, 40)));
	}
}

void takeOrder(ZarrLayout& layout, const Named& codec, const std::string& name)
{
	const Sides order = zarrSides(codec.configuration.value("order", json()), name);
	Sides sorted = order;
	std::ranges::sort(sorted);
	Sides wanted(layout.shape.size());
	std::iota(wanted.begin(), wanted.end(), 0);
	if (sorted != wanted)
		throw notFollowedZarr(name);
	Sides composed; // an earlier one has turned the sides already
	for (const std::size_t side : order)
		composed.push_back(layout.order[side]);
	layout.order = composed;
}

void takeCodecs(ZarrLayout& layout, const json& codecs, const std::string& name);

void takeShards(ZarrLayout& layout, const Named& codec, const std::string& name)
{
	layout.chunk = zarrSides(codec.configuration.value("chunk_shape", json()), name);
	bool divides = layout.chunk.size() == layout.file.size();
	for (std::size_t i = 0; divides && i < layout.chunk.size(); ++i)
		divides = layout.chunk[i] > 0 && layout.file[i] % layout.chunk[i] == 0;
	if (!divides || layout.is_sharded)
		throw notFollowedZarr(name);
	layout.is_sharded = true;
	layout.index_is_first = codec.configuration.value("index_location", "end") == "start";
	const json of_index = codec.configuration.value("index_codecs", json::array());
	if (!of_index.is_array())
		throw notFollowedZarr(name);
	for (const json& one : of_index)
	{
		const Named named(one, name);
		const bool is_plain = named.name == "bytes" && named.configuration.value("endian", "little") == "little";
		if (named.name == "crc32c" && !layout.index_has_checksum)
			layout.index_has_checksum = true;
		else if (!is_plain)
			throw Refusal(fmt::format("the shards of {} have an index packed by {}, which is not read; write it plain",
			                          name, named.name.substr(0, 40)));
	}
	takeCodecs(layout, codec.configuration.value("codecs", json()), name);
}

void takeCodecs(ZarrLayout& layout, const json& codecs, const std::string& name)
{
	if (!codecs.is_array())
		throw notFollowedZarr(name);
	for (std::size_t i = 0; i < codecs.size(); ++i)
	{
		const Named codec(codecs[i], name);
		if (codec.name == "transpose")
			takeOrder(layout, codec, name);
		else if (codec.name == "bytes")
			layout.type.is_big_endian = layout.type.width > 1 && codec.configuration.value("endian", "little") == "big";
		else if (codec.name == "sharding_indexed")
		{
			if (codecs.size() > 1)
				throw Refusal(fmt::format("the shards of {} are packed as a whole; write it with packed chunks", name));
			takeShards(layout, codec, name);
		}
		else
		{
			json step = codec.configuration;
			step["id"] = codec.name.starts_with("numcodecs.") ? codec.name.substr(10) : codec.name;
			layout.codecs.push_back(step);
		}
	}
}

ZarrLayout layoutOf3(const json& about, const std::string& name)
{
	refuseUnknown(about, name);
	ZarrLayout layout;
	layout.shape = zarrSides(about.value("shape", json()), name);
	layout.order.resize(layout.shape.size());
	std::iota(layout.order.begin(), layout.order.end(), 0);
	const Named grid(about.value("chunk_grid", json()), name);
	if (grid.name != "regular")
		throw Refusal(fmt::format("the chunks of {} differ in size, which is not read; write it with chunks of one "
		                          "size",
		                          name));
	layout.file = layout.chunk = zarrSides(grid.configuration.value("chunk_shape", json()), name);
	const Named keys(about.value("chunk_key_encoding", json("default")), name);
	const bool is_default = keys.name == "default";
	if (!is_default && keys.name != "v2")
		throw notFollowedZarr(name);
	layout.key_front = is_default ? "c" : "";
	layout.separators = keys.configuration.value("separator", is_default ? "/" : ".");
	if (!isOneOf(layout.separators, {".", "/"}))
		throw notFollowedZarr(name);
	const json type = about.value("data_type", json());
	layout.type = zarrTypeNamed(type.is_string() ? type.get<std::string>() : std::string());
	if (layout.type.kind == 0)
		return layout;
	takeCodecs(layout, about.value("codecs", json()), name);
	layout.fill = fillOf(about.value("fill_value", json()), layout.type, name);
	return layout;
}

} // namespace

json zarrJson(const std::filesystem::path& file)
{
	const MappedText mapped(file.string());
	std::string text;
	bool is_quoted = false;
	const std::string_view given = mapped.text();
	for (std::size_t at = 0; at < given.size();)
	{
		const std::string_view rest = given.substr(at);
		std::size_t bare = 0;
		for (const std::string_view word : {"NaN", "Infinity", "-Infinity"})
			bare = !is_quoted && rest.starts_with(word) ? word.size() : bare;
		if (bare > 0)
			text.append("\"").append(rest.substr(0, bare)).append("\"");
		else if (is_quoted && rest[0] == '\\' && rest.size() > 1)
			text.append(rest.substr(0, bare = 2));
		else
		{
			is_quoted ^= rest[0] == '"';
			text.append(rest.substr(0, bare = 1));
		}
		at += bare;
	}
	const json parsed = text::parseJson(text);
	if (!parsed.is_object())
		throw damaged(fmt::format("{} is no JSON", (file.parent_path().filename() / file.filename()).string()));
	return parsed;
}

ZarrLayout ZarrLayout::of(const json& about, const std::string& name)
{
	const json version = about.value("zarr_format", json(2));
	if (version != 2 && version != 3)
		throw Refusal(fmt::format("{} has Zarr's format {}; write it as version 2 or 3", name, version.dump()));
	ZarrLayout layout = isOfN5(about)  ? layoutOfN5(about, name)
	                    : version == 2 ? layoutOf2(about, name)
	                                   : layoutOf3(about, name);
	layout.keys.resize(layout.shape.size());
	std::iota(layout.keys.begin(), layout.keys.end(), 0);
	if (layout.shape.size() != layout.file.size())
		throw notFollowedZarr(name);
	std::size_t bytes = layout.type.width;
	for (const std::size_t side : layout.file)
		if (side == 0 || __builtin_mul_overflow(bytes, side, &bytes) || bytes > kMaxBytesOfChunk)
			throw damaged(fmt::format("{} has chunks of a size that cannot be", name));
	return layout;
}

void ZarrLayout::turn(const Sides& order_of_sides)
{
	const auto turned = [&](const Sides& given)
	{
		Sides sides;
		for (const std::size_t side : order_of_sides)
			sides.push_back(given[side]);
		return sides;
	};
	shape = turned(shape);
	chunk = turned(chunk);
	file = turned(file);
	Sides place(order_of_sides.size());
	for (std::size_t i = 0; i < place.size(); ++i)
		place[order_of_sides[i]] = i;
	for (Sides* sides : {&order, &keys})
		for (std::size_t& side : *sides)
			side = place[side];
}

std::vector<std::string> ZarrLayout::namesOfFile(const Sides& indices) const
{
	std::vector<std::string> names;
	for (const char separator : separators)
	{
		std::string name = key_front;
		for (const std::size_t side : keys)
			name += name.empty() ? fmt::format("{}", indices[side]) : fmt::format("{}{}", separator, indices[side]);
		names.push_back(name.empty() ? "0" : name);
	}
	return names;
}

std::optional<Sides> ZarrLayout::indicesOf(std::string name) const
{
	if (shape.empty())
		return name == namesOfFile({})[0] ? std::optional(Sides()) : std::nullopt;
	if (!key_front.empty())
	{
		if (!name.starts_with(key_front + separators))
			return std::nullopt;
		name.erase(0, key_front.size() + 1);
	}
	Sides indices;
	for (std::size_t at = 0; at <= name.size();)
	{
		const std::size_t end = std::min(name.find_first_of(separators, at), name.size());
		const auto [stop, error] = std::from_chars(name.data() + at, name.data() + end, indices.emplace_back());
		if (error != std::errc() || stop != name.data() + end || indices.size() > kMaxSidesOfZarr)
			return std::nullopt;
		at = end + 1;
	}
	if (indices.size() != keys.size())
		return indices;
	Sides turned(indices.size());
	for (std::size_t i = 0; i < keys.size(); ++i)
		turned[keys[i]] = indices[i];
	return turned;
}

} // namespace vp::reader::volumes
