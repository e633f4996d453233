#pragma once

#include "base/raw_vector.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace vp::parts
{

using PartBytes = RawVector<std::byte>;

/// The parts in memory, of all arrays of this process, up to a number of bytes. What was used least recently goes
/// first. A part that somebody holds stays until he lets it go. Any thread may use it.
class KeptParts
{
public:
	struct Key
	{
		std::uint64_t store; // number of a PartStore
		std::uint64_t part;

		bool operator==(const Key&) const = default;
	};

	static KeptParts& ofProcess();

	/// Returns half of the memory that the system says is free, at least 64 MiB.
	static std::uint64_t halfOfFreeMemory();

	std::uint64_t budget() const;
	/// Sets the largest number of bytes. Parts beyond it go at once.
	void setBudget(std::uint64_t bytes);

	/// Returns a part, or null if it is not in memory.
	std::shared_ptr<const PartBytes> find(const Key& key);
	bool holds(const Key& key) const;
	void keep(const Key& key, std::shared_ptr<const PartBytes> bytes);
	/// Lets all parts of a store go.
	void forget(std::uint64_t store);
	std::uint64_t bytes() const;
	/// Returns how many parts of a store are in memory.
	std::uint64_t countOf(std::uint64_t store) const;

private:
	struct Entry
	{
		Key key;
		std::shared_ptr<const PartBytes> bytes;
	};
	struct Hash
	{
		std::size_t operator()(const Key& key) const
		{
			return static_cast<std::size_t>((key.part + key.store * 0x9E3779B97F4A7C15u) * 0xD6E8FEB86659FD93u);
		}
	};
	void shrink();

	mutable std::mutex mutex_;
	std::uint64_t budget_ = halfOfFreeMemory();
	std::uint64_t bytes_ = 0;
	std::list<Entry> entries_; // the one that was used last comes first
	std::unordered_map<Key, std::list<Entry>::iterator, Hash> by_key_;
};

} // namespace vp::parts
