#pragma once

#include "vprobe-read/text/text_cursor.h"

#include <cstddef>
#include <cstdint>

namespace vp::reader::meshes
{

// Numbers of one section of a Gmsh file, in text or binary.
class GmshSection
{
public:
	using Tag = std::int64_t;

	// `narrow`: the program that wrote the file counts in 32 bits.
	GmshSection(text::Cursor& at, bool binary, bool narrow) : at_(at), binary_(binary), narrow_(narrow) {}

	// 32 bits in a binary file.
	Tag integer() { return binary_ ? at_.binary<std::int32_t>() : at_.integer(); }
	// 64 bits, mostly.
	Tag size() { return !binary_ ? at_.integer() : narrow_ ? at_.binary<std::uint32_t>() : at_.binary<std::int64_t>(); }
	double real() { return binary_ ? at_.binary<double>() : at_.real(); }
	std::size_t checked(Tag count, std::size_t least_bytes) const { return at_.checkedCount(count, least_bytes); }
	bool binary() const { return binary_; }

private:
	text::Cursor& at_;
	bool binary_;
	bool narrow_;
};

} // namespace vp::reader::meshes
