#pragma once

#include "grid/field.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::reader::arrays
{

// Writes arrays one after the other into a shared memory the parent gave, and describes each for the manifest.
class Writer
{
public:
	explicit Writer(int memory) : memory_(memory) {}

	nlohmann::json write(grid::NumberType type, const void* data, std::size_t bytes);

	// These write an array in pieces, for arrays that are converted on the way.
	void begin();
	void append(const void* data, std::size_t bytes);
	nlohmann::json end(grid::NumberType type);

	// Reserves room for an array. Any thread may put its bytes there, in any order.
	std::size_t reserve(std::size_t bytes);
	void put(std::size_t at, const void* data, std::size_t bytes) const;
	static nlohmann::json describe(grid::NumberType type, std::size_t at, std::size_t bytes);
	// mark() returns the end of the last array. rewind() drops everything that was written behind a mark.
	std::size_t mark() const { return position_; }
	void rewind(std::size_t mark);

private:
	int memory_; // a file descriptor
	std::size_t start_ = 0;
	std::size_t position_ = 0;
};

nlohmann::json writeInt64(Writer& writer, std::span<const std::int32_t> values);
nlohmann::json writeInt64(Writer& writer, std::span<const std::uint32_t> values);
nlohmann::json writeInt64(Writer& writer, std::span<const std::int64_t> values);
// Writes ids with 32 bits if all of them fit, or else with 64 bits.
nlohmann::json writeIds(Writer& writer, std::span<const std::int32_t> ids);
nlohmann::json writeIds(Writer& writer, std::span<const std::int64_t> ids);

} // namespace vp::reader::arrays
