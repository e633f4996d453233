#include "parts/kept_parts.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace vp::parts
{

namespace
{

constexpr std::uint64_t kLeastBudget = 64 << 20;

} // namespace

KeptParts& KeptParts::ofProcess()
{
	static auto* const kept = new KeptParts; // never destroyed, since stores may outlive everything else
	return *kept;
}

std::uint64_t KeptParts::halfOfFreeMemory()
{
	std::ifstream about("/proc/meminfo");
	std::string name;
	std::uint64_t kibibytes = 0;
	for (std::string rest; about >> name >> kibibytes && name != "MemAvailable:"; std::getline(about, rest))
		kibibytes = 0;
	return std::max(kibibytes * 1024 / 2, kLeastBudget);
}

std::uint64_t KeptParts::budget() const
{
	const std::lock_guard lock(mutex_);
	return budget_;
}

void KeptParts::setBudget(std::uint64_t bytes)
{
	const std::lock_guard lock(mutex_);
	budget_ = bytes;
	shrink();
}

std::shared_ptr<const PartBytes> KeptParts::find(const Key& key)
{
	const std::lock_guard lock(mutex_);
	const auto found = by_key_.find(key);
	if (found == by_key_.end())
		return nullptr;
	entries_.splice(entries_.begin(), entries_, found->second);
	return found->second->bytes;
}

bool KeptParts::holds(const Key& key) const
{
	const std::lock_guard lock(mutex_);
	return by_key_.contains(key);
}

void KeptParts::keep(const Key& key, std::shared_ptr<const PartBytes> bytes)
{
	const std::lock_guard lock(mutex_);
	if (by_key_.contains(key)) // another thread has read it too
		return;
	bytes_ += bytes->size();
	entries_.push_front({key, std::move(bytes)});
	by_key_.emplace(key, entries_.begin());
	shrink();
}

void KeptParts::forget(std::uint64_t store)
{
	const std::lock_guard lock(mutex_);
	for (auto at = entries_.begin(); at != entries_.end();)
	{
		const auto entry = at++;
		if (entry->key.store != store)
			continue;
		bytes_ -= entry->bytes->size();
		by_key_.erase(entry->key);
		entries_.erase(entry);
	}
}

std::uint64_t KeptParts::bytes() const
{
	const std::lock_guard lock(mutex_);
	return bytes_;
}

std::uint64_t KeptParts::countOf(std::uint64_t store) const
{
	const std::lock_guard lock(mutex_);
	return static_cast<std::uint64_t>(
	    std::ranges::count_if(entries_, [&](const Entry& entry) { return entry.key.store == store; }));
}

void KeptParts::shrink()
{
	while (bytes_ > budget_ && !entries_.empty())
	{
		bytes_ -= entries_.back().bytes->size();
		by_key_.erase(entries_.back().key);
		entries_.pop_back();
	}
}

} // namespace vp::parts
