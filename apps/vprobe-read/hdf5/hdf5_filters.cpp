#include "hdf5_filters.h"

#include "vprobe-read/arrays/chunk_codecs.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <sstream>
#include <utility>

#include <lz4.h>
#include <zstd.h>

namespace vp::reader::hdf5
{

namespace
{

using PackedBytes = std::span<const std::byte>;
using UnpackedBytes = std::span<std::byte>;

// The numbers that The HDF Group has given to filters.
constexpr std::array<std::pair<H5Z_filter_t, const char*>, 6> kFilters{{{H5Z_FILTER_DEFLATE, "deflate"},
                                                                        {H5Z_FILTER_SHUFFLE, "shuffle"},
                                                                        {H5Z_FILTER_FLETCHER32, "fletcher32"},
                                                                        {32001, "blosc"},
                                                                        {32004, "lz4"},
                                                                        {32015, "zstd"}}};
constexpr std::size_t kChecksumBytes = 4;

// The filter of The HDF Group: the number of bytes, that of a block, and each block behind the number of its packed
// bytes. All numbers are big-endian. A block that did not get shorter is not packed.
bool unpackLz4Into(PackedBytes packed, UnpackedBytes to)
{
	constexpr std::size_t kHead = 12;
	if (packed.size() < kHead || numberAt<std::uint64_t>(packed.data(), ByteOrder::big) != to.size())
		return false;
	const std::uint64_t block = numberAt<std::uint32_t>(packed.data() + 8, ByteOrder::big);
	packed = packed.subspan(kHead);
	while (!to.empty())
	{
		const std::size_t wanted = std::min<std::uint64_t>(block, to.size());
		if (wanted == 0 || packed.size() < 4)
			return false;
		const std::uint64_t bytes = numberAt<std::uint32_t>(packed.data(), ByteOrder::big);
		packed = packed.subspan(4);
		if (bytes > packed.size() || wanted > LZ4_MAX_INPUT_SIZE || bytes > LZ4_MAX_INPUT_SIZE)
			return false;
		if (bytes == wanted)
			std::memcpy(to.data(), packed.data(), wanted);
		else if (LZ4_decompress_safe(reinterpret_cast<const char*>(packed.data()), reinterpret_cast<char*>(to.data()),
		                             static_cast<int>(bytes), static_cast<int>(wanted)) != static_cast<int>(wanted))
			return false;
		packed = packed.subspan(bytes);
		to = to.subspan(wanted);
	}
	return packed.empty();
}

// Fletcher's checksum as HDF5 computes it (H5_checksum_fletcher32): over words of two bytes, the first one higher.
std::uint32_t fletcher32(PackedBytes bytes)
{
	std::uint32_t sum1 = 0;
	std::uint32_t sum2 = 0;
	const auto fold = [](std::uint32_t sum) { return (sum & 0xFFFF) + (sum >> 16); };
	std::size_t at = 0;
	for (std::size_t words = bytes.size() / 2; words > 0;)
	{
		const std::size_t some = std::min<std::size_t>(words, 360); // so many do not overflow
		words -= some;
		for (std::size_t i = 0; i < some; ++i, at += 2)
		{
			sum1 += static_cast<std::uint32_t>(bytes[at]) << 8 | static_cast<std::uint32_t>(bytes[at + 1]);
			sum2 += sum1;
		}
		sum1 = fold(sum1);
		sum2 = fold(sum2);
	}
	if (bytes.size() % 2 != 0)
	{
		sum1 += static_cast<std::uint32_t>(bytes[at]) << 8;
		sum2 += sum1;
		sum1 = fold(sum1);
		sum2 = fold(sum2);
	}
	return fold(sum2) << 16 | fold(sum1);
}

// HDF5 stores the checksum with its lowest byte first; files of before 1.6.3 have the bytes of each half changed.
bool checkFletcher(PackedBytes packed, UnpackedBytes to)
{
	if (packed.size() != to.size() + kChecksumBytes)
		return false;
	const auto stored = numberAt<std::uint32_t>(packed.data() + to.size());
	const std::uint32_t sum = fletcher32(packed.first(to.size()));
	const std::uint32_t turned = (sum & 0x00FF00FF) << 8 | (sum >> 8 & 0x00FF00FF);
	std::memcpy(to.data(), packed.data(), to.size());
	return stored == sum || stored == turned;
}

} // namespace

std::optional<Filters> Filters::of(hid_t properties)
{
	Filters filters;
	const int count = H5Pget_nfilters(properties);
	for (int i = 0; i < count; ++i)
	{
		std::array<unsigned, 16> values = {};
		std::size_t value_count = values.size();
		unsigned flags = 0;
		unsigned about = 0;
		const H5Z_filter_t number = H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &value_count,
		                                           values.data(), 0, nullptr, &about);
		const auto known = std::ranges::find(kFilters, number, [](const auto& filter) { return filter.first; });
		if (known == kFilters.end())
			return std::nullopt;
		const bool shuffles = number == H5Z_FILTER_SHUFFLE;
		if (shuffles && (value_count < 1 || values[0] == 0))
			return std::nullopt;
		filters.steps_.push_back({known->second, shuffles ? values[0] : 0});
	}
	return count < 0 ? std::nullopt : std::optional(std::move(filters));
}

