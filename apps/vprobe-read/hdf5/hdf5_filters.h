#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::hdf5
{

// The filters that packed the chunks of a data set, undone without HDF5: it would do one chunk at a time, and knows
// fewer of them.
class Filters
{
public:
	// Returns nothing for a filter that is not known here. properties: of the data set's creation.
	static std::optional<Filters> of(hid_t properties);
	// Reads what text() has written. Throws a Refusal.
	explicit Filters(const std::string& text);

	bool isEmpty() const { return steps_.empty(); }
	// "shuffle:4 deflate", in the order in which they were done.
	std::string text() const;
	// Unpacks a chunk. left_out: bit n is set if it was not packed by filter n. Throws a Refusal unless it gives
	// exactly as many bytes as `to` has.
	void unpack(std::span<const std::byte> packed, std::uint32_t left_out, std::span<std::byte> to) const;

private:
	struct Step
	{
		std::string name;
		std::size_t width = 0; // bytes of an element that is shuffled
	};
	Filters() = default;
	static bool undo(const Step& step, std::span<const std::byte> packed, std::span<std::byte> to);

	std::vector<Step> steps_;
};

} // namespace vp::reader::hdf5
