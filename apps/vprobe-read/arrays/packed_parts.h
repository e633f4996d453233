#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace vp::reader::arrays
{

// A part of an array that stays in its file.
struct PackedPart
{
	std::uint64_t offset; // or the number of the part, where the reader finds it
	std::uint64_t bytes;
	std::uint64_t left_out_filters;
};

// Any thread may call it. Throws a Refusal.
using UnpackPart = std::function<void(const PackedPart& part, std::span<std::byte> to)>;

// how: the filters or the reader of a StoredPlace. file: where the parts lie, or the folder of the reader's array. Only
// vprobe-read-more has this (formats/volumes/packed_parts.cpp), since some parts are unpacked by their format's reader.
UnpackPart unpackerOf(const std::string& file, const std::string& how);

} // namespace vp::reader::arrays
