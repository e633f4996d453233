#include "gzip_text.h"

#include "vprobe-read/base/refusal.h"

#include <zlib.h>

#include <algorithm>

namespace vp::reader::text
{

namespace
{

// Unpacks the parts of a file, one after the other. Ignores bytes behind the last part.
std::string gunzipped(std::string_view packed)
{
	// zlib counts in 32 bits; the memory that reading may take limits the whole.
	constexpr std::size_t step = 1u << 22;
	std::string bytes;
	z_stream stream = {};
	if (inflateInit2(&stream, MAX_WBITS + 16) != Z_OK) // with gzip's header
		throw std::bad_alloc();
	int status = Z_OK;
	std::size_t read = 0;
	while (status == Z_OK)
	{
		const std::size_t in = std::min(step, packed.size() - read);
		const std::size_t written = bytes.size();
		try
		{
			bytes.resize(written + step);
		}
		catch (...)
		{
			inflateEnd(&stream);
			throw;
		}
		stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + read));
		stream.avail_in = static_cast<uInt>(in);
		stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + written);
		stream.avail_out = static_cast<uInt>(step);
		status = inflate(&stream, Z_NO_FLUSH);
		read += in - stream.avail_in;
		bytes.resize(written + step - stream.avail_out);
		if (status == Z_STREAM_END && packed.substr(read).starts_with("\x1f\x8b"))
			status = inflateReset(&stream);
	}
	inflateEnd(&stream);
	if (status != Z_STREAM_END)
		throw damaged("it does not unpack");
	return bytes;
}

} // namespace

MaybeGzip::MaybeGzip(const std::string& file)
    : mapped_(file), is_packed_(mapped_.text().starts_with("\x1f\x8b")),
      unpacked_(is_packed_ ? gunzipped(mapped_.text()) : "")
{
}

} // namespace vp::reader::text
