#include "zarr_array.h"

#include "parts/part_bytes.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/bytes_read.h"
#include "vprobe-read/base/half_float.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

namespace fs = std::filesystem;

using Sides = std::vector<std::size_t>;

constexpr std::size_t kMaxSides = 32; // as many as NumPy has
constexpr std::size_t kMaxBytesOfChunk = std::size_t(1) << 40;

Refusal notFollowed(const std::string& name)
{
	return damaged(fmt::format("the .zarray of {} cannot be followed", name));
}

Sides sidesIn(const json& given, const std::string& name)
{
	Sides sides;
	if (!given.is_array() || given.size() > kMaxSides)
		throw notFollowed(name);
	for (const json& side : given)
	{
		if (!side.is_number_integer() || side < 0 || side > std::int64_t(1) << 40)
			throw notFollowed(name);
		sides.push_back(side.get<std::size_t>());
	}
	return sides;
}

// The numbers in "0.3.1", and in "0/3/1" as it lies in folders. Nothing for other names.
std::optional<Sides> indicesIn(const std::string& key)
{
	Sides indices;
	for (std::size_t at = 0; at <= key.size();)
	{
		const std::size_t end = std::min(key.find_first_of("./", at), key.size());
		const auto [stop, error] = std::from_chars(key.data() + at, key.data() + end, indices.emplace_back());
		if (error != std::errc() || stop != key.data() + end || indices.size() > kMaxSides)
			return std::nullopt;
		at = end + 1;
	}
	return indices;
}

template <std::size_t Width>
void copyRow(const std::byte* from, std::size_t stride, std::byte* to, std::size_t count)
{
	for (std::size_t i = 0; i < count; ++i)
		std::memcpy(to + i * Width, from + i * stride * Width, Width);
}

void copyRow(std::size_t width, const std::byte* from, std::size_t stride, std::byte* to, std::size_t count)
{
	switch (width)
	{
	case 1:
		return copyRow<1>(from, stride, to, count);
	case 2:
		return copyRow<2>(from, stride, to, count);
	case 4:
		return copyRow<4>(from, stride, to, count);
	default:
		return copyRow<8>(from, stride, to, count);
	}
}

// How many values lie between neighbors along each side.
Sides stridesOf(const Sides& sides, bool is_fortran)
{
	Sides strides(sides.size());
	std::size_t step = 1;
	for (std::size_t i = 0; i < sides.size(); ++i)
	{
		const std::size_t side = is_fortran ? i : sides.size() - 1 - i;
		strides[side] = step;
		step *= sides[side];
	}
	return strides;
}

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

template <class Number>
std::vector<std::byte> bytesOf(Number number)
{
	std::vector<std::byte> bytes(sizeof(Number));
	std::memcpy(bytes.data(), &number, sizeof(Number));
	return bytes;
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

} // namespace

json zarrJson(const fs::path& file)
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

ZarrArray::ZarrArray(fs::path folder, std::string name, const json& about)
    : folder_(std::move(folder)), name_(std::move(name)), shape_(sidesIn(about.value("shape", json()), name_)),
      chunk_(sidesIn(about.value("chunks", json()), name_)), type_(ZarrType::of(about.value("dtype", json()))),
      is_fortran_(about.value("order", json("C")) == "F"), codecs_(type_.kind == 0 ? json::object() : about, name_)
{
	if (shape_.size() != chunk_.size() || about.value("zarr_format", json(2)) != 2)
		throw notFollowed(name_);
	chunk_bytes_ = type_.width;
	for (const std::size_t side : chunk_)
		if (side == 0 || __builtin_mul_overflow(chunk_bytes_, side, &chunk_bytes_) || chunk_bytes_ > kMaxBytesOfChunk)
			throw damaged(fmt::format("{} has chunks of a size that cannot be", name_));
	takeFill(about.value("fill_value", json()));
}

