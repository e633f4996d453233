#pragma once

#include "grid/field.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

// Writes arrays one after the other into a shared memory the parent gave, and describes each for the manifest.
class ArrayWriter
{
public:
	explicit ArrayWriter(int memory) : memory_(memory) {}

	nlohmann::json write(vp::grid::NumberType type, const void* data, std::size_t bytes);

	// The same in pieces, for arrays that are converted on the way.
	void begin();
	void append(const void* data, std::size_t bytes);
	nlohmann::json end(vp::grid::NumberType type);

private:
	int memory_; // a file descriptor
	std::size_t start_ = 0;
	std::size_t position_ = 0;
};

nlohmann::json writeInt64(ArrayWriter& writer, std::span<const std::int32_t> values);
nlohmann::json writeInt64(ArrayWriter& writer, std::span<const std::int64_t> values);