Filters::Filters(const std::string& text)
{
	std::istringstream words(text);
	for (std::string word; words >> word;)
	{
		Step step{word.substr(0, word.find(':'))};
		if (const std::size_t colon = word.find(':'); colon != word.npos)
			std::from_chars(word.data() + colon + 1, word.data() + word.size(), step.width);
		const auto isThis = [&](const auto& filter) { return step.name == filter.second; };
		if (std::ranges::none_of(kFilters, isThis) || (step.name == "shuffle" && step.width == 0))
			throw Refusal(fmt::format("its parts are packed by {}, which is not known", word));
		steps_.push_back(std::move(step));
	}
}

std::string Filters::text() const
{
	std::string text;
	for (const Step& step : steps_)
		text +=
		    fmt::format("{}{}{}", text.empty() ? "" : " ", step.name, step.width ? fmt::format(":{}", step.width) : "");
	return text;
}

void Filters::unpack(PackedBytes packed, std::uint32_t left_out, UnpackedBytes to) const
{
	const auto isUsed = [&](std::size_t i) { return (left_out >> i & 1) == 0; };
	// How many bytes a step was given; 0 if a step before it has packed them.
	std::vector<std::size_t> given(steps_.size());
	std::size_t size = to.size();
	for (std::size_t i = 0; i < steps_.size(); ++i)
	{
		given[i] = size;
		if (isUsed(i) && size > 0)
			size = steps_[i].name == "shuffle" ? size : steps_[i].name == "fletcher32" ? size + kChecksumBytes : 0;
	}
	std::vector<std::byte> before(packed.begin(), packed.end());
	std::vector<std::byte> after;
	for (std::size_t i = steps_.size(); i-- > 0;)
		if (isUsed(i))
		{
			const std::string& name = steps_[i].name;
			after.resize(name == "shuffle"      ? before.size()
			             : name == "fletcher32" ? before.size() - std::min(before.size(), kChecksumBytes)
			                                    : given[i]);
			if (!undo(steps_[i], before, after))
				throw damaged(fmt::format("a part cannot be unpacked ({})", name));
			std::swap(before, after);
		}
	if (before.size() != to.size())
		throw damaged(fmt::format("a part has {} bytes where {} are wanted", before.size(), to.size()));
	std::ranges::copy(before, to.begin());
}

bool Filters::undo(const Step& step, PackedBytes packed, UnpackedBytes to)
{
	if (step.name == "shuffle")
		return arrays::unshuffle(packed, to, step.width);
	if (step.name == "fletcher32")
		return checkFletcher(packed, to);
	if (step.name == "deflate")
		return arrays::inflateZlib(packed, to);
	if (step.name == "blosc")
		return arrays::unpackBlosc(packed, to);
	if (step.name == "lz4")
		return unpackLz4Into(packed, to);
	return ZSTD_decompress(to.data(), to.size(), packed.data(), packed.size()) == to.size();
}

} // namespace vp::reader::hdf5
