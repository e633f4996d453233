#pragma once

#include "parts/kept_parts.h"
#include "parts/layout.h"
#include "parts/source.h"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace vp::parts
{

/// Counts what was read of an array, or of several, since somebody began to count.
struct PartUse
{
	std::uint64_t all = 0;  // parts there are
	std::uint64_t kept = 0; // parts in memory now
	std::uint64_t met = 0;  // parts that were asked for, each once
	std::uint64_t read = 0; // parts that were read, each as often as it was read
	std::uint64_t bytes_met = 0;
	std::uint64_t bytes_read = 0;

	void include(const PartUse& other);
};

/// An array whose values stay in a file until somebody asks for them. Then the part that holds them is read and kept
/// (KeptParts). Every value can be asked for, so nothing is wrong where nobody has asked in advance; it is only slow.
/// Any thread may use it.
class PartStore
{
public:
	PartStore(const Layout& layout, std::unique_ptr<const Source> source);
	~PartStore();
	PartStore(const PartStore&) = delete;
	PartStore& operator=(const PartStore&) = delete;

	const Layout& layout() const { return layout_; }

	/// Returns the bytes of an item, which stay valid until this thread has asked for items of kRecent other parts.
	/// Reads the part if it is not kept. Throws Unreadable.
	const std::byte* item(std::uint64_t index) const;

	/// Collects which parts hold some items. Several threads may add to it.
	class Needs
	{
	public:
		explicit Needs(const PartStore& store) : store_(store), marks_(store.layout_.partCount()) {}
		void add(std::uint64_t item);

	private:
		friend class PartStore;
		const PartStore& store_;
		std::vector<std::atomic<bool>> marks_;
	};

	/// Reads the parts that are needed and not kept, on all cores, in the order of the file. Does nothing if they take
	/// more memory than there is for parts: item() then reads each where it is used. Throws Unreadable, or Stopped
	/// (stoppable.h).
	void fetch(const Needs& needs) const;

	/// Visits every item of the array, part by part, on several threads. visit(first, bytes, count): `count` items from
	/// number `first` on lie one after the other. Parts that are read for this are not kept. Skips the rest soon after
	/// isEnough() is true. Throws Unreadable.
	using Visit = std::function<void(std::uint64_t first, const std::byte* bytes, std::size_t count)>;
	void forEachRun(const Visit& visit, const std::function<bool()>& isEnough = {}) const;

	/// Returns what was used since the last call of startCounting().
	PartUse use() const;
	void startCounting() const;

	static constexpr std::size_t kRecent = 16;

private:
	struct Place
	{
		std::uint64_t part;
		std::size_t item; // within the part
	};
	Place placeOf(std::uint64_t index) const;
	std::shared_ptr<const PartBytes> partOf(std::uint64_t number) const;
	std::shared_ptr<const PartBytes> readPart(std::uint64_t number) const;
	// Returns the first of them, which may have gone again from what is kept.
	std::shared_ptr<const PartBytes> readSeveral(const std::vector<std::uint64_t>& numbers) const;
	void noteMet(std::uint64_t number) const;
	void noteRead(std::uint64_t parts, std::uint64_t bytes) const;

	const std::uint64_t number_; // differs from that of every other store
	Layout layout_;
	std::array<std::uint64_t, 3> parts_along_;
	std::unique_ptr<const Source> source_;
	mutable std::vector<std::atomic<bool>> met_; // per part
	mutable std::atomic<std::uint64_t> read_ = 0;
	mutable std::atomic<std::uint64_t> bytes_read_ = 0;
};

} // namespace vp::parts
