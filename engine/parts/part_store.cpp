#include "parts/part_store.h"

#include "base/bytes_read.h"
#include "base/parallel_for.h"
#include "parts/stoppable.h"

#include <tbb/blocked_range.h>

#include <algorithm>

namespace vp::parts
{

namespace
{

// Some 20 ms of reading from a disk. Less would leave cores idle between.
constexpr std::size_t kBytesBetweenStops = std::size_t(32) << 20;

std::uint64_t nextNumber()
{
	static std::atomic<std::uint64_t> number = 0;
	return ++number;
}

// A part that a thread asked for lately, which spares it the lock of KeptParts.
struct Recent
{
	std::uint64_t store = 0;
	std::uint64_t part = 0;
	std::shared_ptr<const PartBytes> bytes;
};

thread_local std::array<Recent, PartStore::kRecent> recent_parts;

std::size_t bytesOfAll(const Layout& layout, std::span<const std::uint64_t> numbers)
{
	std::size_t sum = 0;
	for (const std::uint64_t number : numbers)
		sum += layout.bytesOf(number);
	return sum;
}

std::uint64_t partsAtOnce(const Source& source, const Layout& layout)
{
	return std::max<std::uint64_t>(source.bytesAtOnce() / layout.bytesOf(0), 1);
}

// Calls act(some) for ranges of `most` numbers or fewer that together are 0 to count, on all cores.
template <class Act>
void forGroups(std::uint64_t count, std::uint64_t most, const Act& act)
{
	tracedFor(std::uint64_t(0), (count + most - 1) / most,
	          [&](std::uint64_t group)
	          { act(tbb::blocked_range<std::uint64_t>(group * most, std::min((group + 1) * most, count))); });
}

} // namespace

void PartUse::include(const PartUse& other)
{
	all += other.all;
	kept += other.kept;
	met += other.met;
	read += other.read;
	bytes_met += other.bytes_met;
	bytes_read += other.bytes_read;
}

PartStore::PartStore(const Layout& layout, std::unique_ptr<const Source> source)
    : number_(nextNumber()),
      layout_(layout), parts_along_{layout.partsAlong(0), layout.partsAlong(1), layout.partsAlong(2)},
      source_(std::move(source)), met_(layout.partCount())
{
}

PartStore::~PartStore()
{
	KeptParts::ofProcess().forget(number_);
}

PartStore::Place PartStore::placeOf(std::uint64_t index) const
{
	const std::uint64_t row = index / layout_.items[0];
	const std::uint64_t i = index - row * layout_.items[0];
	const std::uint64_t k = row / layout_.items[1];
	const std::uint64_t j = row - k * layout_.items[1];
	const std::array<std::uint64_t, 3> part{i / layout_.part[0], j / layout_.part[1], k / layout_.part[2]};
	const std::uint64_t number = (part[2] * parts_along_[1] + part[1]) * parts_along_[0] + part[0];
	// A part that is cut short has whole rows, and fewer rows only in its last layer.
	const std::uint64_t rows =
	    layout_.is_padded ? layout_.part[1] : std::min(layout_.part[1], layout_.items[1] - part[1] * layout_.part[1]);
	const std::uint64_t within =
	    ((k - part[2] * layout_.part[2]) * rows + (j - part[1] * layout_.part[1])) * layout_.part[0] +
	    (i - part[0] * layout_.part[0]);
	return {number, static_cast<std::size_t>(within)};
}

const std::byte* PartStore::item(std::uint64_t index) const
{
	const Place place = placeOf(index);
	Recent& recent = recent_parts[(place.part * 0x9E3779B97F4A7C15u) >> 60];
	static_assert(kRecent == 16, "the four highest bits choose");
	if (recent.part != place.part || recent.store != number_)
		recent = {number_, place.part, partOf(place.part)};
	return recent.bytes->data() + place.item * layout_.item_bytes;
}

std::shared_ptr<const PartBytes> PartStore::partOf(std::uint64_t number) const
{
	noteMet(number);
	KeptParts& kept = KeptParts::ofProcess();
	std::shared_ptr<const PartBytes> bytes = kept.find({number_, number});
	if (bytes)
		return bytes;
	// So that whoever looks at one item after the other does not call for each part.
	const std::size_t ahead = std::min<std::uint64_t>(source_->bytesAhead(), kept.budget() / 4);
	std::vector<std::uint64_t> numbers;
	for (std::uint64_t n = number + 1; n < layout_.partCount() && numbers.size() < ahead / layout_.bytesOf(0); ++n)
		if (!kept.holds({number_, n}))
			numbers.push_back(n);
	if (numbers.empty())
		bytes = readPart(number);
	else
	{
		numbers.insert(numbers.begin(), number);
		bytes = readSeveral(numbers);
	}
	kept.keep({number_, number}, bytes);
	return bytes;
}

std::shared_ptr<const PartBytes> PartStore::readPart(std::uint64_t number) const
{
	const auto bytes = std::make_shared<PartBytes>(layout_.bytesOf(number));
	const Wanted wanted{number, *bytes};
	source_->read({&wanted, 1});
	noteRead(1, bytes->size());
	return bytes;
}

std::shared_ptr<const PartBytes> PartStore::readSeveral(const std::vector<std::uint64_t>& numbers) const
{
	source_->announce(numbers);
	std::shared_ptr<const PartBytes> first;
	const auto read = [&](const tbb::blocked_range<std::uint64_t>& some)
	{
		std::vector<std::shared_ptr<PartBytes>> parts;
		std::vector<Wanted> wanted;
		std::uint64_t sum = 0;
		for (std::size_t i = some.begin(); i < some.end(); ++i)
		{
			parts.push_back(std::make_shared<PartBytes>(layout_.bytesOf(numbers[i])));
			wanted.push_back({numbers[i], *parts.back()});
			sum += parts.back()->size();
		}
		source_->read(wanted);
		noteRead(parts.size(), sum);
		if (some.begin() == 0)
			first = parts[0];
		for (std::size_t i = 0; i < parts.size(); ++i)
			KeptParts::ofProcess().keep({number_, wanted[i].number}, std::move(parts[i]));
	};
	forGroups(numbers.size(), partsAtOnce(*source_, layout_), read);
	return first;
}

void PartStore::Needs::add(std::uint64_t item)
{
	std::atomic<bool>& mark = marks_[store_.placeOf(item).part];
	if (!mark.load(std::memory_order_relaxed)) // most are marked already, and a write would take the line from others
		mark.store(true, std::memory_order_relaxed);
}

void PartStore::fetch(const Needs& needs) const
{
	std::vector<std::uint64_t> missing;
	for (std::uint64_t number = 0; number < needs.marks_.size(); ++number)
		if (needs.marks_[number].load(std::memory_order_relaxed))
		{
			noteMet(number);
			if (!KeptParts::ofProcess().holds({number_, number}))
				missing.push_back(number);
		}
	// More would push out the first of them before anybody has looked at it.
	if (missing.empty() || bytesOfAll(layout_, missing) > KeptParts::ofProcess().budget())
		return;
	const std::stop_token& stop = Stoppable::current();
	if (!stop.stop_possible())
	{
		readSeveral(missing);
		return;
	}
	const std::size_t some = std::max<std::size_t>(kBytesBetweenStops / layout_.bytesOf(0), 1);
	for (std::size_t begin = 0; begin < missing.size(); begin += some)
	{
		if (stop.stop_requested())
			throw Stopped();
		const auto first = missing.begin() + static_cast<std::ptrdiff_t>(begin);
		readSeveral({first, first + static_cast<std::ptrdiff_t>(std::min(some, missing.size() - begin))});
	}
}

void PartStore::forEachRun(const Visit& visit, const std::function<bool()>& isEnough) const
{
	const auto visitPart = [&](std::uint64_t number, const PartBytes& bytes)
	{
		const auto first = layout_.firstOf(number);
		const auto held = layout_.itemsOf(number);
		const std::uint64_t rows = layout_.is_padded ? layout_.part[1] : held[1];
		for (std::uint64_t k = 0; k < held[2]; ++k)
			for (std::uint64_t j = 0; j < held[1]; ++j)
			{
				const std::uint64_t row = (first[2] + k) * layout_.items[1] + first[1] + j;
				visit(row * layout_.items[0] + first[0],
				      bytes.data() + (k * rows + j) * layout_.part[0] * layout_.item_bytes,
				      static_cast<std::size_t>(held[0]));
			}
	};
	const auto visitSome = [&](const tbb::blocked_range<std::uint64_t>& some)
	{
		if (isEnough && isEnough())
			return;
		std::vector<std::uint64_t> numbers;
		for (std::uint64_t number = some.begin(); number < some.end(); ++number)
			if (const auto kept = KeptParts::ofProcess().find({number_, number}))
				visitPart(number, *kept);
			else
				numbers.push_back(number);
		std::vector<PartBytes> parts;
		std::vector<Wanted> wanted;
		std::uint64_t sum = 0;
		for (const std::uint64_t number : numbers)
			sum += parts.emplace_back(layout_.bytesOf(number)).size();
		for (std::size_t i = 0; i < parts.size(); ++i)
			wanted.push_back({numbers[i], parts[i]});
		source_->announce(numbers);
		source_->read(wanted);
		noteRead(parts.size(), sum);
		for (std::size_t i = 0; i < parts.size(); ++i)
			visitPart(numbers[i], parts[i]);
	};
	forGroups(layout_.partCount(), partsAtOnce(*source_, layout_), visitSome);
}

void PartStore::noteMet(std::uint64_t number) const
{
	met_[number].store(true, std::memory_order_relaxed);
}

void PartStore::noteRead(std::uint64_t parts, std::uint64_t bytes) const
{
	read_.fetch_add(parts, std::memory_order_relaxed);
	bytes_read_.fetch_add(bytes, std::memory_order_relaxed);
	bytesRead().fetch_add(bytes, std::memory_order_relaxed);
}

PartUse PartStore::use() const
{
	PartUse use;
	use.all = layout_.partCount();
	use.kept = KeptParts::ofProcess().countOf(number_);
	use.read = read_.load();
	use.bytes_read = bytes_read_.load();
	for (std::uint64_t number = 0; number < met_.size(); ++number)
		if (met_[number].load(std::memory_order_relaxed))
		{
			++use.met;
			use.bytes_met += layout_.bytesOf(number);
		}
	return use;
}

void PartStore::startCounting() const
{
	for (std::atomic<bool>& part : met_)
		part.store(false, std::memory_order_relaxed);
	read_ = 0;
	bytes_read_ = 0;
}

} // namespace vp::parts