void ZarrArray::takeFill(const json& given)
{
	if (type_.kind == 0 || given.is_null())
		return;
	const std::string text = given.is_string() ? given.get<std::string>() : std::string();
	std::uint64_t bits = 0;
	if (type_.kind == 'f')
	{
		const double number = text == "NaN"         ? std::numeric_limits<double>::quiet_NaN()
		                      : text == "Infinity"  ? std::numeric_limits<double>::infinity()
		                      : text == "-Infinity" ? -std::numeric_limits<double>::infinity()
		                      : given.is_number()   ? given.get<double>()
		                                            : 0.0;
		bits = type_.width == 2   ? halfOf(number)
		       : type_.width == 4 ? std::bit_cast<std::uint32_t>(static_cast<float>(number))
		                          : std::bit_cast<std::uint64_t>(number);
		if (given.is_string() && std::isfinite(number))
		{
			const auto written = bitsIn(text);
			if (!written)
				throw Refusal(fmt::format("the fill_value {} of {} is not understood; write a number",
				                          text.substr(0, 40), name_));
			bits = *written;
		}
	}
	else if (given.is_boolean())
		bits = given.get<bool>() ? 1 : 0;
	else if (given.is_number_unsigned())
		bits = given.get<std::uint64_t>();
	else if (given.is_number())
		bits = static_cast<std::uint64_t>(given.is_number_integer() ? given.get<std::int64_t>()
		                                                            : std::llround(given.get<double>()));
	else
		throw notFollowed(name_);
	std::vector<std::byte> bytes = bytesOf(bits);
	bytes.resize(type_.width);
	if (type_.is_big_endian)
		std::ranges::reverse(bytes);
	fill_ = std::move(bytes);
}

// The chunks of a part that few of them cover, by their names. Nothing for others.
std::optional<std::vector<ZarrArray::Chunk>> ZarrArray::fewChunksIn(const Sides& starts, const Sides& counts) const
{
	constexpr std::size_t kFew = 16;
	Sides first(shape_.size());
	Sides count(shape_.size());
	std::size_t all = 1;
	for (std::size_t i = 0; i < shape_.size(); ++i)
	{
		if (counts[i] == 0)
			return std::nullopt;
		first[i] = starts[i] / chunk_[i];
		count[i] = (starts[i] + counts[i] - 1) / chunk_[i] - first[i] + 1;
		if (__builtin_mul_overflow(all, count[i], &all) || all > kFew)
			return std::nullopt;
	}
	std::vector<Chunk> chunks;
	for (std::size_t number = 0; number < all && !shape_.empty(); ++number)
	{
		Sides begin(shape_.size());
		std::string key;
		std::size_t rest = number;
		for (std::size_t i = 0; i < shape_.size(); ++i)
		{
			const std::size_t index = first[i] + rest % count[i];
			rest /= count[i];
			begin[i] = index * chunk_[i];
			key += fmt::format("{}{}", i ? "." : "", index);
		}
		std::string in_folders = key;
		std::ranges::replace(in_folders, '.', '/');
		for (const std::string& name : {key, in_folders})
			if (std::error_code ignored; fs::is_regular_file(folder_ / name, ignored))
			{
				chunks.push_back({folder_ / name, begin});
				break;
			}
	}
	return shape_.empty() ? std::nullopt : std::optional(std::move(chunks));
}

// Not over all chunks that there may be: a text can name far more of them than there are files.
std::vector<ZarrArray::Chunk> ZarrArray::chunksIn(const Sides& starts, const Sides& counts) const
{
	if (auto few = fewChunksIn(starts, counts))
		return std::move(*few);
	std::vector<Chunk> chunks;
	for (auto entry = fs::recursive_directory_iterator(folder_); entry != fs::recursive_directory_iterator(); ++entry)
	{
		const std::string key = entry->path().lexically_relative(folder_).generic_string();
		auto indices = indicesIn(key);
		if (entry->is_directory() && (!indices || indices->size() >= shape_.size()))
			entry.disable_recursion_pending();
		if (!indices || !entry->is_regular_file())
			continue;
		if (shape_.empty() && indices->size() == 1)
			indices->clear();
		bool is_wanted = indices->size() == shape_.size();
		for (std::size_t i = 0; is_wanted && i < shape_.size(); ++i)
		{
			std::size_t& begin = (*indices)[i];
			is_wanted = begin <= shape_[i] / chunk_[i]; // others were left when it was made smaller
			begin *= is_wanted ? chunk_[i] : 0;
			is_wanted = is_wanted && begin < starts[i] + counts[i] && begin + chunk_[i] > starts[i];
		}
		if (is_wanted)
			chunks.push_back({entry->path(), std::move(*indices)});
	}
	return chunks;
}

