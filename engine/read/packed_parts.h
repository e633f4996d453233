#pragma once

#include "base/array.h"
#include "parts/file_extents.h"
#include "read/unpacker.h"

#include <memory>
#include <string>
#include <vector>

namespace vp::read
{

// Parts that are packed in a file. A reader child unpacks them, since libraries look at a file's bytes in its sandbox
// alone. Any thread may use it.
class PackedParts : public parts::Source
{
public:
	// The parts as the file describes them. The parent looks at nothing but where they lie.
	struct Place
	{
		Array<std::uint64_t> offsets{}; // parts::FileExtents::kMissing for a part that was never written
		Array<std::uint64_t> sizes{};
		Array<std::uint64_t> left_out_filters{};
		std::string filters{};
		std::vector<std::byte> fill{}; // an item that stands for those of a part that was never written
		std::size_t number_bytes = 1;
		bool swaps = false;
		// If it is not empty, the reader finds each part by its number, and nothing above is known of it.
		std::string reader{};
	};

	PackedParts(std::shared_ptr<const parts::OpenFile> file, const parts::Layout& layout, Place place);

	// Returns true if there is a program that finds parts so.
	static bool knows(const std::string& reader);
	// Returns true if all parts lie within a file of this size.
	static bool fits(const parts::Layout& layout, const Place& place, std::uint64_t file_size);

	// A call takes as long as to unpack some 100 KB.
	std::size_t bytesAtOnce() const override { return std::size_t(64) << 20; }
	std::size_t bytesAhead() const override { return std::size_t(2) << 20; }
	void announce(std::span<const std::uint64_t> numbers) const override;
	void read(std::span<const parts::Wanted> wanted) const override;

private:
	std::shared_ptr<const parts::OpenFile> file_;
	Place place_;
	mutable Unpacker unpacker_;
};

} // namespace vp::read
