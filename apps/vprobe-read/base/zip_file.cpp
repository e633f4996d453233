// NumPy's archives need little of the format (APPNOTE of PKWARE): entries that are stored or deflated, and 64-bit
// sizes.
#include "zip_file.h"

#include "refusal.h"
#include "vprobe-read/base/bytes.h"

#include <fmt/format.h>

#include <zlib.h>

namespace vp::reader
{

namespace
{

constexpr std::uint32_t kEndMark = 0x06054b50;
constexpr std::uint32_t kWideEndMark = 0x06064b50;
constexpr std::uint32_t kEntryMark = 0x02014b50;
constexpr std::uint32_t kFileMark = 0x04034b50;
constexpr std::size_t kEndBytes = 22;
constexpr std::size_t kEntryBytes = 46;
constexpr std::size_t kFileBytes = 30;
// Deflate packs up to 1032 bytes into one.
constexpr std::uint64_t kMaxPacking = 1032;

std::uint64_t numberIn(std::string_view bytes, std::uint64_t at, std::size_t width)
{
	if (at > bytes.size() || bytes.size() - at < width)
		throw damaged("its list of files runs past its end");
	return integerAt(bytes.data() + at, width);
}

std::string_view part(std::string_view bytes, std::uint64_t at, std::uint64_t size)
{
	if (at > bytes.size() || bytes.size() - at < size)
		throw damaged("its list of files runs past its end");
	return bytes.substr(at, size);
}

// Replaces each 32-bit number that is all ones by a 64-bit number. These follow each other in the extra field.
void widen(std::string_view extra, std::initializer_list<std::uint64_t*> numbers)
{
	std::uint64_t at = 0;
	while (at + 4 <= extra.size() && numberIn(extra, at, 2) != 1)
		at += 4 + numberIn(extra, at + 2, 2);
	at += 4;
	for (std::uint64_t* number : numbers)
		if (*number == 0xFFFFFFFFu)
		{
			*number = numberIn(extra, at, 8);
			at += 8;
		}
}

} // namespace

std::vector<ZipEntry> zipEntries(std::string_view archive)
{
	// A comment of up to 64 KiB may follow the end record.
	std::size_t end = archive.size() < kEndBytes ? archive.npos : archive.size() - kEndBytes;
	const std::size_t first = archive.size() > 65536 + kEndBytes ? archive.size() - 65536 - kEndBytes : 0;
	while (end != archive.npos && numberIn(archive, end, 4) != kEndMark)
		end = end == first ? archive.npos : end - 1;
	if (end == archive.npos)
		throw damaged("its list of files is missing");
	std::uint64_t count = numberIn(archive, end + 10, 2);
	std::uint64_t at = numberIn(archive, end + 16, 4);
	if (end >= 20 && (count == 0xFFFF || at == 0xFFFFFFFFu))
	{
		const std::uint64_t wide = numberIn(archive, end - 20 + 8, 8);
		if (numberIn(archive, wide, 4) != kWideEndMark)
			throw damaged("its list of files cannot be followed");
		count = numberIn(archive, wide + 32, 8);
		at = numberIn(archive, wide + 48, 8);
	}

	std::vector<ZipEntry> entries;
	for (; count > 0; --count)
	{
		if (numberIn(archive, at, 4) != kEntryMark)
			throw damaged("its list of files cannot be followed");
		const std::uint64_t method = numberIn(archive, at + 10, 2);
		std::uint64_t packed = numberIn(archive, at + 20, 4);
		const std::uint64_t name_bytes = numberIn(archive, at + 28, 2);
		const std::uint64_t extra_bytes = numberIn(archive, at + 30, 2);
		std::uint64_t place = numberIn(archive, at + 42, 4);
		ZipEntry entry;
		entry.checksum = static_cast<std::uint32_t>(numberIn(archive, at + 16, 4));
		entry.size = numberIn(archive, at + 24, 4);
		entry.deflated = method == Z_DEFLATED;
		entry.name = part(archive, at + kEntryBytes, name_bytes);
		widen(part(archive, at + kEntryBytes + name_bytes, extra_bytes), {&entry.size, &packed, &place});
		if (method != 0 && method != Z_DEFLATED)
			throw Refusal(fmt::format("an archive packed by method {}; save it with numpy.savez", method));
		if (numberIn(archive, place, 4) != kFileMark)
			throw damaged("its list of files cannot be followed");
		const std::uint64_t skip = kFileBytes + numberIn(archive, place + 26, 2) + numberIn(archive, place + 28, 2);
		entry.packed = part(archive, place + skip, packed);
		if (entry.size > packed * (entry.deflated ? kMaxPacking : 1))
			throw damaged("it unpacks to more than it can");
		entries.push_back(std::move(entry));
		at += kEntryBytes + name_bytes + extra_bytes + numberIn(archive, at + 32, 2);
	}
	return entries;
}

std::string unpackEntry(const ZipEntry& entry)
{
	std::string bytes(entry.size, '\0');
	if (!entry.deflated)
		bytes = entry.packed;
	else
	{
		z_stream stream = {};
		inflateInit2(&stream, -MAX_WBITS); // without a header of its own
		std::size_t read = 0, written = 0;
		int status = Z_OK;
		// zlib counts in 32 bits.
		constexpr std::size_t chunk = 1u << 30;
		while (status == Z_OK)
		{
			const std::size_t in = std::min(chunk, entry.packed.size() - read);
			const std::size_t out = std::min(chunk, bytes.size() - written);
			stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(entry.packed.data() + read));
			stream.avail_in = static_cast<uInt>(in);
			stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + written);
			stream.avail_out = static_cast<uInt>(out);
			status = inflate(&stream, Z_NO_FLUSH);
			read += in - stream.avail_in;
			written += out - stream.avail_out;
			if (status == Z_BUF_ERROR || (in == stream.avail_in && out == stream.avail_out))
				break;
		}
		inflateEnd(&stream);
		if (status != Z_STREAM_END || written != bytes.size())
			throw damaged(fmt::format("{} does not unpack", entry.name));
	}
	if (crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != entry.checksum)
		throw damaged(fmt::format("the checksum of {} is wrong", entry.name));
	return bytes;
}

} // namespace vp::reader
