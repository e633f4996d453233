#include "zarr_array.h"

#include "parts/part_bytes.h"
#include "vprobe-read/arrays/chunk_codecs.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/bytes_read.h"
#include "vprobe-read/base/half_float.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <mutex>
#include <numeric>
#include <set>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

namespace fs = std::filesystem;

using Sides = std::vector<std::size_t>;

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

Sides unturned(std::size_t count)
{
	Sides order(count);
	std::iota(order.begin(), order.end(), 0);
	return order;
}

// Returns how many values lie between neighbors along each side. order: the sides from slowest to fastest.
Sides stridesOf(const Sides& sides, const Sides& order)
{
	Sides strides(sides.size());
	std::size_t step = 1;
	for (std::size_t i = sides.size(); i-- > 0;)
	{
		strides[order[i]] = step;
		step *= sides[order[i]];
	}
	return strides;
}

// Calls use(indices) for each combination of `count` indices from `first` on, the last side fastest.
template <class Use>
void forEachIndex(const Sides& first, const Sides& count, Use&& use)
{
	Sides at = first;
	for (;;)
	{
		use(at);
		std::size_t side = at.size();
		while (side > 0 && ++at[side - 1] == first[side - 1] + count[side - 1])
		{
			at[side - 1] = first[side - 1];
			--side;
		}
		if (side == 0)
			return;
	}
}

// The pieces of a grid that a box meets: the first of them along each side, and how many.
struct Pieces
{
	Sides first, count;

	Pieces(const Sides& starts, const Sides& counts, const Sides& sides)
	{
		for (std::size_t i = 0; i < sides.size(); ++i)
		{
			first.push_back(starts[i] / sides[i]);
			count.push_back((starts[i] + counts[i] - 1) / sides[i] - first[i] + 1);
		}
	}
};

} // namespace

// Remembers the shards whose index was held against its checksum. Any thread may ask.
class ZarrArray::CheckedShards
{
public:
	bool has(const std::string& file) const
	{
		const std::lock_guard lock(mutex_);
		return files_.contains(file);
	}
	void add(const std::string& file)
	{
		const std::lock_guard lock(mutex_);
		files_.insert(file);
	}

private:
	mutable std::mutex mutex_;
	std::set<std::string> files_;
};

// A file of several chunks. Its index says for each chunk where it lies, and how long it is.
class ZarrArray::Shard
{
public:
	Shard(std::span<const std::byte> file, const ZarrLayout& layout, std::string where)
	    : file_(file), where_(std::move(where)), has_checksum_(layout.index_has_checksum)
	{
		std::size_t chunks = 1;
		for (std::size_t i = 0; i < layout.file.size(); ++i)
		{
			per_side_.push_back(layout.file[i] / layout.chunk[i]);
			chunks *= per_side_.back(); // no more than bytes in a file, as it was checked
		}
		keys_ = layout.keys;
		const std::size_t checksum = has_checksum_ ? 4 : 0;
		if (file.size() < checksum || (file.size() - checksum) / kEntry < chunks)
			throw damaged(fmt::format("{} is shorter than its index", where_));
		const std::size_t bytes = chunks * kEntry + checksum;
		index_ = layout.index_is_first ? file.first(bytes) : file.last(bytes);
	}

	std::size_t indexBytes() const { return index_.size(); }
	void check() const
	{
		const auto entries = index_.first(index_.size() - (has_checksum_ ? 4 : 0));
		if (has_checksum_ && numberAt<std::uint32_t>(index_.data() + entries.size()) != arrays::crc32c(entries))
			throw damaged(fmt::format("the index of {} has another checksum", where_));
	}
	// Returns a chunk by its indices in the shard; nothing if it is not there.
	std::optional<std::span<const std::byte>> chunk(const Sides& indices) const
	{
		std::size_t number = 0;
		for (const std::size_t side : keys_)
			number = number * per_side_[side] + indices[side];
		const auto offset = numberAt<std::uint64_t>(index_.data() + number * kEntry);
		const auto size = numberAt<std::uint64_t>(index_.data() + number * kEntry + 8);
		if (offset == ~std::uint64_t(0) && size == ~std::uint64_t(0))
			return std::nullopt;
		if (offset > file_.size() || size > file_.size() - offset)
			throw damaged(fmt::format("{} has a chunk that lies outside of it", where_));
		return file_.subspan(offset, size);
	}

private:
	static constexpr std::size_t kEntry = 16;

