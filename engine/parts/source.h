#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace vp::parts
{

/// A part cannot be read: the file was cut short, replaced in place, or its disk failed. The text is one line for the
/// user, which names the file.
class Unreadable : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

/// A part to read, and where its bytes go.
struct Wanted
{
	std::uint64_t number;
	std::span<std::byte> bytes;
};

/// Where the parts of an array come from. Any thread may use it.
class Source
{
public:
	virtual ~Source() = default;

	/// Returns how many bytes one call of read() should be asked for.
	virtual std::size_t bytesAtOnce() const { return std::size_t(4) << 20; }
	/// Returns how many bytes should be read if one part is asked for that nobody has announced, since a call takes
	/// long. 0: the part alone.
	virtual std::size_t bytesAhead() const { return 0; }
	/// Tells the system that these parts will be read soon. They are in ascending order.
	virtual void announce(std::span<const std::uint64_t> numbers) const = 0;
	/// Reads parts, which are in ascending order. Throws Unreadable.
	virtual void read(std::span<const Wanted> wanted) const = 0;
};

} // namespace vp::parts
