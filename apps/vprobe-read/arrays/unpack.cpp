#include "unpack.h"

#include <libdeflate.h>
#include <lz4.h>
#include <lzma.h>

#include <memory>
#include <new>

namespace vp::reader::arrays
{

namespace
{

bool unpackZlib(std::span<const std::byte> packed, std::span<std::byte> to)
{
	thread_local const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(
	    libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
	if (!decompressor)
		throw std::bad_alloc();
	return libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(), to.data(), to.size(),
	                                  nullptr) == LIBDEFLATE_SUCCESS;
}

bool unpackLz4(std::span<const std::byte> packed, std::span<std::byte> to)
{
	// Blocks are far smaller than 2 GiB.
	const int bytes =
	    LZ4_decompress_safe(reinterpret_cast<const char*>(packed.data()), reinterpret_cast<char*>(to.data()),
	                        static_cast<int>(packed.size()), static_cast<int>(to.size()));
	return bytes >= 0 && static_cast<std::size_t>(bytes) == to.size();
}

bool unpackLzma(std::span<const std::byte> packed, std::span<std::byte> to)
{
	std::uint64_t memory = UINT64_MAX; // the process has a limit of its own
	std::size_t read = 0;
	std::size_t written = 0;
	const lzma_ret status =
	    lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(packed.data()), &read,
	                              packed.size(), reinterpret_cast<std::uint8_t*>(to.data()), &written, to.size());
	return status == LZMA_OK && written == to.size();
}

} // namespace

bool unpack(Codec codec, std::span<const std::byte> packed, std::span<std::byte> to)
{
	switch (codec)
	{
	case Codec::zlib:
		return unpackZlib(packed, to);
	case Codec::lz4:
		return unpackLz4(packed, to);
	case Codec::lzma:
		return unpackLzma(packed, to);
	default:
		return false;
	}
}

} // namespace vp::reader::arrays