	std::span<const std::byte> file_, index_;
	std::string where_;
	bool has_checksum_;
	Sides per_side_, keys_;
};

std::optional<json> zarrArrayJson(const fs::path& folder)
{
	std::error_code ignored;
	if (fs::is_regular_file(folder / ".zarray", ignored))
		return zarrJson(folder / ".zarray");
	if (fs::is_regular_file(folder / "zarr.json", ignored))
	{
		const json about = zarrJson(folder / "zarr.json");
		return about.value("node_type", "") == "array" ? std::optional(about) : std::nullopt;
	}
	if (!fs::is_regular_file(folder / "attributes.json", ignored))
		return std::nullopt;
	const json about = zarrJson(folder / "attributes.json");
	return isOfN5(about) ? std::optional(about) : std::nullopt;
}

ZarrArray::ZarrArray(fs::path folder, std::string name, const json& about)
    : folder_(std::move(folder)), name_(std::move(name)), layout_(ZarrLayout::of(about, name_)),
      codecs_(layout_.codecs, name_), checked_(std::make_unique<CheckedShards>())
{
}

ZarrArray::~ZarrArray() = default;
ZarrArray::ZarrArray(ZarrArray&&) noexcept = default;

void ZarrArray::turn(const Sides& order)
{
	Sides sorted = order;
	std::ranges::sort(sorted);
	if (sorted != unturned(layout_.shape.size()))
		throw damaged(fmt::format("its {} has other sides than are asked for", name_));
	if (order == sorted)
		return;
	layout_.turn(order);
	turned_ = order;
}

// The files of a part that few of them cover, by their names. Nothing for others.
std::optional<std::vector<ZarrArray::File>> ZarrArray::fewFilesIn(const Sides& starts, const Sides& counts) const
{
	constexpr std::size_t kFew = 16;
	const Pieces pieces(starts, counts, layout_.file);
	std::size_t all = 1;
	for (const std::size_t count : pieces.count)
		if (__builtin_mul_overflow(all, count, &all) || all > kFew)
			return std::nullopt;
	std::vector<File> files;
	forEachIndex(pieces.first, pieces.count,
	             [&](const Sides& indices)
	             {
		             for (const std::string& name : layout_.namesOfFile(indices))
			             if (std::error_code ignored; fs::is_regular_file(folder_ / name, ignored))
			             {
				             files.push_back({folder_ / name, indices});
				             break;
			             }
	             });
	return files;
}

// Not over all files that there may be: a text can name far more of them than there are.
std::vector<ZarrArray::File> ZarrArray::filesIn(const Sides& starts, const Sides& counts) const
{
	if (auto few = fewFilesIn(starts, counts))
		return std::move(*few);
	const Pieces pieces(starts, counts, layout_.file);
	std::vector<File> files;
	for (auto entry = fs::recursive_directory_iterator(folder_); entry != fs::recursive_directory_iterator(); ++entry)
	{
		const std::string name = entry->path().lexically_relative(folder_).generic_string();
		const auto indices = layout_.indicesOf(name);
		if (entry->is_directory() && name != layout_.key_front && (!indices || indices->size() >= layout_.shape.size()))
			entry.disable_recursion_pending();
		if (!indices || !entry->is_regular_file())
			continue;
		bool is_wanted = indices->size() == layout_.shape.size();
		for (std::size_t i = 0; is_wanted && i < indices->size(); ++i)
			is_wanted = (*indices)[i] >= pieces.first[i] && (*indices)[i] - pieces.first[i] < pieces.count[i];
		if (is_wanted)
			files.push_back({entry->path(), *indices});
	}
	return files;
}

