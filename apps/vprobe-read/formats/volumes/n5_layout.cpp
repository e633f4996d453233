// Data sets of N5, read as arrays of Zarr.
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"
#include "zarr_array.h"
#include "zarr_words.h"

#include <fmt/format.h>

#include <numeric>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

// The words of numcodecs for what a compression of N5 does.
json codecOfN5(const json& about, const std::string& name)
{
	const json given = about.value("compression", json());
	const json type = given.is_object() ? given.value("type", json()) : about.value("compressionType", json("raw"));
	if (!type.is_string())
		throw notFollowedZarr(name);
	const auto id = type.get<std::string>();
	const bool is_zlib = given.is_object() && given.value("useZlib", json(false)) == true;
	return {{"id", id == "xz"                ? "lzma"
	               : id == "gzip" && is_zlib ? "zlib"
	               : id == "lz4"             ? "lz4-java"
	               : id == "zstandard"       ? "zstd"
	                                         : id}};
}

} // namespace

bool isOfN5(const json& about)
{
	return about.contains("dimensions") && about.contains("blockSize");
}

// The first side is the fastest, in names too.
ZarrLayout layoutOfN5(const json& about, const std::string& name)
{
	ZarrLayout layout;
	layout.shape = zarrSides(about.value("dimensions", json()), name);
	layout.file = layout.chunk = zarrSides(about.value("blockSize", json()), name);
	layout.order.resize(layout.shape.size());
	std::iota(layout.order.rbegin(), layout.order.rend(), 0);
	layout.separators = "/";
	layout.has_block_heads = true;
	const json type = about.value("dataType", json());
	layout.type = zarrTypeNamed(type.is_string() ? type.get<std::string>() : std::string());
	if (layout.type.kind == 0 || layout.type.kind == 'b' || (layout.type.kind == 'f' && layout.type.width == 2))
	{
		layout.type = {};
		return layout;
	}
	layout.type.is_big_endian = layout.type.width > 1;
	layout.fill = std::vector<std::byte>(layout.type.width);
	if (const json codec = codecOfN5(about, name); codec["id"] != "raw")
		layout.codecs.push_back(codec);
	return layout;
}

// The head of a block of N5: its kind, the number of its sides, and these. The last blocks may be shorter than others.
std::vector<std::size_t> ZarrArray::takeBlockHead(std::span<const std::byte>& packed, const std::string& where) const
{
	constexpr std::size_t kHead = 4;
	const auto number = [&](std::size_t at) { return numberAt<std::uint16_t>(packed.data() + at, ByteOrder::big); };
	const std::size_t sides = layout_.shape.size();
	const bool is_there = packed.size() >= kHead + 4 * sides;
	const bool counts_values = is_there && number(0) == 1; // and says so behind its sides
	const std::size_t bytes = kHead + 4 * sides + (counts_values ? 4 : 0);
	if (!is_there || number(0) > 1 || number(2) != sides || packed.size() < bytes)
		throw damaged(fmt::format("{} has a head that cannot be followed", where));
	std::vector<std::size_t> held(sides);
	for (std::size_t i = 0; i < sides; ++i)
	{
		const std::size_t side = layout_.keys[i];
		held[side] = numberAt<std::uint32_t>(packed.data() + kHead + 4 * i, ByteOrder::big);
		if (held[side] < 1 || held[side] > layout_.chunk[side])
			throw damaged(fmt::format("{} has other sides than its array's blocks", where));
	}
	packed = packed.subspan(bytes);
	return held;
}

} // namespace vp::reader::volumes
