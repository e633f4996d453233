// The codecs of numcodecs and of Zarr 3, undone.
#include "zarr_codecs.h"

#include "vprobe-read/arrays/chunk_codecs.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>
#include <zstd.h>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

using Bytes = std::span<const std::byte>;

// numcodecs writes the size before the block.
bool unpackSizedLz4(Bytes packed, std::span<std::byte> to)
{
	return packed.size() >= 4 && numberAt<std::uint32_t>(packed.data()) == to.size() &&
	       packed.size() <= LZ4_MAX_INPUT_SIZE &&
	       LZ4_decompress_safe(reinterpret_cast<const char*>(packed.data()) + 4, reinterpret_cast<char*>(to.data()),
	                           static_cast<int>(packed.size() - 4),
	                           static_cast<int>(to.size())) == static_cast<int>(to.size());
}

// As lz4-java's streams have it: blocks, each behind a mark, its kind, the number of its packed bytes, that of its
// bytes, and a checksum, which is not looked at. The last one is empty.
bool unpackJavaLz4(Bytes packed, std::span<std::byte> to)
{
	constexpr std::string_view kMark = "LZ4Block";
	constexpr std::size_t kHead = 21;
	constexpr unsigned kPlain = 0x10, kPacked = 0x20;
	while (!to.empty())
	{
		if (packed.size() < kHead ||
		    !std::equal(kMark.begin(), kMark.end(), reinterpret_cast<const char*>(packed.data())))
			return false;
		const unsigned kind = std::to_integer<unsigned>(packed[kMark.size()]) & 0xF0;
		const std::size_t bytes = numberAt<std::uint32_t>(packed.data() + 9);
		const std::size_t whole = numberAt<std::uint32_t>(packed.data() + 13);
		packed = packed.subspan(kHead);
		if (bytes > packed.size() || whole == 0 || whole > to.size() || std::max(bytes, whole) > LZ4_MAX_INPUT_SIZE)
			return false;
		if (kind == kPlain && bytes == whole)
			std::copy_n(packed.begin(), whole, to.begin());
		else if (kind != kPacked ||
		         LZ4_decompress_safe(reinterpret_cast<const char*>(packed.data()), reinterpret_cast<char*>(to.data()),
		                             static_cast<int>(bytes), static_cast<int>(whole)) != static_cast<int>(whole))
			return false;
		packed = packed.subspan(bytes);
		to = to.subspan(whole);
	}
	return true;
}

bool unpackXz(Bytes packed, std::span<std::byte> to)
{
	std::uint64_t memory = UINT64_MAX; // the process has a limit of its own
	std::size_t read = 0, written = 0;
	return lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(packed.data()), &read,
	                                 packed.size(), reinterpret_cast<std::uint8_t*>(to.data()), &written,
	                                 to.size()) == LZMA_OK &&
	       written == to.size();
}

// The checksum stands before the bytes.
bool checkCrc32(Bytes packed, std::span<std::byte> to)
{
	const Bytes rest = packed.subspan(4);
	std::ranges::copy(rest, to.begin());
	return numberAt<std::uint32_t>(packed.data()) ==
	       crc32_z(0, reinterpret_cast<const Bytef*>(rest.data()), rest.size());
}

// It stands behind them.
bool checkCrc32c(Bytes packed, std::span<std::byte> to)
{
	const Bytes rest = packed.first(packed.size() - 4);
	std::ranges::copy(rest, to.begin());
	return numberAt<std::uint32_t>(packed.data() + rest.size()) == arrays::crc32c(rest);
}

// Calls use(NUMBER) with a value of the type.
template <class Use>
void withNumber(const ZarrType& type, Use&& use)
{
	if (type.kind == 'f')
		return type.width == 4 ? use(float()) : use(double());
	const bool is_signed = type.kind == 'i';
	switch (type.width)
	{
	case 1:
		return is_signed ? use(std::int8_t()) : use(std::uint8_t());
	case 2:
		return is_signed ? use(std::int16_t()) : use(std::uint16_t());
	case 4:
		return is_signed ? use(std::int32_t()) : use(std::uint32_t());
	default:
		return is_signed ? use(std::int64_t()) : use(std::uint64_t());
	}
}

// Whole numbers wrap around, as NumPy's do. A double that none can hold is 0.
template <class Number, class From>
Number turnedInto(From from)
{
	if constexpr (std::is_integral_v<Number> && std::is_floating_point_v<From>)
		return std::abs(from) < 9e18 ? static_cast<Number>(static_cast<std::int64_t>(from)) : Number(0);
	else
		return static_cast<Number>(from);
}

bool computes(const std::string& id)
{
	return isOneOf(id, {"delta", "fixedscaleoffset", "quantize", "astype", "bitround"});
}

} // namespace

ZarrType ZarrType::of(const json& given)
{
	ZarrType type;
	const std::string text = given.is_string() ? given.get<std::string>() : std::string();
	if (text.size() != 3 || !isOneOf(text.substr(0, 1), {"<", ">", "|", "="}))
		return type;
	const std::size_t width = text[2] >= '0' && text[2] <= '9' ? static_cast<std::size_t>(text[2] - '0') : 0;
	const bool is_whole =
	    isOneOf(text.substr(1, 1), {"i", "u"}) && (width == 1 || width == 2 || width == 4 || width == 8);
	const bool is_real = text[1] == 'f' && (width == 2 || width == 4 || width == 8);
	if (is_whole || is_real || (text[1] == 'b' && width == 1))
		type = {text[1], width, text[0] == '>' && width > 1};
	return type;
}

