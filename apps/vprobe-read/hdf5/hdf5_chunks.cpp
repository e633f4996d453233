#include "hdf5_chunks.h"

#include "hdf5_handle.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"

#include <deque>
#include <set>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

namespace vp::reader::hdf5
{

// HDF5 File Format Specification, version 3: IV.A (object headers), IV.A.2.i (layout), III.A.1 (version 1 B-trees).

namespace
{

constexpr std::uint16_t kLayoutMessage = 8;
constexpr std::uint16_t kContinuationMessage = 16;
constexpr std::size_t kMaxBlocks = 1024; // an object header has no more

// The bytes of a file from its base address on. Addresses that lead outside make the file a damaged one.
class FileBytes
{
public:
	FileBytes(std::string_view text, std::uint64_t base) : text_(text), base_(base) {}

	std::uint64_t base() const { return base_; }
	std::string_view at(std::uint64_t address, std::uint64_t count) const
	{
		const std::uint64_t size = text_.size() - std::min<std::uint64_t>(base_, text_.size());
		if (address > size || count > size - address)
			throw damaged("the index of its chunks lies outside of it");
		return text_.substr(base_ + address, count);
	}
	// Tells the system that bytes are read soon, which lie far apart in a large file. Addresses outside are passed
	// over.
	void announce(std::uint64_t address, std::uint64_t count) const
	{
		const std::uint64_t size = text_.size() - std::min<std::uint64_t>(base_, text_.size());
		if (address > size || count > size - address)
			return;
		static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
		const auto begin = reinterpret_cast<std::uintptr_t>(text_.data() + base_ + address);
		const std::uintptr_t from = begin / page * page;
		madvise(reinterpret_cast<void*>(from), begin + count - from, MADV_WILLNEED);
	}
	template <class Number>
	Number number(std::uint64_t address) const
	{
		return numberAt<Number>(at(address, sizeof(Number)).data());
	}

private:
	std::string_view text_;
	std::uint64_t base_;
};

// A run of messages of an object header.
struct MessageBlock
{
	std::uint64_t address;
	std::uint64_t bytes;
};

// How messages are written: version 1 or 2 of object headers.
struct MessageForm
{
	bool is_old = true;
	bool has_order = false; // version 2 alone: two bytes more

	std::uint64_t headBytes() const { return is_old ? 8 : has_order ? 6 : 4; }
};

MessageBlock firstBlock(const FileBytes& file, std::uint64_t address, MessageForm& form)
{
	if (file.at(address, 4) != "OHDR")
		return {address + 16, file.number<std::uint32_t>(address + 8)};
	const auto flags = file.number<std::uint8_t>(address + 5);
	form = {false, (flags & 4) != 0};
	std::uint64_t at = address + 6 + (flags & 32 ? 16 : 0) + (flags & 16 ? 4 : 0);
	const std::uint64_t width = std::uint64_t(1) << (flags & 3);
	return {at + width, integerAt(file.at(at, width).data(), width)};
}

// Returns the address of the layout message's contents, or nothing.
std::optional<std::uint64_t> layoutOf(const FileBytes& file, std::uint64_t header)
{
	MessageForm form;
	std::deque<MessageBlock> blocks{firstBlock(file, header, form)};
	for (std::size_t b = 0; b < blocks.size() && b < kMaxBlocks; ++b)
	{
		const MessageBlock block = blocks[b];
		file.at(block.address, block.bytes);
		for (std::uint64_t at = block.address; at + form.headBytes() <= block.address + block.bytes;)
		{
			const std::uint16_t type = form.is_old ? file.number<std::uint16_t>(at) : file.number<std::uint8_t>(at);
			const auto bytes = file.number<std::uint16_t>(at + (form.is_old ? 2 : 1));
			const std::uint64_t contents = at + form.headBytes();
			if (type == kLayoutMessage)
				return contents;
			if (type == kContinuationMessage)
			{
				const auto address = file.number<std::uint64_t>(contents);
				const auto length = file.number<std::uint64_t>(contents + 8);
				if (form.is_old)
					blocks.push_back({address, length});
				else if (length > 8) // between a signature and a checksum
					blocks.push_back({address + 4, length - 8});
			}
			at = contents + bytes;
		}
	}
	return std::nullopt;
}

// A walk through a version 1 B-tree.
class ChunkTree
{
public:
	ChunkTree(const FileBytes& file, std::size_t rank) : file_(file), rank_(rank), key_bytes_(8 + 8 * (rank + 1)) {}

