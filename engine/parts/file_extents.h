#pragma once

#include "base/array.h"
#include "parts/layout.h"
#include "parts/source.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vp::parts
{

/// A file that stays open. What is read from it is what it held when it was opened, unless it is written in place.
class OpenFile
{
public:
	/// Throws Unreadable if the file cannot be opened, or is no regular file.
	explicit OpenFile(std::string name);
	~OpenFile();
	OpenFile(const OpenFile&) = delete;
	OpenFile& operator=(const OpenFile&) = delete;

	const std::string& name() const { return name_; }
	std::uint64_t size() const { return size_; }
	int descriptor() const { return descriptor_; }
	/// Reads so many bytes. Any thread may call it. Throws Unreadable if they are not there.
	void read(std::uint64_t offset, std::span<std::byte> to) const;
	/// Asks the system for extents that will be read: bytes from the first on to before the second, in any order.
	using Extent = std::pair<std::uint64_t, std::uint64_t>;
	void announce(std::vector<Extent> extents) const;
	/// Returns true if the name still leads to this file, and nobody has written to it.
	bool isThereStill() const;

private:
	std::string name_;
	int descriptor_ = -1;
	std::uint64_t size_ = 0;
	std::array<std::uint64_t, 4> stamp_{}; // device, number, and time of the last change
};

/// Parts that lie in a file as they are, one number after the other.
class FileExtents : public Source
{
public:
	static constexpr std::uint64_t kMissing = ~std::uint64_t(0);

	/// The place of the bytes in the file.
	struct Place
	{
		std::uint64_t offset = 0;       // the array begins here, if it is in one piece
		Array<std::uint64_t> offsets{}; // else of each part; kMissing for one that was never written
		std::vector<std::byte> fill{};  // an item that stands for those of such a part, as in the file
		std::size_t number_bytes = 1;   // width of a number; an item has one or several
		bool swaps = false;             // whether their bytes are in the other order
	};

	/// The caller has checked that the parts lie within the file (fits()).
	FileExtents(std::shared_ptr<const OpenFile> file, const Layout& layout, Place place);

	/// Returns true if all parts lie within a file of this size. Parts of an array in one piece must hold whole rows,
	/// and several rows only of one layer.
	static bool fits(const Layout& layout, const Place& place, std::uint64_t file_size);

	void announce(std::span<const std::uint64_t> numbers) const override;
	void read(std::span<const Wanted> wanted) const override;

private:
	std::uint64_t offsetOf(std::uint64_t number) const;
	void readRun(std::span<const Wanted> run) const;

	std::shared_ptr<const OpenFile> file_;
	Layout layout_;
	Place place_;
};

} // namespace vp::parts