ZarrCodecs::Step ZarrCodecs::stepOf(const json& codec, const std::string& array)
{
	Step step;
	step.id = codec.value("id", "");
	const bool is_packed = isOneOf(step.id, {"blosc", "zlib", "gzip", "zstd", "lz4", "lz4-java", "crc32", "crc32c"}) ||
	                       (step.id == "lzma" && codec.value("format", 1) == 1);
	if (step.id == "shuffle")
	{
		step.width = codec.value("elementsize", std::size_t(4));
		if (step.width < 1 || step.width > 256)
			throw damaged(fmt::format("the JSON of {} cannot be followed", array));
	}
	else if (computes(step.id))
	{
		const char* from = step.id == "astype" ? "decode_dtype" : "dtype";
		const char* to = step.id == "astype" ? "encode_dtype" : "astype";
		if (step.id == "bitround")
			return step;
		step.plain = ZarrType::of(codec.at(from));
		const json stored = codec.value(to, json());
		step.stored = stored.is_null() ? step.plain : ZarrType::of(stored);
		step.scale = codec.value("scale", 1.0);
		step.offset = codec.value("offset", 0.0);
		for (const ZarrType& type : {step.plain, step.stored})
			if (type.kind == 0 || type.kind == 'b' || (type.kind == 'f' && type.width == 2) || step.scale == 0.0)
				throw Refusal(fmt::format("the chunks of {} went through the filter {} of a type that is not read; "
				                          "write it without filters",
				                          array, step.id));
	}
	else if (!is_packed)
		throw Refusal(fmt::format("the chunks of {} are packed by {}, which is not read; write it with the compressor "
		                          "Blosc, Zstd, GZip or none",
		                          array, step.id.empty() ? "something" : step.id.substr(0, 40)));
	return step;
}

ZarrCodecs::ZarrCodecs(const json& codecs, const std::string& array)
{
	if (codecs.size() > 64)
		throw damaged(fmt::format("the JSON of {} cannot be followed", array));
	for (const json& codec : codecs)
		steps_.push_back(stepOf(codec, array));
}

std::size_t ZarrCodecs::Step::packedSize(std::size_t bytes) const
{
	return addsChecksum() ? bytes + 4 : plain.width > 0 ? bytes / plain.width * stored.width : bytes;
}

bool ZarrCodecs::Step::undoNumbers(Bytes packed, std::span<std::byte> to) const
{
	const std::size_t count = to.size() / plain.width;
	if (packed.size() != count * stored.width || to.size() != count * plain.width)
		return false;
	withNumber(stored,
	           [&](auto stored_number)
	           {
		           withNumber(plain,
		                      [&](auto plain_number)
		                      {
			                      using Stored = decltype(stored_number);
			                      using Plain = decltype(plain_number);
			                      Plain sum = 0;
			                      for (std::size_t i = 0; i < count; ++i)
			                      {
				                      const auto given = numberAt<Stored>(packed.data() + i * sizeof(Stored),
				                                                          byteOrder(stored.is_big_endian));
				                      Plain number = turnedInto<Plain>(given);
				                      if (id == "delta")
					                      number = sum = static_cast<Plain>(sum + number);
				                      else if (id == "fixedscaleoffset")
					                      number = turnedInto<Plain>(static_cast<double>(given) / scale + offset);
				                      putNumber(number, to.data() + i * sizeof(Plain), byteOrder(plain.is_big_endian));
			                      }
		                      });
	           });
	return true;
}

bool ZarrCodecs::Step::undo(Bytes packed, std::span<std::byte> to) const
{
	if (id == "blosc")
		return arrays::unpackBlosc(packed, to);
	if (id == "zlib")
		return arrays::inflateZlib(packed, to);
	if (id == "gzip")
		return arrays::inflateGzip(packed, to);
	if (id == "zstd")
		return ZSTD_decompress(to.data(), to.size(), packed.data(), packed.size()) == to.size();
	if (id == "lz4")
		return unpackSizedLz4(packed, to);
	if (id == "lz4-java")
		return unpackJavaLz4(packed, to);
	if (id == "lzma")
		return unpackXz(packed, to);
	if (plain.width > 0)
		return undoNumbers(packed, to);
	if (packed.size() != packedSize(to.size()))
		return false; // also where there is no room for a checksum
	if (id == "crc32")
		return checkCrc32(packed, to);
	if (id == "crc32c")
		return checkCrc32c(packed, to);
	if (id == "shuffle")
		return arrays::unshuffle(packed, to, width);
	std::ranges::copy(packed, to.begin()); // "bitround"
	return true;
}

std::vector<std::byte> ZarrCodecs::unpack(Bytes packed, std::size_t bytes, const std::string& where) const
{
	std::vector<std::size_t> sizes = {bytes}; // before each step
	for (const Step& step : steps_)
		sizes.push_back(step.packedSize(sizes.back()));
	std::vector<std::byte> at(packed.begin(), packed.end());
	for (std::size_t i = steps_.size(); i-- > 0;)
	{
		// A compressor makes any number of bytes, and so has a checksum behind it.
		std::vector<std::byte> before(steps_[i].addsChecksum() ? at.size() - std::min<std::size_t>(at.size(), 4)
		                                                       : sizes[i]);
		if (!steps_[i].undo(at, before))
			throw damaged(fmt::format("{} cannot be unpacked ({})", where, steps_[i].id));
		at = std::move(before);
	}
	if (at.size() != bytes)
		throw damaged(fmt::format("{} has {} bytes where {} are wanted", where, at.size(), bytes));
	return at;
}

} // namespace vp::reader::volumes