// Returns how many values were wanted of the chunk. begin: of its values in the array.
std::size_t ZarrArray::copyChunk(std::span<const std::byte> packed, const Sides& begin, const std::string& where,
                                 const Sides& starts, const Sides& counts, std::byte* to) const
{
	countMapped(packed.size());
	const Sides held = layout_.has_block_heads ? takeBlockHead(packed, where) : layout_.chunk;
	const std::size_t sides = layout_.shape.size(), width = layout_.type.width;
	const std::size_t bytes = std::accumulate(held.begin(), held.end(), width, std::multiplies<>());
	const std::vector<std::byte> from = codecs_.unpack(packed, bytes, where);
	if (sides == 0)
	{
		std::memcpy(to, from.data(), width);
		return 1;
	}
	const Sides from_strides = stridesOf(held, layout_.order), to_strides = stridesOf(counts, unturned(sides));
	Sides count(sides), none(sides, 0);
	std::size_t from_first = 0, to_first = 0, values = 1;
	for (std::size_t i = 0; i < sides; ++i)
	{
		const std::size_t first = std::max(begin[i], starts[i]);
		const std::size_t end = std::min({begin[i] + held[i], starts[i] + counts[i], layout_.shape[i]});
		if (end <= first) // a block of N5 that is cut short
			return 0;
		count[i] = end - first;
		from_first += (first - begin[i]) * from_strides[i];
		to_first += (first - starts[i]) * to_strides[i];
		values *= count[i];
	}
	Sides rows = count;
	rows.back() = 1;
	forEachIndex(none, rows,
	             [&](const Sides& at)
	             {
		             std::size_t from_at = from_first, to_at = to_first;
		             for (std::size_t i = 0; i + 1 < sides; ++i)
		             {
			             from_at += at[i] * from_strides[i];
			             to_at += at[i] * to_strides[i];
		             }
		             copyRow(width, from.data() + from_at * width, from_strides.back(), to + to_at * width,
		                     count.back());
	             });
	return values;
}

std::size_t ZarrArray::copyFile(const File& file, const Sides& starts, const Sides& counts, std::byte* to) const
{
	const MappedText mapped(file.path.string());
	const auto bytes = std::as_bytes(std::span(mapped.text()));
	const std::string key = file.path.lexically_relative(folder_).generic_string();
	Sides begin = file.indices;
	for (std::size_t i = 0; i < begin.size(); ++i)
		begin[i] *= layout_.file[i];
	if (!layout_.is_sharded)
		return copyChunk(bytes, begin, fmt::format("chunk {} of {}", key, name_), starts, counts, to);

	const std::string where = fmt::format("shard {} of {}", key, name_);
	const Shard shard(bytes, layout_, where);
	if (!checked_->has(key))
	{
		countMapped(shard.indexBytes());
		shard.check();
		checked_->add(key);
	}
	Sides first(begin.size()), count(begin.size()); // in the shard
	for (std::size_t i = 0; i < begin.size(); ++i)
	{
		first[i] = std::max(begin[i], starts[i]) - begin[i];
		const std::size_t end = std::min({begin[i] + layout_.file[i], starts[i] + counts[i], layout_.shape[i]});
		if (end <= begin[i] + first[i]) // it was left when the array was made smaller
			return 0;
		count[i] = end - begin[i] - first[i];
	}
	const Pieces pieces(first, count, layout_.chunk);
	std::size_t values = 0;
	forEachIndex(pieces.first, pieces.count,
	             [&](const Sides& indices)
	             {
		             Sides of_chunk = begin;
		             for (std::size_t i = 0; i < indices.size(); ++i)
			             of_chunk[i] += indices[i] * layout_.chunk[i];
		             const auto packed = shard.chunk(indices);
		             if (!packed)
			             return;
		             mapped.announce({reinterpret_cast<const char*>(packed->data()), packed->size()});
		             values += copyChunk(*packed, of_chunk, where, starts, counts, to);
	             });
	return values;
}

void ZarrArray::read(const Sides& starts, const Sides& counts, std::byte* given) const
{
	const ZarrType& type = layout_.type;
	std::size_t values = 1;
	for (const std::size_t count : counts)
		values *= count;
	std::vector<std::byte> halves(isHalf() ? 2 * values : 0);
	std::byte* to = isHalf() ? halves.data() : given;
	const auto filling = layout_.fill.value_or(std::vector<std::byte>(type.width, std::byte(0xFF))); // NaN
	parts::fillItems({to, values * type.width}, filling);
	std::size_t written = 0;
	if (values > 0)
		for (const File& file : filesIn(starts, counts))
			written += copyFile(file, starts, counts, to);
	if (written < values && !layout_.fill && type.kind != 'f')
		throw damaged(fmt::format("chunks of {} are missing, and it has no fill_value", name_));
	if (type.is_big_endian)
		parts::swapNumbers({to, values * type.width}, type.width);
	for (std::size_t i = 0; isHalf() && i < values; ++i)
		putNumber(fromHalf(numberAt<std::uint16_t>(halves.data() + 2 * i)), given + 4 * i);
}

} // namespace vp::reader::volumes
