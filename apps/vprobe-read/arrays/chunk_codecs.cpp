#include "chunk_codecs.h"

#include <algorithm>
#include <array>
#include <memory>
#include <new>

#include <blosc.h>
#include <libdeflate.h>

namespace vp::reader::arrays
{

namespace
{

template <class Decompress>
bool inflateChunkBy(Decompress* decompress, std::span<const std::byte> packed, std::span<std::byte> to)
{
	const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> one(
	    libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
	if (!one)
		throw std::bad_alloc();
	return decompress(one.get(), packed.data(), packed.size(), to.data(), to.size(), nullptr) == LIBDEFLATE_SUCCESS;
}

} // namespace

bool inflateZlib(std::span<const std::byte> packed, std::span<std::byte> to)
{
	return inflateChunkBy(libdeflate_zlib_decompress, packed, to);
}

bool inflateGzip(std::span<const std::byte> packed, std::span<std::byte> to)
{
	return inflateChunkBy(libdeflate_gzip_decompress, packed, to);
}

bool unpackBlosc(std::span<const std::byte> packed, std::span<std::byte> to)
{
	std::size_t bytes = 0;
	return blosc_cbuffer_validate(packed.data(), packed.size(), &bytes) == 0 && bytes == to.size() &&
	       blosc_decompress_ctx(packed.data(), to.data(), to.size(), 1) == static_cast<int>(to.size());
}

bool unshuffle(std::span<const std::byte> packed, std::span<std::byte> to, std::size_t width)
{
	if (packed.size() != to.size() || width == 0)
		return false;
	const std::size_t count = packed.size() / width;
	for (std::size_t b = 0; b < width; ++b)
		for (std::size_t i = 0; i < count; ++i)
			to[i * width + b] = packed[b * count + i];
	std::copy(packed.begin() + static_cast<std::ptrdiff_t>(count * width), packed.end(),
	          to.begin() + static_cast<std::ptrdiff_t>(count * width));
	return true;
}

std::uint32_t crc32c(std::span<const std::byte> bytes)
{
	static constexpr std::array<std::uint32_t, 256> table = []
	{
		std::array<std::uint32_t, 256> all{};
		for (std::uint32_t i = 0; i < 256; ++i)
		{
			all[i] = i;
			for (int bit = 0; bit < 8; ++bit)
				all[i] = all[i] >> 1 ^ (all[i] & 1 ? 0x82F63B78 : 0);
		}
		return all;
	}();
	std::uint32_t sum = ~std::uint32_t(0);
	for (const std::byte byte : bytes)
		sum = table[(sum ^ static_cast<std::uint32_t>(byte)) & 0xFF] ^ sum >> 8;
	return ~sum;
}

} // namespace vp::reader::arrays
