#include "packed_array.h"

#include "unpack.h"
#include "vprobe-read/base/bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>

#include <unistd.h>

namespace vp::reader::arrays
{

namespace
{

// Large enough that a call of the system costs little, small enough to stay in a core's cache.
constexpr std::size_t kPartBytes = 256 << 10;
// VTK makes blocks of 32 KiB. Each thread holds a block, so blocks above this limit are left to VTK.
constexpr std::uint64_t kMaxUnpackedBlock = 64u << 20;
// Deflate, LZ4 and LZMA write less than this even if they cannot compress a block.
constexpr std::uint64_t kMaxPackedBlock = 80u << 20;

// From one byte, deflate unpacks up to 1032 bytes, LZ4 255 and LZMA about 7000. So no file gets more memory than its
// size allows.
constexpr std::uint64_t mostGrowth(Codec codec)
{
	return codec == Codec::lzma ? 8192 : 1032;
}

constexpr std::uint8_t kNoLetter = 64;
constexpr std::array<std::uint8_t, 256> kSixBits = []
{
	std::array<std::uint8_t, 256> bits{};
	bits.fill(kNoLetter);
	for (std::uint8_t i = 0; i < 26; ++i)
	{
		bits['A' + i] = i;
		bits['a' + i] = static_cast<std::uint8_t>(26 + i);
	}
	for (std::uint8_t i = 0; i < 10; ++i)
		bits['0' + i] = static_cast<std::uint8_t>(52 + i);
	bits['+'] = 62;
	bits['/'] = 63;
	return bits;
}();

// Decodes four letters to three bytes. The last group of a text may have only two or three letters, filled up with '='.
std::size_t decodeGroup(const char* letters, std::byte* to)
{
	std::array<std::uint8_t, 4> bits;
	for (std::size_t i = 0; i < 4; ++i)
		bits[i] = kSixBits[static_cast<unsigned char>(letters[i])];
	std::size_t bytes = 3;
	if (letters[3] == '=')
	{
		bits[3] = 0;
		bytes = 2;
		if (letters[2] == '=')
		{
			bits[2] = 0;
			bytes = 1;
		}
	}
	if ((bits[0] | bits[1] | bits[2] | bits[3]) & kNoLetter)
		throw NotQuick();
	const std::uint32_t word = std::uint32_t(bits[0]) << 18 | std::uint32_t(bits[1]) << 12 |
	                           std::uint32_t(bits[2]) << 6 | std::uint32_t(bits[3]);
	to[0] = static_cast<std::byte>(word >> 16);
	to[1] = static_cast<std::byte>(word >> 8);
	to[2] = static_cast<std::byte>(word);
	return bytes;
}

std::uint64_t wordAt(const std::byte* at, const Packing& packing)
{
	return integerAt(at, packing.word_bytes, byteOrder(packing.is_big_endian));
}

} // namespace

ByteSource ByteSource::from(std::uint64_t file_bytes) const
{
	if (file_bytes > end_ - begin_)
		throw NotQuick();
	ByteSource rest = *this;
	rest.begin_ += file_bytes;
	return rest;
}

void ByteSource::readFile(std::uint64_t at, std::span<std::byte> to) const
{
	if (at > end_ - begin_ || to.size() > end_ - begin_ - at)
		throw NotQuick();
	std::size_t done = 0;
	while (done < to.size())
	{
		const ssize_t n = pread(file_, to.data() + done, to.size() - done, static_cast<off_t>(begin_ + at + done));
		if (n < 0 && errno == EINTR)
			continue;
		if (n <= 0)
			throw NotQuick();
		done += static_cast<std::size_t>(n);
	}
}

void ByteSource::read(std::uint64_t at, std::span<std::byte> to, Scratch& scratch) const
{
	if (at > size() || to.size() > size() - at)
		throw NotQuick();
	if (!is_base64_)
		return readFile(at, to);
	const std::uint64_t first = at / 3;
	const std::uint64_t groups = (at + to.size() + 2) / 3 - first;
	scratch.letters.resize(groups * 4);
	readFile(first * 4, std::as_writable_bytes(std::span(scratch.letters)));
	std::size_t skip = at - first * 3;
	std::size_t done = 0;
	for (std::uint64_t g = 0; g < groups; ++g)
	{
		std::array<std::byte, 3> bytes;
		const std::size_t given = decodeGroup(scratch.letters.data() + 4 * g, bytes.data());
		const std::size_t wanted = std::min<std::size_t>(3 - skip, to.size() - done);
		if (skip + wanted > given)
			throw NotQuick();
		std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(skip), wanted,
		            to.begin() + static_cast<std::ptrdiff_t>(done));
		done += wanted;
		skip = 0;
	}
}