	std::vector<Chunk> chunks(std::uint64_t root)
	{
		visit(root, -1);
		return std::move(found_);
	}

private:
	void visit(std::uint64_t node, int level)
	{
		if (!visited_.insert(node).second || file_.at(node, 4) != "TREE" || file_.number<std::uint8_t>(node + 4) != 1)
			throw damaged("the index of its chunks is none");
		const int here = file_.number<std::uint8_t>(node + 5);
		if (level >= 0 && here != level)
			throw damaged("the index of its chunks has levels in no order");
		const auto count = file_.number<std::uint16_t>(node + 6);
		const std::uint64_t node_bytes = 24 + count * (key_bytes_ + 8) + key_bytes_;
		for (std::uint64_t i = 0; here > 0 && i < count; ++i)
			file_.announce(file_.number<std::uint64_t>(node + 24 + i * (key_bytes_ + 8) + key_bytes_), node_bytes);
		for (std::uint64_t i = 0; i < count; ++i)
		{
			const std::uint64_t key = node + 24 + i * (key_bytes_ + 8);
			const auto child = file_.number<std::uint64_t>(key + key_bytes_);
			if (here > 0)
			{
				visit(child, here - 1);
				continue;
			}
			Chunk chunk;
			chunk.bytes = file_.number<std::uint32_t>(key);
			chunk.left_out_filters = file_.number<std::uint32_t>(key + 4);
			for (std::size_t side = 0; side < rank_; ++side)
				chunk.first.push_back(file_.number<std::uint64_t>(key + 8 + 8 * side));
			file_.at(child, chunk.bytes);
			chunk.offset = file_.base() + child;
			found_.push_back(std::move(chunk));
		}
	}

	const FileBytes& file_;
	std::size_t rank_;
	std::uint64_t key_bytes_;
	std::set<std::uint64_t> visited_;
	std::vector<Chunk> found_;
};

// Returns where the object's header lies, or nothing where HDF5 does not say it.
std::optional<std::uint64_t> headerOf(hid_t set)
{
#if H5_VERSION_GE(1, 12, 0)
	H5O_info2_t about;
	haddr_t address = HADDR_UNDEF;
	if (H5Oget_info3(set, &about, H5O_INFO_BASIC) < 0 || H5VLnative_token_to_addr(set, about.token, &address) < 0)
		return std::nullopt;
	return address;
#else
	H5O_info_t about;
	if (H5Oget_info2(set, &about, H5O_INFO_BASIC) < 0)
		return std::nullopt;
	return about.addr;
#endif
}

} // namespace

std::optional<std::vector<Chunk>> chunksOf(hid_t set, const std::string& file)
{
	const Handle opened(H5Iget_file_id(set), H5Fclose);
	const Handle properties(opened < 0 ? -1 : H5Fget_create_plist(opened), H5Pclose);
	std::size_t offset_bytes = 0;
	std::size_t length_bytes = 0;
	hsize_t base = 0;
	if (properties < 0 || H5Pget_sizes(properties, &offset_bytes, &length_bytes) < 0 || offset_bytes != 8 ||
	    length_bytes != 8 || H5Pget_userblock(properties, &base) < 0)
		return std::nullopt;
	const std::optional<std::uint64_t> header = headerOf(set);
	if (!header)
		return std::nullopt;
	const MappedText mapped(file);
	const FileBytes bytes(mapped.text(), base);
	madvise(const_cast<char*>(mapped.text().data()), mapped.text().size(), MADV_RANDOM);
	const std::optional<std::uint64_t> layout = layoutOf(bytes, *header);
	constexpr std::uint8_t kVersion = 3;
	constexpr std::uint8_t kChunked = 2;
	if (!layout || bytes.number<std::uint8_t>(*layout) != kVersion ||
	    bytes.number<std::uint8_t>(*layout + 1) != kChunked)
		return std::nullopt;
	const std::size_t sides = bytes.number<std::uint8_t>(*layout + 2); // the last is the value itself
	if (sides < 2 || sides > H5S_MAX_RANK + 1)
		throw damaged("its chunks have too many sides");
	const auto root = bytes.number<std::uint64_t>(*layout + 3);
	if (root == HADDR_UNDEF)
		return std::vector<Chunk>();
	return ChunkTree(bytes, sides - 1).chunks(root);
}

} // namespace vp::reader::hdf5
