#include "meta_header.h"

#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include <libdeflate.h>

namespace vp::reader::volumes
{

namespace
{

// The largest factor by which zlib packs.
constexpr std::uint64_t kMaxPacking = 1032;

std::string unpackedMeta(std::string_view packed, std::uint64_t bytes)
{
	if (bytes / kMaxPacking > packed.size())
		throw damaged(fmt::format("{} bytes of packed data, which cannot hold {}", packed.size(), bytes));
	const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(
	    libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
	if (!decompressor)
		throw std::bad_alloc();
	std::string values(bytes, '\0');
	const auto unpack = packed.starts_with("\x1f\x8b") ? libdeflate_gzip_decompress : libdeflate_zlib_decompress;
	if (unpack(decompressor.get(), packed.data(), packed.size(), values.data(), values.size(), nullptr) !=
	    LIBDEFLATE_SUCCESS)
		throw damaged("what is packed in it cannot be unpacked, or has another size than its header asks for");
	return values;
}

// Returns the data of one file: all of its bytes from where the data begin.
std::string_view dataOf(const MetaHeader& header, std::string_view file, const std::string& whose, std::uint64_t bytes)
{
	std::uint64_t begin = header.data_files.empty() ? header.header_bytes : 0;
	if (header.skipped_bytes > 0)
		begin = static_cast<std::uint64_t>(header.skipped_bytes);
	const std::uint64_t wanted = header.is_text ? 1 : header.compressed ? header.compressed_bytes : bytes;
	const bool knows_end = !header.compressed || header.compressed_bytes > 0;
	if (header.skipped_bytes < 0 && knows_end && file.size() >= wanted)
		begin = std::max(file.size() - wanted, begin);
	const std::uint64_t there = file.size() - std::min<std::uint64_t>(file.size(), begin);
	if (there < wanted)
		throw damaged(whose.empty()
		                  ? fmt::format("{} bytes of data where its header asks for {}", there, wanted)
		                  : fmt::format("its data file {} has {} bytes where {} are asked for", whose, there, wanted));
	return file.substr(begin);
}

// The bytes from `begin` of what a file holds unpacked.
void appendPart(std::string& values, const MetaHeader& header, std::string_view data, std::uint64_t file_bytes,
                std::uint64_t begin, std::uint64_t end)
{
	if (header.compressed)
		values += unpackedMeta(data, file_bytes).substr(begin, end - begin);
	else
		values += data.substr(begin, end - begin);
}

// Returns the bytes of all times. Throws a Refusal where they are more than can be.
std::uint64_t bytesOfAll(const MetaHeader& header)
{
	std::uint64_t all = 0;
	if (__builtin_mul_overflow(header.volumeBytes(), header.times(), &all) || all > std::uint64_t(1) << 50)
		throw damaged("its DimSize cannot be");
	return all;
}

// Returns the path of a data file, which is empty where the data follow the header.
std::string dataFile(const std::string& file, const MetaHeader& header, std::size_t number)
{
	if (header.data_files.empty())
		return {};
	std::string name = (std::filesystem::path(file).parent_path() / header.data_files[number]).string();
	std::error_code error;
	if (!std::filesystem::is_regular_file(name, error))
		throw Refusal(fmt::format("its data file {} cannot be opened; keep both together", name));
	return name;
}

} // namespace

std::optional<MetaPlace> metaPlace(const std::string& file, const MetaHeader& header, std::uint64_t time)
{
	if (header.is_text || header.compressed || header.data_files.size() > 1)
		return std::nullopt;
	const std::string name = dataFile(file, header, 0);
	const MappedText mapped(name.empty() ? file : name);
	const std::string_view data = dataOf(header, mapped.text(), name, bytesOfAll(header));
	const auto begin = static_cast<std::uint64_t>(data.data() - mapped.text().data());
	return MetaPlace{name.empty() ? file : name, begin + time * header.volumeBytes()};
}

std::string metaBytes(const std::string& file, const MetaHeader& header, std::uint64_t time)
{
	const std::uint64_t volume = header.volumeBytes();
	const std::uint64_t all = bytesOfAll(header);
	const std::size_t files = std::max<std::size_t>(header.data_files.size(), 1);
	const std::uint64_t file_bytes = all / files;
	const std::uint64_t first = header.is_text ? 0 : time * volume;
	const std::uint64_t last = header.is_text ? all : first + volume;

	std::string values;
	for (std::size_t i = 0; i < files; ++i)
	{
		const std::uint64_t begin = i * file_bytes;
		const std::string name = dataFile(file, header, i);
		if (begin + file_bytes <= first || begin >= last)
			continue; // it holds another time
		const MappedText mapped(name.empty() ? file : name);
		const std::string_view data = dataOf(header, mapped.text(), name, file_bytes);
		if (header.is_text)
			values.append(data).append(1, '\n');
		else
			appendPart(values, header, data, file_bytes, std::max(first, begin) - begin,
			           std::min(last, begin + file_bytes) - begin);
	}
	return values;
}

} // namespace vp::reader::volumes