PackedArray::PackedArray(const ByteSource& source, const Packing& packing, Scratch& scratch)
    : codec_(packing.codec), word_bytes_(packing.word_bytes)
{
	if (codec_ != Codec::none)
	{
		readBlockSizes(source, packing, scratch);
		return;
	}
	std::array<std::byte, 8> word;
	source.read(0, std::span(word).first(packing.word_bytes), scratch);
	size_ = wordAt(word.data(), packing);
	if (size_ > source.size() - packing.word_bytes)
		throw NotQuick();
	// The number and what follows are one text in base64.
	bytes_ = source;
	block_starts_ = {packing.word_bytes};
	part_bytes_ = kPartBytes;
}

std::optional<std::uint64_t> PackedArray::placeInFile() const
{
	const std::optional<std::uint64_t> begin = bytes_.begin();
	return codec_ == Codec::none && begin ? std::optional(*begin + word_bytes_) : std::nullopt;
}

// Reads the number of blocks, their size, the size of the last one if it is smaller, and the packed size of each.
void PackedArray::readBlockSizes(const ByteSource& source, const Packing& packing, Scratch& scratch)
{
	const std::size_t word = packing.word_bytes;
	std::array<std::byte, 24> front;
	source.read(0, std::span(front).first(3 * word), scratch);
	const std::uint64_t blocks = wordAt(front.data(), packing);
	const std::uint64_t each = wordAt(front.data() + word, packing);
	const std::uint64_t last = wordAt(front.data() + 2 * word, packing);
	if (blocks == 0 || blocks > source.size() / word || each == 0 || each > kMaxUnpackedBlock || last > each)
		throw NotQuick();
	std::vector<std::byte> words(blocks * word);
	source.read(3 * word, words, scratch);
	bytes_ = source.behind((3 + blocks) * word);
	block_bytes_ = each;
	last_block_bytes_ = last == 0 ? each : last;
	size_ = (blocks - 1) * each + last_block_bytes_; // far below 2^64: there are as many blocks as words in the file
	part_bytes_ = std::max<std::size_t>(kPartBytes / each, 1) * each;
	block_starts_.resize(blocks + 1);
	for (std::uint64_t b = 0; b < blocks; ++b)
	{
		const std::uint64_t size = wordAt(words.data() + b * word, packing);
		const std::uint64_t unpacked = b + 1 == blocks ? last_block_bytes_ : block_bytes_;
		if (size > kMaxPackedBlock || size > bytes_.size() - block_starts_[b] || unpacked / mostGrowth(codec_) > size)
			throw NotQuick();
		block_starts_[b + 1] = block_starts_[b] + size;
	}
}

std::uint64_t PackedArray::base64Letters() const
{
	const auto letters = [](std::uint64_t bytes) { return (bytes + 2) / 3 * 4; };
	if (codec_ == Codec::none)
		return letters(word_bytes_ + size_);
	// The numbers in front are a text of their own: three numbers, and one for each block.
	return letters((block_starts_.size() + 2) * word_bytes_) + letters(block_starts_.back());
}

std::span<const std::byte> PackedArray::part(std::size_t index, std::uint64_t most, Scratch& scratch) const
{
	const std::uint64_t begin = std::uint64_t(index) * part_bytes_;
	const std::uint64_t end = std::min({begin + part_bytes_, begin + most, size_});
	scratch.unpacked.resize(std::max<std::size_t>(scratch.unpacked.size(), part_bytes_));
	const std::span<std::byte> wanted(scratch.unpacked.data(), end - begin);
	if (codec_ == Codec::none)
	{
		bytes_.read(block_starts_[0] + begin, wanted, scratch);
		return wanted;
	}
	const std::size_t first = begin / block_bytes_;
	const std::size_t behind = (end + block_bytes_ - 1) / block_bytes_;
	const std::uint64_t packed_begin = block_starts_[first];
	scratch.packed.resize(block_starts_[behind] - packed_begin);
	bytes_.read(packed_begin, scratch.packed, scratch);
	for (std::size_t b = first; b < behind; ++b)
	{
		const std::size_t bytes = b + 2 == block_starts_.size() ? last_block_bytes_ : block_bytes_;
		const std::span<const std::byte> packed(scratch.packed.data() + (block_starts_[b] - packed_begin),
		                                        block_starts_[b + 1] - block_starts_[b]);
		if (!unpack(codec_, packed, {scratch.unpacked.data() + (b - first) * block_bytes_, bytes}))
			throw NotQuick();
	}
	return wanted;
}

} // namespace vp::reader::arrays