std::vector<std::byte> ZarrArray::unpacked(const Chunk& chunk) const
{
	const MappedText file(chunk.file.string());
	countMapped(file.text().size());
	const std::string where =
	    fmt::format("chunk {} of {}", chunk.file.lexically_relative(folder_).generic_string(), name_);
	return codecs_.unpack(std::as_bytes(std::span(file.text())), chunk_bytes_, where);
}

// Returns how many values were wanted of the chunk.
std::size_t ZarrArray::copy(const Chunk& chunk, const Sides& starts, const Sides& counts, std::byte* to) const
{
	const std::vector<std::byte> from = unpacked(chunk);
	const std::size_t sides = shape_.size();
	if (sides == 0)
	{
		std::memcpy(to, from.data(), type_.width);
		return 1;
	}
	const Sides from_strides = stridesOf(chunk_, is_fortran_), to_strides = stridesOf(counts, false);
	Sides first(sides), count(sides), at(sides, 0);
	std::size_t from_first = 0, to_first = 0, rows = 1;
	for (std::size_t i = 0; i < sides; ++i)
	{
		first[i] = std::max(chunk.begin[i], starts[i]);
		count[i] = std::min({chunk.begin[i] + chunk_[i], starts[i] + counts[i], shape_[i]}) - first[i];
		from_first += (first[i] - chunk.begin[i]) * from_strides[i];
		to_first += (first[i] - starts[i]) * to_strides[i];
		rows *= i + 1 < sides ? count[i] : 1;
	}
	for (std::size_t row = 0; row < rows; ++row)
	{
		std::size_t from_at = from_first, to_at = to_first;
		for (std::size_t i = 0; i + 1 < sides; ++i)
		{
			from_at += at[i] * from_strides[i];
			to_at += at[i] * to_strides[i];
		}
		copyRow(type_.width, from.data() + from_at * type_.width, from_strides.back(), to + to_at * type_.width,
		        count.back());
		for (std::size_t i = sides - 1; i-- > 0;)
		{
			if (++at[i] < count[i])
				break;
			at[i] = 0;
		}
	}
	return rows * count.back();
}

void ZarrArray::read(const Sides& starts, const Sides& counts, std::byte* given) const
{
	std::size_t values = 1;
	for (const std::size_t count : counts)
		values *= count;
	std::vector<std::byte> halves(isHalf() ? 2 * values : 0);
	std::byte* to = isHalf() ? halves.data() : given;
	const std::vector<std::byte> filling = fill_.value_or(std::vector<std::byte>(type_.width, std::byte(0xFF))); // NaN
	parts::fillItems({to, values * type_.width}, filling);
	std::size_t written = 0;
	if (values > 0)
		for (const Chunk& chunk : chunksIn(starts, counts))
			written += copy(chunk, starts, counts, to);
	if (written < values && !fill_ && type_.kind != 'f')
		throw damaged(fmt::format("chunks of {} are missing, and it has no fill_value", name_));
	if (type_.is_big_endian)
		parts::swapNumbers({to, values * type_.width}, type_.width);
	for (std::size_t i = 0; isHalf() && i < values; ++i)
	{
		putNumber(fromHalf(numberAt<std::uint16_t>(halves.data() + 2 * i)), given + 4 * i);
	}
}

} // namespace vp::reader::volumes
