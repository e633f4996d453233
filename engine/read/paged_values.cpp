#include "read/paged_values.h"

#include "parts/part_bytes.h"

#include <algorithm>
#include <bit>

namespace vp::read
{

namespace
{

constexpr std::size_t kPageBytes = 4096;
constexpr std::uint64_t kMostAtOnce = std::uint64_t(1) << 20; // one thread reads so many bytes, or fewer
// If more than this share of an array is wanted, all of it is read.
constexpr double kMuch = 0.4;

} // namespace

PagedValues::PagedValues(std::shared_ptr<const parts::OpenFile> file, const Place& place)
    : file_(std::move(file)), place_(place),
      row_bits_(static_cast<unsigned>(std::bit_width(std::max<std::size_t>(kPageBytes / place.row_bytes, 1)) - 1)),
      memory_(std::make_shared<SparseMemory>(place.rows * place.row_bytes))
{
	wanted_.resize((place.rows + (std::uint64_t(1) << row_bits_) - 1) >> row_bits_);
	there_.resize(wanted_.size());
}

// Returns the bytes of the pages for which isIn(PAGE) holds; those that follow each other are together.
template <class IsIn>
std::vector<PagedValues::Extent> PagedValues::extentsOf(const IsIn& isIn) const
{
	const std::uint64_t page_bytes = std::uint64_t(place_.row_bytes) << row_bits_;
	const std::uint64_t most_pages = std::max<std::uint64_t>(kMostAtOnce / page_bytes, 1);
	std::vector<Extent> extents;
	for (std::uint64_t page = 0; page < wanted_.size(); ++page)
	{
		const std::uint64_t first = page;
		while (page < wanted_.size() && page - first < most_pages && isIn(page))
			++page;
		if (page == first)
			continue;
		extents.emplace_back(first * page_bytes, std::min(page * page_bytes, bytes()));
		--page;
	}
	return extents;
}

std::vector<PagedValues::Extent> PagedValues::missing() const
{
	const auto count = static_cast<double>(std::ranges::count(wanted_, true));
	const bool takes_all = count > kMuch * static_cast<double>(wanted_.size());
	return extentsOf([&](std::uint64_t page) { return (takes_all || wanted_[page]) && !there_[page]; });
}

std::vector<PagedValues::Extent> PagedValues::wanted() const
{
	return extentsOf([this](std::uint64_t page) { return wanted_[page]; });
}

void PagedValues::note(std::span<const Extent> extents)
{
	const std::uint64_t page_bytes = std::uint64_t(place_.row_bytes) << row_bits_;
	for (const auto& [begin, end] : extents)
	{
		bytes_there_ += end - begin;
		for (std::uint64_t at = begin; at < end; at += page_bytes)
			there_[at / page_bytes] = true;
	}
}

void PagedValues::announce(std::span<const Extent> extents, std::uint64_t offset) const
{
	std::vector<parts::OpenFile::Extent> of_file;
	for (const auto& [begin, end] : extents)
		of_file.emplace_back(offset + begin, offset + end);
	file_->announce(std::move(of_file));
}

void PagedValues::read(const Extent& extent) const
{
	const std::span<std::byte> bytes(memory_->data() + extent.first, memory_->data() + extent.second);
	file_->read(place_.offset + extent.first, bytes);
	if (place_.swapped_bytes > 1)
		parts::swapNumbers(bytes, place_.swapped_bytes);
}

} // namespace vp::read
